#include <cmath>
#include <optional>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/number.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/kinematics_text.h"
#include "identify/command_line/print.h"
#include "identify/command_line/results_line.h"
#include "identify/inspection/file_kind.h"
#include "identify/report/kinematics_page.h"
#include "identify/run/result_kind.h"
#include "vehicles/loops/mobility.h"
#include "vehicles/poses/findings.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/kinematics_files.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/travel_range.h"

namespace fourpost {
namespace {

std::string InMm(double metres) { return FormatNumber(std::round(metres * 1e5) + 0.0, -2) + " mm"; }

/// A rigid linkage ends at a dead centre; one that yields also where its springs, bushes and stops hold it no more.
void WarnOfShortTravels(SuspensionRig& rig, const std::vector<AxleKinematics>& axles, Diagnostics& findings) {
  const bool is_rigid = rig.IsRigid(rig.Design());
  for (const AxleKinematics& kinematics : axles)
    for (const AxleTravel& travel : kinematics.travels)
      if (travel.reached_lower != travel.lower || travel.reached_upper != travel.upper)
        findings.Report(is_rigid ? kTravelNotReached : kTravelNotHeld, {rig.vehicle().file},
                        {travel.name, rig.suspension().axles[kinematics.axle].name, InMm(travel.reached_lower),
                         InMm(travel.reached_upper), InMm(travel.lower), InMm(travel.upper)});
}

void Write(const std::filesystem::path& folder, const std::string& json, SuspensionRig& rig,
           const std::vector<AxleKinematics>& axles, const Diagnostics& findings) {
  const Suspension& suspension = rig.suspension();
  OutputFolder output(folder);
  output.Add("wheels.csv", WheelsCsv(suspension, axles));
  output.Add("ratios.csv", RatiosCsv(suspension, axles));
  output.Add("compliance.csv", ComplianceCsv(suspension, axles));
  for (const AxleKinematics& kinematics : axles)
    output.Add("axle_" + std::to_string(kinematics.axle + 1) + ".svg",
               KinematicsSvg(rig.vehicle(), suspension, kinematics));
  output.Add(kPageName, KinematicsPage(rig, axles, findings));
  output.Add("result.json", json);
  output.Commit();
  PrintResultsLine(folder);
}

}  // namespace

int Run(const KinematicsCommand& command) {
  RequireVehicleFile(command.model);
  Diagnostics findings;
  std::optional<Vehicle> read = ReadVehicle(command.model, findings);
  if (!read) throw FaultyInput(findings);
  Vehicle& vehicle = *read;
  SetParameters(command.set, vehicle, findings);
  const TravelRange range = ReadTravelRange(command.travel, command.step, findings);
  if (vehicle.tyres.empty()) findings.Report(kNoWheels, {vehicle.file});
  if (findings.HasErrors()) throw FaultyInput(findings);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.model}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kKinematics);
    OutputFolder{command.output};
  }
  MobilityOf(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  SuspensionRig rig(vehicle, values);
  const std::vector<AxleKinematics> axles = KinematicsOf(rig, values, range);
  if (axles.empty()) Refuse(kWheelsDoNotTravel, {vehicle.file});
  WarnOfShortTravels(rig, axles, findings);
  Tell(findings);
  const std::string json = KinematicsJson(vehicle, rig.suspension(), axles, findings);
  if (!command.output.empty()) Write(command.output, json, rig, axles, findings);
  if (command.json) Print(json);
  else PrintText(KinematicsText(rig.suspension(), axles));
  return kGood;
}

}  // namespace fourpost
