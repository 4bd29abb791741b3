#include <span>
#include <string>

#include "identify/command_line/options.h"
#include "identify/command_line/post_option.h"
#include "identify/command_line/unit_option.h"
#include "vehicles/templates/suspension_kind.h"

namespace fourpost {
namespace {

std::string SuspensionKindList() {
  std::string list;
  const std::span<const SuspensionKind> kinds = SuspensionKinds();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    list += (i == 0 ? "" : i + 1 == kinds.size() ? " or " : ", ") + std::string(kinds[i].name);
  return list;
}

/// Returns `--from`.
CLI::Option* AddDraft(CLI::App& app, InitCommand& command) {
  CLI::Option* from = app.add_option("--from", command.from,
                                     "Recordings, or folders of such: draft a study of them, with channels matched to "
                                     "the sensors of --vehicle");
  CLI::Option* vehicle = app.add_option("--vehicle", command.vehicle, "Vehicle file (.urdf) of the study to draft");
  from->needs(vehicle);
  vehicle->needs(from);
  AddUnitOption(app, command.units, command.faults)->needs(from);
  AddPostOption(app, command.posts, command.faults, "channels whose names mean a post, as of frf")->needs(from);
  return from;
}

/// Returns `--suspension`.
CLI::Option* AddSuspension(CLI::App& app, InitCommand& command) {
  CLI::Option* suspension =
      app.add_option("--suspension", command.suspension,
                     "Kinds of the front and the rear suspension, as front=KIND,rear=KIND: write vehicle.urdf and "
                     "points.csv with plausible points. KIND is " +
                         SuspensionKindList())
          ->delimiter(',');
  app.add_option("--points", command.points,
                 "Table of hard points, axle,point,x [mm],y [mm],z [mm], left side, for the vehicle to have")
      ->needs(suspension);
  app.add_option(
         "--load", command.load,
         "Mass on both tyres of each axle, as front=760kg,rear=640kg: for the body's mass, its centre and rates "
         "of springs and dampers; without it those of a passenger car")
      ->delimiter(',')
      ->needs(suspension);
  return suspension;
}

/// Returns `--chrono`.
CLI::Option* AddChrono(CLI::App& app, InitCommand& command) {
  CLI::Option* chrono =
      app.add_option("--chrono", command.chrono,
                     "JSON file of a wheeled vehicle of Project Chrono, two axles: write vehicle.urdf with its points, "
                     "masses and laws, at rest");
  app.add_option("--tyre", command.tyres, "JSON file of the tyres of --chrono, or two, FRONT,REAR")
      ->delimiter(',')
      ->expected(1, 2)
      ->needs(chrono);
  return chrono;
}

}  // namespace

void AddOptions(CLI::App& subcommand, InitCommand& command) {
  subcommand
      .add_option("DIR", command.folder,
                  "New or empty folder; with --from also one without a study.yaml, with --suspension or --chrono one "
                  "without a vehicle.urdf")
      ->required();
  CLI::Option* from = AddDraft(subcommand, command);
  CLI::Option* suspension = AddSuspension(subcommand, command)->excludes(from);
  AddChrono(subcommand, command)->excludes(from)->excludes(suspension);
  subcommand.add_flag("--replace", command.replace,
                      "Write over the vehicle.urdf that is there, with --suspension or --chrono");
  subcommand.add_flag("--json", command.json, "Print JSON: the folder and its files");
}

}  // namespace fourpost
