#include "identify/command_line/program.h"

#include "analysis/text/diagnostics.h"
#include "analysis/text/nearest.h"
#include "identify/command_line/command_table.h"
#include "identify/command_line/common_options.h"
#include "identify/command_line/completion.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/file_kind.h"
#include "identify/command_line/finding_list.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/manual_page.h"
#include "identify/command_line/options.h"
#include "identify/command_line/print.h"
#include "identify/command_line/simulate_options.h"
#include "identify/command_line/whole_number.h"
#include "identify/refine/search_method_list.h"

namespace fourpost {
namespace {

constexpr const char* kAllTopics = "findings";

}  // namespace

Program::Program() {
  app_.set_version_flag("--version", FOURPOST_VERSION);
  app_.require_subcommand(1);
  app_.fallthrough();
  app_.footer(
      "`fourpost help COMMAND` lists the options of a command.\n"
      "`fourpost help ID` explains an error or a warning by the id in brackets at its end.");
  AddInit();
  AddInfo();
  AddCheck();
  AddParams();
  AddResponse();
  AddModes();
  AddSimulate();
  AddFit();
  AddPredict();
  AddReport();
  AddCompare();
  AddRank();
  AddCompletion();
  AddMan();
  AddHelp();
}

CLI::App* Program::Add(const char* name, const char* help, const char* examples, std::function<int()> run) {
  CLI::App* sub = app_.add_subcommand(name, help);
  sub->footer(std::string("Examples:\n") + examples);
  sub->callback([this, run = std::move(run)] { run_ = run; });
  return sub;
}

void Program::AddInit() {
  CLI::App* sub = Add("init", "Write a starter study: a vehicle, a recording that fits in a second, and comments",
                      "  fourpost init car\n  fourpost fit car/study.yaml -o run", [this] { return Run(init_); });
  sub->add_option("DIR", init_.folder, "Folder, new or empty")->required();
  sub->add_flag("--json", init_.json, "Print JSON: the folder and its files");
}

void Program::AddInfo() {
  CLI::App* sub =
      Add("info", "What a recording holds: channels, units, rate, spans, levels, clipping and gaps",
          "  fourpost info sweep.csv\n  fourpost info --json run1.mat run2.mat", [this] { return Run(info_); });
  sub->add_option("FILE", info_.files, "Recordings over time (.csv, .mat), stepped sines, static loads (.csv)")
      ->required();
  sub->add_flag("--json", info_.json, "Print JSON");
}

void Program::AddCheck() {
  CLI::App* sub = Add("check", "Check a vehicle file; show bodies, loads, rates, modes and what sensors see",
                      "  fourpost check car.urdf\n  fourpost check --resolved car.urdf > complete.urdf", [this] {
                        RequireVehicleFile(check_.model);
                        return Run(check_);
                      });
  sub->add_option("MODEL", check_.model, "Vehicle file (.urdf)")->required();
  CLI::Option* json = sub->add_flag("--json", check_.json, "Print JSON");
  sub->add_flag("--resolved", check_.resolved,
                "Print the file with every default of fp: tags filled in, meshes named for a file in this folder")
      ->excludes(json);
}

void Program::AddParams() {
  CLI::App* sub = Add("params", "Parameters of a vehicle file: values, bounds, priors and where they are used",
                      "  fourpost params car.urdf\n  fourpost params run/vehicle.urdf --json", [this] {
                        RequireVehicleFile(params_.model);
                        return Run(params_);
                      });
  sub->add_option("MODEL", params_.model, "Vehicle file (.urdf)")->required();
  sub->add_flag("--json", params_.json, "Print JSON, SI");
}

void Program::AddResponse() {
  AddOptions(*Add("response", "Response of a vehicle to the posts; of a study, compared with its recordings",
                  "  fourpost response car.urdf --mode heave --mode roll -o response\n"
                  "  fourpost response car.urdf --frequencies 0.5Hz:5Hz:20 --set k=20kN/m\n"
                  "  fourpost response study.yaml --engine full",
                  [this] { return Run(response_); }),
             response_);
}

void Program::AddModes() {
  AddOptions(*Add("modes", "Modes of a vehicle: poles, shapes, and what parameters make of them",
                  "  fourpost modes car.urdf\n  fourpost modes car.urdf --vary c_bump=200N*s/m:4000N*s/m:20 -o modes",
                  [this] { return Run(modes_); }),
             modes_);
}

void Program::AddSimulate() {
  AddOptions(*Add("simulate", "Time history of a vehicle on its posts, as CSV",
                  "  fourpost simulate car.urdf --sweep 0.5Hz:30Hz -o sweep.csv --chart sweep.svg\n"
                  "  fourpost simulate car.urdf --road B --speed 60km/h --noise 1% > road.csv",
                  [this] { return Run(simulate_); }),
             simulate_);
}

void Program::AddFit() {
  CLI::App* sub = Add("fit", "Fit a study's vehicle to the recordings",
                      "  fourpost fit study.yaml -o run\n  fourpost fit study.yaml -o run --resume", [this] {
                        RequireStudyFile(fit_.study);
                        return Run(fit_);
                      });
  sub->add_option("STUDY", fit_.study, "Study file (.yaml)")->required();
  sub->add_option("-o,--output", fit_.output,
                  "Folder for report.html, result.json, vehicle.urdf, archive.sqlite, and what the data make of the "
                  "model: response.csv and "
                  "response.svg, history.csv and history.svg; parameters.csv compares fitted values with the file's")
      ->required();
  sub->add_option("--seed", fit_.seed, "Seed of the search, in place of the study's")->check(WholeNumber("--seed"));
  sub->add_option("--threads", fit_.threads, "Evaluations at once, no influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--accept-unidentified", fit_.accept_unidentified,
                "Fit although data and priors leave combinations of parameters open");
  sub->add_flag("--accept-implausible", fit_.accept_implausible,
                "Fit although recordings show that their posts move otherwise than the study tells");
  sub->add_option("--profile", fit_.profile,
                  "Free parameters, separated by commas, or all: how the cost rises when each is held away from its "
                  "fitted value and the others are fitted anew")
      ->delimiter(',');
  sub->add_flag("--resume", fit_.resume,
                "Go on with a fit that was ended: refuse when vehicle, recordings, program, or settings that residuals "
                "depend on, have changed");
  sub->add_flag("--json", fit_.json, "Print result.json in place of tables");
}

void Program::AddPredict() {
  AddOptions(*Add("predict", "Predict another recording with a fitted vehicle, and tell how well",
                  "  fourpost predict run --recording sweep.csv\n"
                  "  fourpost predict run --recording warp.csv --mode warp --add-mass \"250 kg\" --at -0.6,0,0.4",
                  [this] {
                    RequireTable(predict_.recording);
                    return Run(predict_);
                  }),
             predict_);
}

void Program::AddReport() {
  CLI::App* sub = Add(
      "report", "Write the report of a fit anew, or one that compares fits: an HTML file that opens anywhere, offline",
      "  fourpost report run\n  fourpost report run/model1 run/model2 -o models.html", [this] { return Run(report_); });
  sub->add_option("RUN", report_.runs, "Folder that `fourpost fit -o` wrote; of several their models are compared")
      ->required();
  sub->add_option("-o,--output", report_.output,
                  "HTML file, in place of report.html in that folder; wanted for several folders");
  sub->add_flag("--json", report_.json, "Print JSON: the file and its size");
}

void Program::AddCompare() {
  CLI::App* sub = Add("compare", "Compare search methods on a study by evaluations counted",
                      "  fourpost compare study.yaml --methods dvhde,gb --runs 20 --seed 1 -o methods.html", [this] {
                        RequireStudyFile(compare_.study);
                        return Run(compare_);
                      });
  sub->add_option("STUDY", compare_.study, "Study file (.yaml) of a vehicle or a test problem")->required();
  sub->add_option("--methods", compare_.methods, "Separated by commas, of these or the study's own")
      ->delimiter(',')
      ->type_name(Braced(kMethodNames))
      ->default_str("dvhde,thesis,de,ds,gb");
  sub->add_option("--runs", compare_.runs, "Of each method")->check(CLI::Range(1, 1000000))->capture_default_str();
  sub->add_option("--seed", compare_.seed, "Of the first run; the others take those after it")
      ->check(WholeNumber("--seed"));
  sub->add_option("--threads", compare_.threads, "Runs at once, no influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_option("--near", compare_.near_best,
                  "How far above the best of all runs still counts as solved, such as 0.01%; without it 1 %. A study's "
                  "target goes before it");
  sub->add_option("--evaluations", compare_.evaluations, "At most, of each run, in place of what the study says")
      ->check(CLI::Range(1, 1000000000));
  CLI::Option* const time =
      sub->add_flag("--time", compare_.time, "Tell processor time, too, which no two comparisons have alike");
  sub->add_option("--archive", compare_.archive,
                  "File to keep evaluations in, such as the archive.sqlite of a fit; no influence on the result")
      ->excludes(time);
  sub->add_option("-o,--output", compare_.output, "HTML file with the table and a picture of what a success costs");
  sub->add_flag("--json", compare_.json, "Print JSON in place of tables");
}

void Program::AddRank() {
  CLI::App* sub = Add("rank", "Compare models fitted to the same bench recordings, and choose one",
                      "  fourpost rank run/model1 run/model2", [this] { return Run(rank_); });
  sub->add_option("RUN", rank_.runs, "Folders that `fourpost fit` wrote")->required();
  sub->add_flag("--json", rank_.json, "Print JSON in place of tables");
}

void Program::AddCompletion() {
  CLI::App* sub = Add("completion", "Print what teaches a shell to complete commands, options and files",
                      "  source <(fourpost completion bash)\n"
                      "  mkdir -p ~/.config/fish/completions\n"
                      "  fourpost completion fish > ~/.config/fish/completions/fourpost.fish",
                      [this] {
                        Print(CompletionScript(CommandTable(app_), shell_));
                        return kGood;
                      });
  sub->add_option("SHELL", shell_, "bash, zsh or fish")->required()->check(OneOf("SHELL", kShells));
}

void Program::AddMan() {
  Add("man", "Print the manual page, for man(1)", "  fourpost man | man -l -", [this] {
    Print(ManualPage(CommandTable(app_)));
    return kGood;
  });
}

void Program::AddHelp() {
  CLI::App* sub = Add("help", "Help on a command, or on an error or a warning by its id",
                      "  fourpost help fit\n  fourpost help findings\n  fourpost help word-misspelt", [this] {
                        PrintText(HelpOn(topic_));
                        return kGood;
                      });
  sub->add_option("TOPIC", topic_, "A command, findings for a list of all errors and warnings, or the id of one");
}

std::string Program::HelpOn(const std::string& topic) const {
  if (topic.empty()) return app_.get_formatter()->make_help(&app_, "fourpost", CLI::AppFormatMode::Normal);
  if (topic == kAllTopics) return FindingsMarkdown();
  std::vector<std::string> known = {kAllTopics};
  for (const CommandRow& command : CommandTable(app_)) {
    if (command.name == topic) return app_.get_subcommand(topic)->help("fourpost");
    known.push_back(command.name);
  }
  for (const auto& [id, finding] : AllFindings()) {
    if (topic == id || topic == "[" + std::string(id) + "]") return FindingText(*finding);
    known.emplace_back(id);
  }
  Refuse(kHelpTopicUnknown, Place::Option("TOPIC"), {topic, DidYouMean(topic, known)});
}

}  // namespace fourpost
