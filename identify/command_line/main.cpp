#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "analysis/diagnostics.h"
#include "analysis/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/options.h"
#include "identify/command_line/simulate_options.h"
#include "identify/command_line/whole_number.h"

namespace {

using namespace fourpost;

int Guarded(const std::function<int()>& run) {
  const auto tell = [](const std::exception& error, int code) {
    std::fprintf(stderr, "%s\n", error.what());
    return code;
  };
  try {
    return run();
  } catch (const FaultyInput& error) {
    return tell(error, kUnreadableInput);
  } catch (const OutputError& error) {
    return tell(error, kCannotWrite);
  } catch (const std::runtime_error& error) {
    return tell(error, kAllSimulationsFailed);
  } catch (const std::exception& error) {
    std::fputs("a defect of fourpost, please report it: ", stderr);
    return tell(error, kDefect);
  }
}

}  // namespace

int main(int argc, char** argv) {
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
  sub->callback([&] { run = [&] { return Run(check); }; });

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
  sub->add_option("-o,--output", fit.output, "Folder for result.json, vehicle.urdf, response.csv and response.svg")
      ->required();
  sub->add_option("--seed", fit.seed, "Seed of the search, in place of the study's")->check(WholeNumber());
  sub->add_option("--threads", fit.threads, "Evaluations at once, no influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--json", fit.json, "Print result.json in place of tables");
  sub->callback([&] { run = [&] { return Run(fit); }; });

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
  sub->add_flag("--json", compare.json, "Print JSON in place of tables");
  sub->callback([&] { run = [&] { return Run(compare); }; });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kGood : kUsage;
  }
  return Guarded(run);
}
