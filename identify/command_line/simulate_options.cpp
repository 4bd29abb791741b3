#include "identify/command_line/simulate_options.h"

#include <string>

#include "analysis/text/units.h"
#include "identify/command_line/common_options.h"
#include "identify/command_line/motion_options.h"
#include "identify/command_line/whole_number.h"

namespace fourpost {
namespace {

void AddAcquisition(CLI::App& app, SimulateCommand& command) {
  QuantityOptions options(app, command.faults);
  AddChannels(app, command.channels);
  options.Add("--rate", kFrequency, "Sampling rate (default 500Hz)",
              [&command](double value) { command.rate_Hz = value; });
  CLI::Option* filter =
      options.Add("--filter", kFrequency, "Cut-off frequency of a Butterworth low-pass on every channel",
                  [&command](double value) { command.filter_Hz = value; });
  app.add_option("--order", command.filter_order, "Order of the filter")
      ->check(CLI::Range(1, 16))
      ->capture_default_str()
      ->needs(filter);
  options.AddShare("--noise", "White noise on every channel, as a share of its standard deviation, e.g. 1%",
                   command.noise);
  app.add_option("--seed", command.seed, "Seed of random motions and noise")
      ->check(WholeNumber("--seed"))
      ->capture_default_str();
}

}  // namespace

void AddOptions(CLI::App& subcommand, SimulateCommand& command) {
  AddVehicle(subcommand, command.model);
  AddSettings(subcommand, command.set);
  const MotionOptions motions = AddMotions(subcommand, command);
  AddRoad(motions, subcommand, command);
  AddMotionDetails(subcommand, command, motions);
  AddAcquisition(subcommand, command);
  subcommand
      .add_option_function<std::string>(
          "--engine", [&command](const std::string& text) { command.engine = EngineNamed(text).value(); },
          "reduced: kinematics linearised about equilibrium with nonlinear force laws; full: the multibody system; "
          "auto: "
          "reduced, checked by full, which replaces it where they visibly differ")
      ->transform(EngineOf(kHistoryEngines))
      ->default_str("auto");
  QuantityOptions(subcommand, command.faults)
      .AddShare("--error",
                "Largest change of a channel when the time step is halved, as a share of its rms (default 0.1%)",
                command.error);
  subcommand.add_option(
      "-o,--output", command.output,
      "Write the history here, as CSV, or by the ending as a universal file (.uff), RPC III (.rsp), or "
      "the posts alone as a drive file (.drv), and print a summary (default: CSV on stdout); a name without an ending "
      "is a folder for history.csv, history.svg, report.html and result.json");
  subcommand.add_option("--chart", command.chart, "Write a chart of the history here (.svg)");
  subcommand.add_flag("--json", command.json, "Print the summary as JSON instead of CSV or a table");
}

}  // namespace fourpost
