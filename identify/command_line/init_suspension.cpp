#include "identify/command_line/init_suspension.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "vehicles/chrono/chrono_text.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/option_quantity.h"
#include "vehicles/templates/findings.h"
#include "vehicles/templates/suspension_vehicle.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVehicleFile = "vehicle.urdf";
constexpr const char* kPointsFile = "points.csv";

bool IsSameFile(const fs::path& one, const fs::path& other) {
  std::error_code failure;
  return !one.empty() && fs::equivalent(one, other, failure);
}

/// The folder's name in letters that a vehicle's name may have.
std::string VehicleName(const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(folder));
  std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
  return name.empty() ? "car" : name;
}

/// What must not be lost.
void CheckPlaces(const InitCommand& command) {
  std::error_code failure;
  const fs::path vehicle = command.folder / kVehicleFile;
  const fs::path points = command.folder / kPointsFile;
  const bool writes_points = command.chrono.empty();
  if (fs::exists(command.folder, failure) && !fs::is_directory(command.folder, failure))
    RefuseToWrite(kStarterFolderIsFile, command.folder);
  if (!command.replace && fs::exists(vehicle, failure)) RefuseToWrite(kVehicleIsThere, vehicle);
  if (writes_points && fs::exists(points, failure) && !IsSameFile(command.points, points))
    RefuseToWrite(kPointsAreThere, points, {points.string()});
}

/// All or none.
void WriteFiles(const fs::path& folder, const std::string& vehicle, const std::string& points) {
  std::error_code failure;
  const std::vector<fs::path> missing = MissingFolders(fs::weakly_canonical(fs::absolute(folder)));
  try {
    fs::create_directories(folder, failure);
    if (failure) RefuseToWrite(folder, failure);
    if (!points.empty()) WriteFile(folder / kPointsFile, points);
    ReplaceFile(folder / kVehicleFile, vehicle);
  } catch (const OutputError&) {
    if (!points.empty()) fs::remove(folder / kPointsFile, failure);
    RemoveFolders(missing);
    throw;
  }
}

/// Of both axles; empty without --load, or after an error.
std::optional<AxleLoads> LoadsOf(const std::vector<std::string>& texts, Diagnostics& findings) {
  if (texts.empty()) return std::nullopt;
  constexpr std::array<const char*, 2> kAxles = {"front", "rear"};
  AxleLoads loads = {};
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string axle = text.substr(0, equals);
    const std::size_t i = axle == "front" ? 0 : 1;
    if (equals == text.size() || axle != kAxles[i]) {
      findings.Report(kAxleLoadMalformed, Place::Option("--load"), {text});
      continue;
    }
    if (loads[i] != 0) findings.Report(kAxleLoadTwice, Place::Option("--load"), {axle});
    loads[i] = ReadQuantity(text.substr(equals + 1), kMass, "--load", findings).value_or(1);
  }
  for (std::size_t i = 0; i < kAxles.size(); ++i)
    if (!findings.HasErrors() && loads[i] == 0)
      findings.Report(kAxleLoadMissing, Place::Option("--load"), {kAxles[i], kAxles[i]});
  return loads;
}

std::string SuspensionSteps(const InitCommand& command, bool has_new_points) {
  const std::string vehicle = (command.folder / kVehicleFile).string();
  const std::string points = (command.folder / kPointsFile).string();
  std::string text = "wrote\n  " + vehicle + "\n";
  if (has_new_points) text += "  " + points + "\n";
  text += "next\n  fourpost check " + vehicle + "\n  fourpost kinematics " + vehicle + "\n";
  if (!command.points.empty() || !command.chrono.empty()) return text;
  std::string choice;
  for (const std::string& one : command.suspension) choice += (choice.empty() ? "" : ",") + one;
  return text + "with points of your own, after editing " + points + "\n  fourpost init " + command.folder.string() +
         " --suspension " + choice + " --points " + points + " --replace\n";
}

}  // namespace

int RunInitSuspension(const InitCommand& command) {
  Diagnostics findings;
  const auto kinds = ChosenSuspensions(command.suspension, findings);
  const std::optional<AxleLoads> loads = LoadsOf(command.load, findings);
  if (!kinds || findings.HasErrors()) throw FaultyInput(findings);
  const std::vector<HardPoint> points =
      command.points.empty() ? UsualPoints(*kinds) : ReadHardPoints(command.points, findings);
  const bool was_read = !findings.HasErrors() || !points.empty();
  const CarPoints car = was_read ? SortedPoints(*kinds, points, command.points.string(), findings) : CarPoints{};
  if (findings.HasErrors()) throw FaultyInput(findings);
  CheckPlaces(command);
  const std::string source = command.points.empty() ? "plausible ones of no car" : command.points.filename().string();
  const std::string place = command.points.empty() ? (command.folder / kPointsFile).string() : command.points.string();
  const std::string vehicle = SuspensionVehicleText(car, loads, VehicleName(command.folder), source, place, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  const bool has_new_points = !IsSameFile(command.points, command.folder / kPointsFile);
  WriteFiles(command.folder, vehicle, has_new_points ? PointsText(car) : "");
  Tell(findings);
  if (command.json) {
    nlohmann::ordered_json files = {kVehicleFile};
    if (has_new_points) files.push_back(kPointsFile);
    Print(JsonText(nlohmann::ordered_json{
        {"folder", command.folder.string()}, {"files", files}, {"findings", FindingsJson(findings)}}));
  } else {
    PrintText(SuspensionSteps(command, has_new_points));
  }
  return kGood;
}

int RunInitChrono(const InitCommand& command) {
  CheckPlaces(command);
  Diagnostics findings;
  const std::string place = (command.folder / kVehicleFile).string();
  const std::string vehicle =
      ChronoVehicleText(command.chrono, command.tyres, VehicleName(command.folder), place, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  WriteFiles(command.folder, vehicle, "");
  Tell(findings);
  if (command.json)
    Print(JsonText(nlohmann::ordered_json{
        {"folder", command.folder.string()}, {"files", {kVehicleFile}}, {"findings", FindingsJson(findings)}}));
  else PrintText(SuspensionSteps(command, false));
  return kGood;
}

}  // namespace fourpost
