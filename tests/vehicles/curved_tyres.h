#pragma once

#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A new parameter, free between half and twice its value.
inline Scalar AddParameter(Vehicle& vehicle, const std::string& name, double value, Dimension dimension,
                           const std::string& unit) {
  vehicle.parameters.push_back({.name = name,
                                .value = value,
                                .lower = 0.5 * value,
                                .upper = 2 * value,
                                .precision = 0.01 * value,
                                .dimension = dimension,
                                .unit = unit,
                                .source = "test"});
  return {.value = value, .parameter = static_cast<int>(vehicle.parameters.size()) - 1};
}

/// Tyres whose rate rises by the parameter q_tyre [1/m], from `share` of what it was.
inline void MakeProgressive(Vehicle& vehicle, double progression, double share = 1) {
  const Scalar q = AddParameter(vehicle, "q_tyre", progression, kPerLength, "1/m");
  for (Tyre& tyre : vehicle.tyres) {
    tyre.law.progression = q;
    tyre.law.stiffness.value *= share;
    tyre.law.stiffness.factor *= share;
    tyre.lifts_off = true;
  }
}

/// Tyres on a measured curve, whose forces the parameter s_tyre scales; it begins at 4 mm, and its rate doubles.
inline void MeasureTyres(Vehicle& vehicle) {
  const Scalar scale = AddParameter(vehicle, "s_tyre", 1, kDimensionless, "1");
  for (Tyre& tyre : vehicle.tyres) {
    tyre.law = {};
    for (const auto& [mm, force] : {std::pair(4.0, 0.0), std::pair(9.0, 900.0), std::pair(19.0, 3100.0),
                                    std::pair(34.0, 7200.0), std::pair(54.0, 13500.0)})
      tyre.law.table.push_back({{1e-3 * mm}, {.value = force, .parameter = scale.parameter, .factor = force}});
    tyre.lifts_off = true;
  }
}

}  // namespace fourpost
