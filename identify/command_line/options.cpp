#include "identify/command_line/options.h"

#include <array>
#include <string_view>

#include "identify/command_line/common_options.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 4> kEngines = {"auto", "reduced", "full", "march"};
constexpr std::array<std::string_view, 2> kDirections = {"up", "down"};

/// Options that tell how the posts of a vehicle move, and what of it changes.
std::vector<CLI::Option*> AddSweep(CLI::App& subcommand, ResponseCommand& command) {
  SweepText& sweep = command.sweep;
  std::vector<CLI::Option*> options = {
      AddList(subcommand, "--mode", sweep.modes, (std::string(kModeHelp) + "; may be given several times").c_str())
          ->default_str("heave"),
      subcommand
          .add_option("--frequencies", sweep.frequencies,
                      "first:last:how many (0.5Hz:30Hz:40), first:last:step (1Hz:5Hz:0.5Hz) or a list (1Hz,2Hz)")
          ->capture_default_str(),
      AddChannels(subcommand, sweep.channels),
      subcommand
          .add_option_function<std::string>(
              "--direction", [&sweep](const std::string& way) { sweep.falling = way == "down"; },
              "Order of the frequencies, up or down: where several motions are possible, each follows the one before")
          ->check(OneOf("--direction", kDirections))
          ->default_str("up"),
      AddStroke(subcommand, sweep.stroke),
      AddSettings(subcommand, command.set),
  };
  for (CLI::Option* limit : AddLimits(subcommand, sweep.limits)) options.push_back(limit);
  return options;
}

}  // namespace

void AddOptions(CLI::App& subcommand, ResponseCommand& command) {
  subcommand.add_option("MODEL", command.input, "Vehicle file (.urdf) or study (.yaml)")->required();
  const std::vector<CLI::Option*> of_vehicle = AddSweep(subcommand, command);
  subcommand
      .add_option_function<std::string>(
          "--engine", [&command](const std::string& name) { command.engine = EngineNamed(name); },
          "reduced: harmonic balance on linear kinematics as in a fit; full: on the full multibody system; march: "
          "integrate that to steady state (slow, the reference); auto: reduced, checked by full, which answers where "
          "they visibly differ (default)")
      ->transform(EngineOf(kEngines));
  subcommand.add_option("-o,--output", command.output, "Folder for response.csv, response.svg and result.json");
  subcommand.add_flag("--json", command.json, "Print JSON");
  subcommand.parse_complete_callback([&command, of_vehicle] {
    for (const CLI::Option* option : of_vehicle)
      if (option->count() > 0) command.vehicle_options.push_back(option->get_name());
  });
}

void AddOptions(CLI::App& subcommand, ModesCommand& command) {
  AddVehicle(subcommand, command.model);
  AddSettings(subcommand, command.set);
  AddList(subcommand, "--vary", command.vary,
          "name, from bound to bound, or name=first:last:how many (k=20kN/m:80kN/m:13): follow the poles while this "
          "parameter changes; may be given several times");
  subcommand.add_option(
      "-o,--output", command.output,
      "Folder for impulse.csv and impulse.svg, poles.csv, pictures of poles and responses per parameter, and "
      "result.json");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

void AddOptions(CLI::App& subcommand, PredictCommand& command) {
  subcommand.add_option("RUN", command.run, "Folder that `fourpost fit` wrote")->required();
  subcommand
      .add_option("--recording", command.recording,
                  "A recording (.csv) of the same layout as those fitted, of another excitation")
      ->required();
  subcommand.add_option("--mode", command.mode,
                        "Of a stepped sine: how the posts moved, heave, pitch, roll, warp or the share of each "
                        "(FL=1,FR=-1); default: the pattern that fits the lowest frequencies best");
  CLI::Option* const mass = subcommand.add_option("--add-mass", command.add_mass,
                                                  "A load that the fitted vehicle did not have, as \"250 kg\"");
  CLI::Option* const at = subcommand.add_option(
      "--at", command.at,
      "Where it lies, X,Y,Z from the vehicle file's origin, x forward, y left, z up: in metres, or with units as "
      "-600 mm,0,40 cm");
  mass->needs(at);
  at->needs(mass);
  CLI::Option* const kalman =
      subcommand.add_flag("--kalman", command.kalman,
                          "Tell the errors of a Kalman filter's one-step predictions as well, its noise as a fit by "
                          "'cost: prediction' held "
                          "it; such errors are smaller than a simulation's whatever the model is worth");
  subcommand
      .add_option("--noise-from", command.noise_from,
                  "With --kalman: a recording to estimate the filter's noise on, that of the fit and not the one that "
                  "is judged; needed after a fit by another cost")
      ->needs(kalman);
  subcommand
      .add_option_function<std::string>(
          "--engine", [&command](const std::string& name) { command.engine = EngineNamed(name); },
          "reduced: linear kinematics; full: the multibody system; auto: reduced, checked by full, which answers where "
          "they visibly differ (default)")
      ->transform(EngineOf(kHistoryEngines));
  subcommand.add_option(
      "-o,--output", command.output,
      "Folder for result.json and what was measured and predicted: of a stepped sine response.csv and "
      "response.svg, of a recording over time history.csv and history.svg");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

}  // namespace fourpost
