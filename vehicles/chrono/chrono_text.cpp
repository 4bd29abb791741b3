#include "vehicles/chrono/chrono_text.h"

#include <algorithm>
#include <array>
#include <optional>

#include "vehicles/chrono/chrono_vehicle.h"
#include "vehicles/chrono/findings.h"
#include "vehicles/poses/settled_pose.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/templates/suspension_vehicle.h"

namespace fourpost {
namespace {

constexpr std::array<const char*, 2> kAxlePrefixes = {"front_", "rear_"};

/// Of the left side's parts in the frame of the chassis.
std::array<ChronoMotion, 2> MotionsOf(const Vehicle& vehicle, const SettledPose& pose) {
  std::array<ChronoMotion, 2> motions;
  const auto body =
      std::find_if(vehicle.links.begin(), vehicle.links.end(), [](const Link& link) { return link.name == "body"; });
  const auto chassis = static_cast<std::size_t>(body - vehicle.links.begin());
  for (std::size_t i = 1; i < vehicle.links.size(); ++i)
    for (std::size_t axle = 0; axle < 2; ++axle) {
      std::string part = vehicle.links[i].name;
      if (!part.starts_with(kAxlePrefixes[axle]) || part.ends_with("_right")) continue;
      part.erase(0, std::string_view(kAxlePrefixes[axle]).size());
      if (part.ends_with("_left")) part.resize(part.size() - 5);
      motions[axle][part] =
          pose.rest[chassis].inverse() * pose.rest[i] * pose.design[i].inverse() * pose.design[chassis];
    }
  return motions;
}

/// As the car comes to rest; nothing, reported, where it does not.
std::optional<std::array<ChronoMotion, 2>> MotionToRest(const std::string& text, const std::string& place,
                                                        const std::filesystem::path& file, Diagnostics& diagnostics) {
  std::string reason = "it finds no pose at rest";
  try {
    Diagnostics faults;
    if (const std::optional<Vehicle> vehicle = ReadVehicleText(text, place, faults)) {
      const std::optional<SettledPose> pose = Settle(*vehicle, vehicle->ParameterValues());
      if (pose) return MotionsOf(*vehicle, *pose);
    } else if (!faults.items().empty()) {
      reason = faults.items()[0].message;
    }
  } catch (const FaultyInput& fault) {
    reason = fault.diagnostics().items()[0].message;
  }
  diagnostics.Report(kChronoNotSettled, {file.string()}, {reason});
  return std::nullopt;
}

}  // namespace

std::string ChronoVehicleText(const std::filesystem::path& file, const std::vector<std::filesystem::path>& tyres,
                              const std::string& name, const std::string& place, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<ChronoVehicle> car = ReadChronoVehicle(file, tyres, {}, found);
  // Warnings of this text are those of the one that is written.
  Diagnostics faults;
  const std::string loaded =
      car ? KnownVehicleText(car->points, car->car, name, place, StatedLoads::kAsStated, faults) : "";
  if (loaded.empty()) {
    diagnostics.Add(found);
    diagnostics.Add(faults);
    return {};
  }
  if (const auto motion = MotionToRest(loaded, place, file, diagnostics)) {
    // Once more, for what depends on lengths, with the findings about these.
    found = {};
    car = ReadChronoVehicle(file, tyres, *motion, found);
  }
  diagnostics.Add(found);
  if (!car) return {};
  return KnownVehicleText(car->points, car->car, name, place, StatedLoads::kLeftToEquilibrium, diagnostics);
}

}  // namespace fourpost
