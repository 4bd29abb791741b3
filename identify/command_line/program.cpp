#include "identify/command_line/program.h"

#include "analysis/text/diagnostics.h"
#include "analysis/text/nearest.h"
#include "identify/command_line/batch_options.h"
#include "identify/command_line/command_table.h"
#include "identify/command_line/common_options.h"
#include "identify/command_line/completion.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/finding_list.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/frf_options.h"
#include "identify/command_line/manual_page.h"
#include "identify/command_line/options.h"
#include "identify/command_line/print.h"
#include "identify/command_line/ride_options.h"
#include "identify/command_line/simulate_options.h"
#include "identify/command_line/whole_number.h"
#include "identify/inspection/file_kind.h"
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
  AddFrf();
  AddCheck();
  AddParams();
  AddResponse();
  AddModes();
  AddKinematics();
  AddSettle();
  AddExport();
  AddView();
  AddSimulate();
  AddRide();
  AddFit();
  AddPredict();
  AddReport();
  AddCompare();
  AddRank();
  AddDraws();
  AddSuggest();
  AddChoose();
  AddPlan();
  AddBatch();
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
  CLI::App* sub = Add(
      "init",
      "Write a study to start from: an example that fits in a second, or a draft for recordings and a vehicle; or a "
      "vehicle from the hard points of its suspensions, or from a model of Project Chrono",
      "  fourpost init car\n  fourpost fit car/study.yaml -o run\n"
      "  fourpost init study --from rig --vehicle car.urdf\n"
      "  fourpost init coupe --suspension front=macpherson,rear=twist_beam\n"
      "  fourpost init coupe --suspension front=macpherson,rear=twist_beam --points coupe/points.csv --replace\n"
      "  fourpost init truck --chrono data/vehicle/hmmwv/vehicle/HMMWV_Vehicle.json --tyre "
      "data/vehicle/hmmwv/tire/HMMWV_TMeasyTire.json",
      [this] {
        if (!init_.vehicle.empty()) RequireVehicleFile(init_.vehicle);
        return Run(init_);
      });
  AddOptions(*sub, init_);
}

void Program::AddInfo() {
  CLI::App* sub =
      Add("info", "Show the channels of a recording: units, sampling rate, ranges, resolution, clipping and gaps",
          "  fourpost info sweep.csv\n  fourpost info study.yaml\n  fourpost info --json run1.mat run2.mat",
          [this] { return Run(info_); });
  sub->add_option("FILE", info_.files,
                  "Time histories, stepped sines or static loads (text, MAT, RPC III, UFF, TDMS, MDF, LVM, HDF5); a "
                  "study (.yaml), whose rig is audited")
      ->required();
  sub->add_flag("--json", info_.json, "Print JSON");
}

void Program::AddFrf() {
  AddOptions(
      *Add("frf", "Make frequency responses of time histories: stepped sines, sweeps, random motions, multisines",
           "  fourpost frf sweep.csv\n"
           "  fourpost frf sweep.csv --kind sweep --frequencies 1Hz:20Hz:40 -o frf",
           [this] { return Run(frf_); }),
      frf_);
}

void Program::AddCheck() {
  CLI::App* sub = Add("check", "Check a vehicle file; show bodies, loads, rates, modes and parameter sensitivities",
                      "  fourpost check car.urdf\n  fourpost check --resolved car.urdf > complete.urdf", [this] {
                        RequireVehicleFile(check_.model);
                        return Run(check_);
                      });
  sub->add_option("MODEL", check_.model, "Vehicle file (.urdf)")->required();
  CLI::Option* set = AddSettings(*sub, check_.set);
  CLI::Option* json = sub->add_flag("--json", check_.json, "Print JSON");
  sub->add_flag("--resolved", check_.resolved,
                "Print the file with all defaults of fp: tags filled in and paths of meshes relative to this folder")
      ->excludes(json)
      ->excludes(set);
}

void Program::AddParams() {
  CLI::App* sub = Add("params", "Show the parameters of a vehicle file: values, bounds, priors and where they are used",
                      "  fourpost params car.urdf\n  fourpost params run/vehicle.urdf --json", [this] {
                        RequireVehicleFile(params_.model);
                        return Run(params_);
                      });
  sub->add_option("MODEL", params_.model, "Vehicle file (.urdf)")->required();
  sub->add_flag("--json", params_.json, "Print JSON, SI");
}

