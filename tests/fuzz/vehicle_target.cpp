#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/fuzz/fuzz_target.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/lint/vehicle_lint.h"
#include "vehicles/loops/mobility.h"
#include "vehicles/reader/resolved_text.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {
namespace {

/// Larger vehicles take the time of many small ones.
constexpr std::size_t kMostLinks = 40;
constexpr std::size_t kMostCoordinates = 60;
constexpr std::size_t kMostElements = 100;
/// What `fourpost check` tells takes longer than the model itself.
constexpr std::size_t kMostLinksToCheck = 12;

/// Stands nowhere; beside it stand the shipped vehicles, whose meshes are found from there.
std::filesystem::path File() { return std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf/fuzz.urdf"; }

/// Nothing must be refused without a word, or read with an error.
std::optional<Vehicle> Read(const std::string& text, Diagnostics& diagnostics) {
  std::optional<Vehicle> vehicle = ReadVehicleText(text, File(), diagnostics);
  Require(vehicle.has_value() != diagnostics.HasErrors(), "a file reads when it has no error", diagnostics.Format());
  return vehicle;
}

/// The parameters' values, or their upper bounds.
std::vector<double> UpperBounds(const Vehicle& vehicle) {
  std::vector<double> values;
  for (const Parameter& parameter : vehicle.parameters) values.push_back(parameter.upper);
  return values;
}

void CheckText(const Vehicle& vehicle) {
  const std::filesystem::path folder = File().parent_path();
  Require(VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder) == vehicle.text,
          "its own values leave the text of a file as it is");
  const std::vector<double> values = UpperBounds(vehicle);
  const std::string text = VehicleTextWithValues(vehicle, values, folder);
  Diagnostics diagnostics;
  const std::optional<Vehicle> changed = Read(text, diagnostics);
  Require(changed.has_value(), "a file reads at the upper bounds of its parameters", diagnostics.Format());
  Require(changed->ParameterValues() == values, "values read back to the last digit", text);
}

void CheckResolvedText(const Vehicle& vehicle) {
  const std::string text = ResolvedText(vehicle, File().parent_path());
  Diagnostics diagnostics;
  const std::optional<Vehicle> again = Read(text, diagnostics);
  Require(again.has_value(), "a resolved file reads", diagnostics.Format());
  Require(again->ParameterValues() == vehicle.ParameterValues(), "a resolved file has the same values", text);
  Require(ResolvedText(*again, File().parent_path()) == text, "a resolved file has nothing more to fill in", text);
}

bool IsSmall(const Vehicle& vehicle) {
  std::size_t coordinates = 0;
  for (const Joint& joint : vehicle.joints)
    coordinates += joint.type == Joint::Type::kFloating ? 6 : joint.type == Joint::Type::kPlanar ? 3 : 1;
  const std::size_t elements = vehicle.springs.size() + vehicle.dampers.size() + vehicle.tyres.size() +
                               vehicle.bushings.size() + vehicle.antiroll_bars.size() + vehicle.sensors.size() +
                               vehicle.rods.size() + vehicle.balls.size() + vehicle.welds.size() +
                               vehicle.hinges.size();
  return vehicle.links.size() <= kMostLinks && coordinates <= kMostCoordinates && elements <= kMostElements;
}

/// What `fourpost check` does.
void CheckTold(const Vehicle& vehicle) {
  MobilityOf(vehicle);
  Require(!LintDescription(vehicle).HasErrors() && !LintAssembled(vehicle).HasErrors(),
          "a vehicle that assembles is warned of, not refused");
  Summarise(vehicle, vehicle.ParameterValues());
}

void CheckModel(const Vehicle& vehicle) {
  try {
    const CondensedVehicle condensed(vehicle);
    condensed.At(vehicle.ParameterValues());
    if (vehicle.links.size() <= kMostLinksToCheck) CheckTold(vehicle);
  } catch (const FaultyInput& fault) {
    Require(fault.diagnostics().HasErrors(), "a vehicle is refused for an error", fault.what());
  }
}

}  // namespace

void FuzzVehicle(const std::string& bytes) {
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle = Read(bytes, diagnostics);
  if (!vehicle) return;
  CheckText(*vehicle);
  CheckResolvedText(*vehicle);
  if (IsSmall(*vehicle)) CheckModel(*vehicle);
}

}  // namespace fourpost
