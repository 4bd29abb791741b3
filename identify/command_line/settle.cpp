#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/settled_file.h"
#include "identify/inspection/file_kind.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/loops/mobility.h"
#include "vehicles/poses/findings.h"
#include "vehicles/poses/settled_pose.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/parameter_setting.h"

namespace fourpost {
namespace {

using SettleJson = nlohmann::ordered_json;

/// A tenth of a micrometre.
constexpr double kAtRest_m = 1e-7;
/// The same at a metre.
constexpr double kAtRest_rad = 1e-7;
constexpr double kDegrees = 180 / std::numbers::pi;

std::string Decimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 0.5 * std::pow(10, -decimals) ? 0 : value);
  return text;
}

std::string InMillimetres(const std::optional<double>& metres) { return metres ? Decimals(1000 * *metres, 3) : "-"; }

/// About x, y and z [rad], of a small turn.
Eigen::Vector3d TurnBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
  return turn.angle() * turn.axis();
}

std::string BodyTable(const Vehicle& vehicle, const SettledPose& pose) {
  TextTable table({"link", "forward, mm", "left, mm", "up, mm", "roll, deg", "pitch, deg", "yaw, deg"});
  for (std::size_t i = 1; i < vehicle.links.size(); ++i) {
    const Eigen::Vector3d shift = 1000 * (pose.rest[i].translation() - pose.design[i].translation());
    const Eigen::Vector3d turn = kDegrees * TurnBetween(pose.design[i], pose.rest[i]);
    table.Add({vehicle.links[i].name, Decimals(shift.x(), 2), Decimals(shift.y(), 2), Decimals(shift.z(), 2),
               Decimals(turn.x(), 3), Decimals(turn.y(), 3), Decimals(turn.z(), 3)});
  }
  return table.Format();
}

std::string StrutTable(const std::vector<SettledPose::Strut>& struts) {
  TextTable table({"element", "as drawn, mm", "at rest, mm", "change, mm", "force, N", "set by", "to stay as drawn, N",
                   "free length, mm"});
  for (const SettledPose::Strut& strut : struts)
    table.Add({strut.element, InMillimetres(strut.design_length), InMillimetres(strut.length),
               InMillimetres(strut.length - strut.design_length), Decimals(strut.force, 1),
               strut.is_held ? "equilibrium" : "file", strut.holding_force ? Decimals(*strut.holding_force, 1) : "-",
               InMillimetres(strut.holding_length)});
  return table.Format();
}

bool IsAtRest(const SettledPose& pose) { return pose.Shift() < kAtRest_m && pose.Turn() < kAtRest_rad; }

/// The body is the link with the largest mass: its turn is what a user sees first.
std::string Headline(const Vehicle& vehicle, const SettledPose& pose) {
  if (IsAtRest(pose)) return vehicle.name + ": the design pose is at rest\n\n";
  std::string text = vehicle.name + ": settles by up to " + Decimals(1000 * pose.Shift(), 2) + " mm and " +
                     Decimals(kDegrees * pose.Turn(), 3) + " deg";
  std::size_t heaviest = 0;
  const std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 1; i < vehicle.links.size(); ++i)
    if (heaviest == 0 || vehicle.links[i].mass.At(values) > vehicle.links[heaviest].mass.At(values)) heaviest = i;
  const Eigen::Vector3d turn = kDegrees * TurnBetween(pose.design[heaviest], pose.rest[heaviest]);
  // As the tables show it.
  constexpr double kSeen_deg = 0.0005;
  if (turn.norm() >= kSeen_deg)
    text += "; '" + vehicle.links[heaviest].name + "' rolls " + Decimals(turn.x(), 3) + " deg and pitches " +
            Decimals(turn.y(), 3) + " deg";
  return text + "\n\n";
}

std::string TextOf(const Vehicle& vehicle, const SettledPose& pose) {
  std::string text = Headline(vehicle, pose);
  text += BodyTable(vehicle, pose) + '\n';
  std::vector<SettledPose::Strut> struts = pose.springs;
  struts.insert(struts.end(), pose.tyres.begin(), pose.tyres.end());
  return text + StrutTable(struts) +
         "Tension positive, of tyres the push on the wheel. What equilibrium sets keeps its length as drawn. To stay "
         "as\n"
         "drawn: forces that hold the design pose, springs and tyres sharing the loads by their rates.\n";
}