void Program::AddResponse() {
  AddOptions(*Add("response", "Frequency response of a vehicle to its posts; of a study, compared with its recordings",
                  "  fourpost response car.urdf --mode heave --mode roll -o response\n"
                  "  fourpost response car.urdf --frequencies 0.5Hz:5Hz:20 --set k=20kN/m\n"
                  "  fourpost response study.yaml --engine full",
                  [this] { return Run(response_); }),
             response_);
}

void Program::AddSettle() {
  AddOptions(*Add("settle", "Pose at rest of a vehicle whose springs do not hold its design pose, and the file at rest",
                  "  fourpost settle car.urdf\n  fourpost settle car.urdf -o at_rest.urdf\n"
                  "  fourpost settle car.urdf --hold free_length -o held.urdf",
                  [this] { return Run(settle_); }),
             settle_);
}

void Program::AddKinematics() {
  AddOptions(*Add("kinematics", "Kinematics and compliance: camber, toe, track, roll centre, motion ratios over travel",
                  "  fourpost kinematics car.urdf\n  fourpost kinematics car.urdf --travel -80mm:100mm -o kinematics",
                  [this] { return Run(kinematics_); }),
             kinematics_);
}

void Program::AddModes() {
  AddOptions(*Add("modes", "Modes of a vehicle: poles, shapes, and how parameters change them",
                  "  fourpost modes car.urdf\n  fourpost modes car.urdf --vary c_bump=200N*s/m:4000N*s/m:20 -o modes",
                  [this] { return Run(modes_); }),
             modes_);
}

void Program::AddExport() {
  CLI::App* sub = Add("export", "Write the reduced equations of a vehicle, or of a fit's, for other programs",
                      "  fourpost export car.urdf -o car.json\n  fourpost export run --set k=20kN/m --json",
                      [this] { return Run(export_); });
  sub->add_option("MODEL", export_.input, "Vehicle file (.urdf) or folder of a fit")->required();
  AddSettings(*sub, export_.set);
  sub->add_option("-o,--output", export_.output, "File for the JSON");
  sub->add_flag("--json", export_.json, "Print JSON, SI, in place of a summary");
}

void Program::AddView() {
  CLI::App* sub = Add("view", "Write a page of a vehicle that moves, with a slider for each parameter",
                      "  fourpost view car.urdf\n  fourpost view car.urdf --mode heave --mode roll -o car.html",
                      [this] { return Run(view_); });
  sub->add_option("MODEL", view_.input, "Vehicle file (.urdf) or folder of a fit")->required();
  AddShownSweep(*sub, view_.sweep);
  AddSettings(*sub, view_.set);
  sub->add_option("-o,--output", view_.output, "File for the page (default: the vehicle's name, .html)");
  sub->add_flag("--json", view_.json, "Print JSON: the file and its size");
}

void Program::AddSimulate() {
  AddOptions(*Add("simulate", "Simulate a vehicle on its posts; time history as CSV",
                  "  fourpost simulate car.urdf --sweep 0.5Hz:30Hz -o sweep.csv --chart sweep.svg\n"
                  "  fourpost simulate car.urdf --road B --speed 60km/h --noise 1% > road.csv",
                  [this] { return Run(simulate_); }),
             simulate_);
}

void Program::AddRide() {
  AddOptions(*Add("ride", "Ride of a vehicle on roads: comfort, tyre loads, travel, dampers, body motion",
                  "  fourpost ride car.urdf --road C --speed 60km/h\n"
                  "  fourpost ride run --road B,C --speed 60km/h,100km/h --point seat=body:0.1,0.3,0.8 -o ride\n"
                  "  fourpost ride car.urdf --step 50mm",
                  [this] { return Run(ride_); }),
             ride_);
}

