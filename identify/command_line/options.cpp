#include "identify/command_line/options.h"

#include <array>
#include <string_view>

#include "identify/command_line/common_options.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 4> kEngines = {"auto", "reduced", "full", "time"};
constexpr std::array<std::string_view, 2> kHoldings = {"preload", "free_length"};
constexpr std::array<std::string_view, 2> kDirections = {"up", "down"};

/// Options for how the posts of a vehicle move, and what of it changes.
/// Modes of the posts, and frequencies.
std::vector<CLI::Option*> AddModesAndFrequencies(CLI::App& subcommand, SweepText& sweep) {
  return {AddList(subcommand, "--mode", sweep.modes, (std::string(kModeHelp) + "; may be given several times").c_str())
              ->default_str("heave"),
          subcommand
              .add_option("--frequencies", sweep.frequencies,
                          "FIRST:LAST:COUNT (0.5Hz:30Hz:40), FIRST:LAST:STEP (1Hz:5Hz:0.5Hz) or a list (1Hz,2Hz)")
              ->capture_default_str()};
}

std::vector<CLI::Option*> AddSweep(CLI::App& subcommand, ResponseCommand& command) {
  SweepText& sweep = command.sweep;
  std::vector<CLI::Option*> options = AddModesAndFrequencies(subcommand, sweep);
  for (CLI::Option* option : {
           AddChannels(subcommand, sweep.channels),
           subcommand
               .add_option_function<std::string>(
                   "--direction", [&sweep](const std::string& way) { sweep.falling = way == "down"; },
                   "Order of the frequencies: where several steady motions are possible, each continues the one before")
               ->check(OneOf("--direction", kDirections))
               ->default_str("up"),
           AddStroke(subcommand, sweep.stroke),
           AddSettings(subcommand, command.set),
       })
    options.push_back(option);
  for (CLI::Option* limit : AddLimits(subcommand, sweep.limits)) options.push_back(limit);
  return options;
}

}  // namespace

void AddShownSweep(CLI::App& subcommand, SweepText& sweep) {
  AddModesAndFrequencies(subcommand, sweep);
  AddChannels(subcommand, sweep.channels);
  AddStroke(subcommand, sweep.stroke);
  AddLimits(subcommand, sweep.limits);
}

void AddOptions(CLI::App& subcommand, ResponseCommand& command) {
  subcommand.add_option("MODEL", command.input, "Vehicle file (.urdf) or study (.yaml)")->required();
  const std::vector<CLI::Option*> of_vehicle = AddSweep(subcommand, command);
  subcommand
      .add_option_function<std::string>(
          "--engine", [&command](const std::string& name) { command.engine = EngineNamed(name); },
          "reduced: harmonic balance on linear kinematics, as in a fit; full: harmonic balance on the full multibody "
          "system; time: time integration of that to steady state (slow, the reference); auto: reduced, checked by "
          "full, which replaces it where they visibly differ (default)")
      ->transform(EngineOf(kEngines));
  subcommand.add_option("-o,--output", command.output,
                        "Write report.html, response.csv, response.svg and result.json to this folder");
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
          "Follow the poles while a parameter changes: NAME for all of its range, or NAME=FIRST:LAST:COUNT "
          "(k=20kN/m:80kN/m:13); may be given several times");
  subcommand.add_option(
      "-o,--output", command.output,
      "Write report.html, impulse.csv, impulse.svg, poles.csv, charts of poles and responses for each parameter, and "
      "result.json to this folder");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

void AddOptions(CLI::App& subcommand, KinematicsCommand& command) {
  AddVehicle(subcommand, command.model);
  AddSettings(subcommand, command.set);
  subcommand.add_option("--travel", command.travel,
                        "How far the wheels rise and fall: 80mm, or rebound:bump, as in -60mm:80mm; default: to where "
                        "the stops begin, 60 mm without a stop");
  subcommand.add_option("--step", command.step, "From one position to the next")->capture_default_str();
  subcommand.add_option("-o,--output", command.output,
                        "Write report.html, wheels.csv, ratios.csv, compliance.csv, a picture of each axle and "
                        "result.json to this folder");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

void AddOptions(CLI::App& subcommand, SettleCommand& command) {
  AddVehicle(subcommand, command.model);
  AddSettings(subcommand, command.set);
  CLI::Option* const equilibrium = subcommand.add_flag(
      "--equilibrium", command.equilibrium,
      "In the file at rest leave the preloads of springs to equilibrium, as fits that free masses or rates need");
  subcommand
      .add_option(
          "--hold", command.hold,
          "Keep the design pose, and write the preloads or free lengths that hold it, of springs that state one")
      ->check(OneOf("--hold", kHoldings))
      ->excludes(equilibrium);
  subcommand.add_option("-o,--output", command.output, "Write the vehicle file at rest here (.urdf)");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

void AddOptions(CLI::App& subcommand, PredictCommand& command) {
  subcommand.add_option("RUN", command.run, "Folder that `fourpost fit` wrote")->required();
  subcommand
      .add_option("--recording", command.recording,
                  "Recording (text, MAT, RPC III, UFF, TDMS, MDF, LVM, HDF5) of another excitation, in the layout of "
                  "those that were fitted")
      ->required();
  subcommand.add_option("--mode", command.mode,
                        "How the posts moved in a stepped sine: heave, pitch, roll, warp, or an amplitude for each "
                        "(FL=1,FR=-1); default: the motion that fits the lowest frequencies best");
  CLI::Option* const mass = subcommand.add_option("--add-mass", command.add_mass,
                                                  "Load that the fitted vehicle did not have, e.g. \"250 kg\"");
  CLI::Option* const at = subcommand.add_option(
      "--at", command.at,
      "Its position X,Y,Z from the vehicle file's origin, x forward, y left, z up: in metres, or with units such as "
      "-600 mm,0,40 cm");
  mass->needs(at);
  at->needs(mass);
  CLI::Option* const kalman = subcommand.add_flag(
      "--kalman", command.kalman,
      "Report the errors of a Kalman filter's one-step predictions as well, with the noise of a fit "
      "by 'cost: prediction'; these errors are smaller than those of a simulation even for a poor "
      "model");
  subcommand
      .add_option(
          "--noise-from", command.noise_from,
          "With --kalman: estimate the filter's noise on this recording, which should be one that was fitted, not "
          "the one that is predicted; needed after a fit by another cost")
      ->needs(kalman);
  subcommand.add_option("--control", command.setting,
                        "The recording's setting, such as a current or clicks, of which the study's 'control' lets "
                        "parameters follow");
  subcommand.add_option(
      "--release", command.release,
      "From where the vehicle was let go: estimated, \"at rest\", or the readings above rest at which "
      "it was held, e.g. z_body=\"50 mm\"; default: as the study's first history");
  QuantityOptions(subcommand, command.faults)
      .Add("--start", kTime, "Time of the release, or start of the evaluated part of a time history, e.g. 0.8s",
           [&command](double start_s) { command.start_s = start_s; });
  subcommand
      .add_option_function<std::string>(
          "--engine", [&command](const std::string& name) { command.engine = EngineNamed(name); },
          "reduced: linear kinematics; full: the multibody system; auto: reduced, checked by full, which replaces it "
          "where they visibly differ (default)")
      ->transform(EngineOf(kHistoryEngines));
  subcommand.add_option(
      "-o,--output", command.output,
      "Write result.json and the measured and predicted channels to this folder: response.csv and response.svg of a "
      "stepped sine, history.csv and history.svg of a time history, bench.csv and diagrams.svg of a damper");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

}  // namespace fourpost