SettleJson Six(const Eigen::Isometry3d& design, const Eigen::Isometry3d& rest) {
  const Eigen::Vector3d shift = rest.translation() - design.translation();
  const Eigen::Vector3d turn = TurnBetween(design, rest);
  return {{"shift_m", {shift.x(), shift.y(), shift.z()}}, {"turn_rad", {turn.x(), turn.y(), turn.z()}}};
}

SettleJson StrutsJson(const std::vector<SettledPose::Strut>& struts) {
  SettleJson list = SettleJson::array();
  const auto or_null = [](const std::optional<double>& value) { return value ? SettleJson(*value) : SettleJson(); };
  for (const SettledPose::Strut& strut : struts)
    list.push_back({{"element", strut.element},
                    {"design_length_m", strut.design_length},
                    {"length_m", strut.length},
                    {"force_N", strut.force},
                    {"is_set_by_equilibrium", strut.is_held},
                    {"holding_force_N", or_null(strut.holding_force)},
                    {"holding_free_length_m", or_null(strut.holding_length)}});
  return list;
}

std::string JsonOf(const Vehicle& vehicle, const SettledPose& pose, const Diagnostics& findings) {
  SettleJson links = SettleJson::array();
  for (std::size_t i = 1; i < vehicle.links.size(); ++i) {
    SettleJson link = Six(pose.design[i], pose.rest[i]);
    link["name"] = vehicle.links[i].name;
    links.push_back(link);
  }
  const SettleJson json = {{"vehicle", vehicle.name},
                           {"is_at_rest_as_drawn", IsAtRest(pose)},
                           {"links", links},
                           {"springs", StrutsJson(pose.springs)},
                           {"tyres", StrutsJson(pose.tyres)},
                           {"findings", FindingsJson(findings)}};
  return JsonText(json);
}

bool IsAtRestWithinBounds(const Vehicle& vehicle) {
  try {
    const CondensedVehicle condensed(vehicle);
    return true;
  } catch (const FaultyInput&) {
    return false;
  }
}

/// Written only if it is at rest as it then stands.
void WriteVehicle(const SettleCommand& command, const Vehicle& vehicle, const SettledPose& pose,
                  Diagnostics& findings) {
  const std::filesystem::path folder = std::filesystem::absolute(command.output).parent_path();
  const StatedForces stated = command.equilibrium ? StatedForces::kLeftToEquilibrium : StatedForces::kKept;
  const Holding holding = command.hold == "preload" ? Holding::kPreload : Holding::kFreeLength;
  const std::string text = command.hold.empty() ? SettledText(vehicle, pose, stated, folder, findings)
                                                : HeldText(vehicle, pose, holding, folder, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  Diagnostics faults;
  const std::optional<Vehicle> written = ReadVehicleText(text, command.output, faults);
  if (!written) throw FaultyInput(faults);
  const std::optional<SettledPose> again = Settle(*written, written->ParameterValues());
  // Newton's method ends within a micrometre of rest.
  if (!again || again->Shift() > 1e-6) Refuse(kSettledFileMoves, {vehicle.file});
  if (!IsAtRestWithinBounds(*written)) findings.Report(kSettledAtOneValue, {command.output.string()});
  ReplaceFile(command.output, text);
}

}  // namespace

int Run(const SettleCommand& command) {
  RequireVehicleFile(command.model);
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(command.model, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.set, *vehicle, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  RequireEnding("--output", command.output, "a vehicle file", ".urdf");
  RequireWritable(command.output, {command.model});
  MobilityOf(*vehicle);
  const std::optional<SettledPose> pose = Settle(*vehicle, vehicle->ParameterValues());
  if (!pose) Refuse(kDoesNotSettle, {vehicle->file});
  if (!command.output.empty()) WriteVehicle(command, *vehicle, *pose, findings);
  Tell(findings);
  if (command.json) Print(JsonOf(*vehicle, *pose, findings));
  else PrintText(TextOf(*vehicle, *pose));
  return kGood;
}

}  // namespace fourpost