void Program::AddFit() {
  CLI::App* sub = Add("fit", "Fit a study's vehicle to the recordings",
                      "  fourpost fit study.yaml -o run\n  fourpost fit study.yaml -o run --resume", [this] {
                        RequireStudyFile(fit_.study);
                        return Run(fit_);
                      });
  sub->add_option("STUDY", fit_.study, "Study file (.yaml)")->required();
  sub->add_option("-o,--output", fit_.output,
                  "Folder for report.html, result.json, the fitted vehicle.urdf, archive.sqlite, parameters.csv with "
                  "start and fitted values, and the measured and modelled channels: response.csv and response.svg, "
                  "history.csv and history.svg, bench.csv and diagrams.svg")
      ->required();
  AddSettings(*sub, fit_.set);
  sub->add_option("--seed", fit_.seed, "Seed of the search (default: that of the study)")->check(WholeNumber("--seed"));
  sub->add_option("--threads", fit_.threads,
                  "Evaluations in parallel, without influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--accept-unidentified", fit_.accept_unidentified,
                "Fit although data and priors do not determine all directions of parameters");
  sub->add_flag("--accept-implausible", fit_.accept_implausible,
                "Fit although recorded post motion contradicts the study");
  sub->add_option("--profile", fit_.profile,
                  "Profile these free parameters, separated by commas, or all: the cost with each held at other values "
                  "and the others refitted")
      ->delimiter(',');
  sub->add_flag(
      "--resume", fit_.resume,
      "Continue a fit that was stopped; an error if the vehicle, recordings, program or settings that residuals "
      "depend on have changed");
  sub->add_flag("--grow", fit_.grow,
                "Add to the vehicle, step by step, what `fourpost suggest` names first, while BIC falls and validation "
                "recordings are predicted no worse; steps/growth.json holds the path");
  sub->add_flag(
      "--watch", fit_.watch,
      "Keep a page, watch.html in the folder of the results, that shows how the fit gets on; it opens the report "
      "at the end");
  sub->add_flag("!--no-suggest", fit_.name_missing, "Do not look for what the vehicle lacks where residuals are large");
  sub->add_flag("--json", fit_.json, "Print result.json instead of tables");
}

void Program::AddPredict() {
  AddOptions(*Add("predict", "Predict another recording with a fitted vehicle and report the errors",
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
      "report", "Write the report of a fit again, or one that compares fits: an HTML file that needs no network",
      "  fourpost report run\n  fourpost report run/model1 run/model2 -o models.html", [this] { return Run(report_); });
  sub->add_option("RUN", report_.runs, "Folder that `fourpost fit -o` wrote; several are compared")->required();
  sub->add_option("-o,--output", report_.output,
                  "HTML file (default: report.html in that folder); needed for several folders");
  sub->add_flag("--json", report_.json, "Print JSON: the file and its size");
}

void Program::AddCompare() {
  CLI::App* sub = Add("compare", "Compare search methods on a study by the evaluations they need",
                      "  fourpost compare study.yaml --methods dvhde,gb --runs 20 --seed 1 -o methods.html", [this] {
                        RequireStudyFile(compare_.study);
                        return Run(compare_);
                      });
  sub->add_option("STUDY", compare_.study, "Study file (.yaml) of a vehicle or a test problem")->required();
  sub->add_option("--methods", compare_.methods, "Methods, separated by commas: these or the study's own")
      ->delimiter(',')
      ->type_name(Braced(kMethodNames))
      ->default_str("dvhde,thesis,de,simplex,gb");
  sub->add_option("--runs", compare_.runs, "Runs of each method")->check(CLI::Range(1, 1000000))->capture_default_str();
  sub->add_option("--seed", compare_.seed, "Seed of the first run; the others take the following ones")
      ->check(WholeNumber("--seed"));
  sub->add_option("--threads", compare_.threads,
                  "Runs in parallel, without influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_option(
      "--near", compare_.near_best,
      "Count a run as solved up to this share above the best of all runs, e.g. 0.01% (default 1%); not used "
      "where the study has a target");
  sub->add_option("--evaluations", compare_.evaluations,
                  "Largest number of evaluations of each run (default: that of the study)")
      ->check(CLI::Range(1, 1000000000));
  CLI::Option* const time =
      sub->add_flag("--time", compare_.time, "Report processor time too, which differs between two comparisons");
  sub->add_option("--archive", compare_.archive,
                  "File to store evaluations in, such as the archive.sqlite of a fit; without influence on the result")
      ->excludes(time);
  sub->add_option("-o,--output", compare_.output,
                  "Write the table and a chart of evaluations per success here (.html)");
  sub->add_flag("--json", compare_.json, "Print JSON instead of tables");
}

void Program::AddRank() {
  CLI::App* sub = Add("rank", "Compare models fitted to the same bench recordings and recommend one",
                      "  fourpost rank run/model1 run/model2", [this] { return Run(rank_); });
  sub->add_option("RUN", rank_.runs, "Folders that `fourpost fit` wrote")->required();
  sub->add_flag("--json", rank_.json, "Print JSON instead of tables");
}

void Program::AddDraws() {
  CLI::App* sub = Add("draws", "Draw parameter values that a fit and its intervals allow, as CSV",
                      "  fourpost draws run -n 1000 -o draws.csv\n"
                      "  fourpost draws run --study study.yaml --noise-only -o likelihood.csv",
                      [this] { return Run(draws_); });
  sub->add_option("RUN", draws_.run, "Folder that `fourpost fit -o` wrote")->required();
  sub->add_option("-n,--count", draws_.count, "Number of draws")->check(CLI::Range(2, 1000000))->capture_default_str();
  sub->add_option("--seed", draws_.seed, "Seed; the same seed gives the same draws")
      ->check(WholeNumber("--seed"))
      ->capture_default_str();
  sub->add_option("--study", draws_.study,
                  "The study that the run fitted: needed for --noise-only, and to draw about several optima");
  sub->add_flag("--noise-only", draws_.noise_only,
                "Draw from the likelihood alone, shaped by the true cost (default: noise, held parameters and model "
                "error together, as the intervals)");
  sub->add_option("--evaluations", draws_.max_evaluations,
                  "Largest number of evaluations with --noise-only, where the likelihood is not normal")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000000000}))
      ->capture_default_str();
  sub->add_option("--threads", draws_.threads,
                  "Evaluations in parallel, without influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_option("-o,--output", draws_.output, "Write the CSV here (default: stdout) and print a summary");
  sub->add_flag("--json", draws_.json, "Print JSON: the summary, and the draws without -o");
}

