#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {

/// A vehicle of urdf/, which must read without a finding.
inline Vehicle ShippedVehicle(const std::string& name) {
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / (name + ".urdf"), diagnostics);
  EXPECT_EQ(diagnostics.Format(), "");
  return vehicle.value();
}

/// With tyres that pull as they push, as the written-out equations have them.
inline Vehicle WithLinearTyres(Vehicle vehicle) {
  for (Tyre& tyre : vehicle.tyres) tyre.lifts_off = false;
  return vehicle;
}

/// Gives a parameter another value.
inline void Set(Vehicle& vehicle, const std::string& parameter, double value) {
  for (Parameter& candidate : vehicle.parameters)
    if (candidate.name == parameter) {
      candidate.value = value;
      return;
    }
  ADD_FAILURE() << "no parameter " << parameter;
}

inline double ValueOf(const Vehicle& vehicle, const std::string& parameter) {
  for (const Parameter& candidate : vehicle.parameters)
    if (candidate.name == parameter) return candidate.value;
  ADD_FAILURE() << "no parameter " << parameter;
  return 0;
}

/// Index of a link.
inline int LinkOf(const Vehicle& vehicle, const std::string& link) {
  for (std::size_t i = 0; i < vehicle.links.size(); ++i)
    if (vehicle.links[i].name == link) return static_cast<int>(i);
  ADD_FAILURE() << "no link " << link;
  return 0;
}

/// What makes the vehicle impossible to condense.
inline Diagnostics Fault(const Vehicle& vehicle) {
  try {
    const CondensedVehicle condensed(vehicle);
  } catch (const FaultyInput& fault) {
    return fault.diagnostics();
  }
  return {};
}

}  // namespace fourpost
