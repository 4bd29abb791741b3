#include "identify/command_line/ride_options.h"

#include "identify/command_line/common_options.h"
#include "identify/command_line/motion_options.h"
#include "identify/command_line/whole_number.h"

namespace fourpost {

void AddOptions(CLI::App& subcommand, RideCommand& command) {
  SimulateCommand& drive = command.drive;
  subcommand.add_option("MODEL", drive.model, "Vehicle file (.urdf), or the folder of a fit")->required();
  AddSettings(subcommand, drive.set);
  const MotionOptions motions = AddMotions(subcommand, drive);
  AddRoads(motions, subcommand, command);
  AddMotionDetails(subcommand, drive, motions);
  AddList(subcommand, "--point", command.points,
          "A point whose vertical acceleration is felt, NAME=LINK:X,Y,Z in metres along the link's axes, e.g. "
          "seat=chassis:0.1,0.3,0.8, besides the accelerometers on the chassis; may be given several times");
  AddList(
      subcommand, "--weighting", command.weightings,
      "Weighting of a point, e.g. seat=Wb (default: Wk, for horizontal accelerometers Wd); may be given several times");
  subcommand
      .add_flag("--time", command.over_time,
                "Roads by time histories too, and the difference; other motions always are time histories")
      ->needs(motions.group->get_option("--road"));
  QuantityOptions options(subcommand, drive.faults);
  options.Add("--rate", kFrequency, "Sampling rate of time histories (default 500Hz)",
              [&drive](double value) { drive.rate_Hz = value; });
  subcommand.add_option("--seed", drive.seed, "Seed of random motions")
      ->check(WholeNumber("--seed"))
      ->capture_default_str();
  subcommand
      .add_option_function<std::string>(
          "--engine", [&drive](const std::string& text) { drive.engine = EngineNamed(text).value(); },
          "Of time histories. reduced: kinematics linearised about equilibrium with nonlinear force laws; full: the "
          "multibody system; auto: reduced, checked by full, which replaces it where they visibly differ")
      ->transform(EngineOf(kHistoryEngines))
      ->default_str("auto");
  subcommand.add_option("-o,--output", command.output,
                        "Write report.html, metrics.csv, spectra.csv, ride.svg and result.json to this folder");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

}  // namespace fourpost