void Program::AddSuggest() {
  CLI::App* sub = Add("suggest", "Suggest what to add to a fitted vehicle: mechanism, place, size and what it is worth",
                      "  fourpost suggest run --study study.yaml\n"
                      "  fourpost suggest run --study study.yaml --apply 1 -o with_friction",
                      [this] {
                        RequireStudyFile(suggest_.study);
                        return Run(suggest_);
                      });
  sub->add_option("RUN", suggest_.run, "Folder that `fourpost fit -o` wrote")->required();
  sub->add_option("--study", suggest_.study, "The study that the run fitted")->required();
  CLI::Option* const output =
      sub->add_option("-o,--output", suggest_.output, "Folder for vehicle.urdf and study.yaml with a suggestion");
  CLI::Option* const apply = sub->add_option("--apply", suggest_.apply, "Number of the suggestion to write there")
                                 ->check(CLI::Range(1, 10000));
  apply->needs(output);
  output->needs(apply);
  sub->add_flag("--all", suggest_.all, "List additions that do not lower BIC as well");
  sub->add_option("--threads", suggest_.threads,
                  "Evaluations in parallel, without influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--json", suggest_.json, "Print JSON instead of a table");
}

void Program::AddChoose() {
  CLI::App* sub = Add("choose", "Choose among settings of a fitted vehicle, such as clicks of its dampers, with doubt",
                      "  fourpost choose run --settings settings.yaml -o choice\n"
                      "  fourpost choose car.urdf --settings settings.yaml",
                      [this] {
                        RequireStudyFile(choose_.settings);
                        return Run(choose_);
                      });
  sub->add_option("RUN", choose_.run, "Folder that `fourpost fit -o` wrote, or a vehicle file, which has no doubt")
      ->required();
  sub->add_option("--settings", choose_.settings, "What can be set, roads, objectives and limits (.yaml)")->required();
  sub->add_option("-o,--output", choose_.output,
                  "Folder for choose.html, settings.csv, test_next.csv, settings.svg, front.svg and result.json");
  sub->add_flag("!--no-checks", choose_.has_checks,
                "Leave out time histories and the multibody system, which check the spectra for the best settings");
  sub->add_option("--threads", choose_.threads,
                  "Evaluations in parallel, without influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--json", choose_.json, "Print JSON instead of tables");
}

void Program::AddPlan() {
  AddOptions(*Add("plan", "Which recordings to make next, and what is then known of each parameter",
                  "  fourpost plan car.urdf --time 45min\n"
                  "  fourpost plan run --time 20min -o plan",
                  [this] { return Run(plan_); }),
             plan_);
}

void Program::AddBatch() {
  AddOptions(*Add("batch", "Run many fits, predictions, comparisons and choices, here or on a cluster",
                  "  fourpost batch plan.yaml --list\n  fourpost batch plan.yaml -o batch\n"
                  "  fourpost batch plan.yaml -o batch --on local --workers 2",
                  [this] { return Run(batch_); }),
             batch_);
}

void Program::AddCompletion() {
  CLI::App* sub = Add("completion", "Print the completion script of a shell for commands, options and files",
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
                      "  fourpost help fit\n  fourpost help findings\n  fourpost help argument-misspelt", [this] {
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
