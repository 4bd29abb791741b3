#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/diagnostics.h"
#include "analysis/nearest.h"
#include "analysis/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/file_kind.h"
#include "identify/command_line/options.h"
#include "identify/command_line/simulate_options.h"
#include "identify/command_line/whole_number.h"

namespace {

using namespace fourpost;

/// Whether all that is wrong is the values of options: findings are about "--amplitude" then, else about a file.
bool IsUsage(const Diagnostics& diagnostics) {
  const std::vector<Diagnostic>& items = diagnostics.items();
  return std::all_of(items.begin(), items.end(), [](const Diagnostic& item) {
    return item.severity == Severity::kWarning || item.file.starts_with("--");
  });
}

int Guarded(const std::function<int()>& run) {
  const auto tell = [](const std::exception& error, int code) {
    std::fprintf(stderr, "%s\n", error.what());
    return code;
  };
  try {
    return run();
  } catch (const FaultyInput& error) {
    return tell(error, IsUsage(error.diagnostics()) ? kUsage : kUnreadableInput);
  } catch (const OutputError& error) {
    return tell(error, kCannotWrite);
  } catch (const std::runtime_error& error) {
    return tell(error, kAllSimulationsFailed);
  } catch (const std::bad_alloc&) {
    std::fputs("out of memory; take fewer --threads, or free some: evaluations in an archive are kept\n", stderr);
    return kOutOfMemory;
  } catch (const std::exception& error) {
    std::fputs("a defect of fourpost, please report it: ", stderr);
    return tell(error, kDefect);
  }
}

void AddOptionNames(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
  // Groups of options.
  for (const CLI::App* group : app.get_subcommands({})) AddOptionNames(*group, names);
}

/// Words that are no options, arguments or commands, and what they were likely meant to be.
void TellUnknown(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  std::vector<std::string> known;
  if (!given.empty()) AddOptionNames(*given.front(), known);
  else
    for (const CLI::App* sub : app.get_subcommands({})) known.push_back(sub->get_name());
  const std::string of = given.empty() ? "fourpost" : "fourpost " + given.front()->get_name();
  const std::vector<std::string> words = app.remaining(true);
  const auto is_option = [](const std::string& word) { return word.starts_with("-"); };
  const bool has_option = std::any_of(words.begin(), words.end(), is_option);
  for (const std::string& word : words) {
    // Else it is an unknown option's value.
    if (has_option && !is_option(word)) continue;
    const std::string name = word.substr(0, word.find('='));
    std::fprintf(stderr, "%s takes no '%s'%s\n", of.c_str(), name.c_str(), DidYouMean(name, known).c_str());
  }
  std::fprintf(stderr, "run `%s --help` for what it takes\n", of.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  // A limit of the size of files then is an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("fourpost identifies vehicle suspension models from rig tests.", "fourpost");
  app.set_version_flag("--version", FOURPOST_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  std::function<int()> run;

  CheckCommand check;
  CLI::App* sub =
      app.add_subcommand("check", "Check a vehicle file; show bodies, loads, rates, modes and what sensors see");
  sub->add_option("MODEL", check.model, "Vehicle file (.urdf)")->required();
  CLI::Option* check_json = sub->add_flag("--json", check.json, "Print JSON");
  sub->add_flag("--resolved", check.resolved,
                "Print the file with every default of fp: tags filled in, meshes named for a file in this folder")
      ->excludes(check_json);
  sub->callback([&] {
    run = [&] {
      RequireVehicleFile(check.model);
      return Run(check);
    };
  });

  ResponseCommand response;
  sub = app.add_subcommand("response", "Response of a vehicle to the posts; of a study, compared with its recordings");
  AddOptions(*sub, response);
  sub->callback([&] { run = [&] { return Run(response); }; });

  ModesCommand modes;
  sub = app.add_subcommand("modes", "Modes of a vehicle: poles, shapes, and what parameters make of them");
  AddOptions(*sub, modes);
  sub->callback([&] { run = [&] { return Run(modes); }; });

  SimulateCommand simulate;
  AddSimulate(app, simulate)->callback([&] { run = [&] { return Run(simulate); }; });

  FitCommand fit;
  sub = app.add_subcommand("fit", "Fit a study's vehicle to the recordings");
  sub->add_option("STUDY", fit.study, "Study file (.yaml)")->required();
  sub->add_option("-o,--output", fit.output,
                  "Folder for report.html, result.json, vehicle.urdf, archive.sqlite, and what the data make of the "
                  "model: response.csv and "
                  "response.svg, history.csv and history.svg")
      ->required();
  sub->add_option("--seed", fit.seed, "Seed of the search, in place of the study's")->check(WholeNumber());
  sub->add_option("--threads", fit.threads, "Evaluations at once, no influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--accept-unidentified", fit.accept_unidentified,
                "Fit although data and priors leave combinations of parameters open");
  sub->add_option("--profile", fit.profile,
                  "Free parameters, separated by commas, or all: how the cost rises when each is held away from its "
                  "fitted value and the others are fitted anew")
      ->delimiter(',');
  sub->add_flag("--resume", fit.resume,
                "Go on with a fit that was ended: refuse when vehicle, recordings, program, or settings that residuals "
                "depend on, have changed");
  sub->add_flag("--json", fit.json, "Print result.json in place of tables");
  sub->callback([&] {
    run = [&] {
      RequireStudyFile(fit.study);
      return Run(fit);
    };
  });

  PredictCommand predict;
  sub = app.add_subcommand("predict", "Predict another recording with a fitted vehicle, and tell how well");
  AddOptions(*sub, predict);
  sub->callback([&] {
    run = [&] {
      RequireTable(predict.recording);
      return Run(predict);
    };
  });

  ReportCommand report;
  sub = app.add_subcommand("report", "Write the report of a fit anew: one HTML file that opens anywhere, offline");
  sub->add_option("RUN", report.run, "Folder that `fourpost fit -o` wrote")->required();
  sub->add_option("-o,--output", report.output, "HTML file, in place of report.html in that folder");
  sub->add_flag("--json", report.json, "Print JSON: the file and its size");
  sub->callback([&] { run = [&] { return Run(report); }; });

  CompareCommand compare;
  sub = app.add_subcommand("compare", "Compare search methods on a study by evaluations counted");
  sub->add_option("STUDY", compare.study, "Study file (.yaml) of a vehicle or a test problem")->required();
  sub->add_option("--methods", compare.methods,
                  "Separated by commas: dvhde direct thesis de ds gb bfgs multistart adaptive cma, or the study's own")
      ->delimiter(',')
      ->default_str("dvhde,thesis,de,ds,gb");
  sub->add_option("--runs", compare.runs, "Of each method")->check(CLI::Range(1, 1000000))->capture_default_str();
  sub->add_option("--seed", compare.seed, "Of the first run; the others take those after it")->check(WholeNumber());
  sub->add_option("--threads", compare.threads, "Runs at once, no influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_option("--near", compare.near_best,
                  "How far above the best of all runs still counts as solved, such as 0.01%; without it 1 %. A study's "
                  "target goes before it");
  sub->add_option("--evaluations", compare.evaluations, "At most, of each run, in place of what the study says")
      ->check(CLI::Range(1, 1000000000));
  CLI::Option* const compare_time =
      sub->add_flag("--time", compare.time, "Tell processor time, too, which no two comparisons have alike");
  sub->add_option("--archive", compare.archive,
                  "File to keep evaluations in, such as the archive.sqlite of a fit; no influence on the result")
      ->excludes(compare_time);
  sub->add_flag("--json", compare.json, "Print JSON in place of tables");
  sub->callback([&] {
    run = [&] {
      RequireStudyFile(compare.study);
      return Run(compare);
    };
  });

  RankCommand rank;
  sub = app.add_subcommand("rank", "Compare models fitted to the same bench recordings, and choose one");
  sub->add_option("RUN", rank.runs, "Folders that `fourpost fit` wrote")->required();
  sub->add_flag("--json", rank.json, "Print JSON in place of tables");
  sub->callback([&] { run = [&] { return Run(rank); }; });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool is_help = error.get_exit_code() == 0;
    if (is_help || app.remaining(true).empty()) return app.exit(error) == 0 ? kGood : kUsage;
    TellUnknown(app);
    return kUsage;
  }
  return Guarded(run);
}
