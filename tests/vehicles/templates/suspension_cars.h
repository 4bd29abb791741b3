#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/findings.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/templates/suspension_vehicle.h"

/// Cars that `fourpost init --suspension` would write.
namespace fourpost::suspension_cars {

using Kinds = std::array<const SuspensionKind*, 2>;

inline Kinds KindsOf(std::string_view front, std::string_view rear) {
  return {FindSuspensionKind(front), FindSuspensionKind(rear)};
}

inline std::string TextOf(const Kinds& kinds, const std::vector<HardPoint>& points, Diagnostics& findings) {
  const CarPoints car = SortedPoints(kinds, points, "points.csv", findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  return SuspensionVehicleText(car, {}, "car", "of a test", "points.csv", findings);
}

inline Vehicle VehicleOf(const Kinds& kinds, const std::vector<HardPoint>& points) {
  Diagnostics findings;
  const std::string text = TextOf(kinds, points, findings);
  const std::optional<Vehicle> vehicle = ReadVehicleText(text, "car.urdf", findings);
  if (!vehicle || !findings.items().empty()) throw FaultyInput(findings);
  return *vehicle;
}

/// The usual points without anti-roll bars.
inline std::vector<HardPoint> WithoutBars(std::vector<HardPoint> points) {
  std::erase_if(points, [](const HardPoint& p) { return p.name == "bar_end" || p.name == "drop_link"; });
  return points;
}

}  // namespace fourpost::suspension_cars
