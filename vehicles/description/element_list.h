#pragma once

#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost {

/// A point that a vehicle's file gives to an element.
struct ElementPoint {
  /// As messages call it: "fp:spring 'coil'", "link 'axle'".
  std::string element;
  /// Which of its points: "parent's end", "centre of mass".
  const char* part = "";
  int line = 0;
  Point point;
};

/// Of all two-ended elements, loop closures, tyres and centres of mass; not of sensors.
std::vector<ElementPoint> PointsOf(const Vehicle& vehicle);
/// Of accelerometers and displacement sensors.
std::vector<ElementPoint> SensorPointsOf(const Vehicle& vehicle);

/// A number that a vehicle's file gives to an element.
struct ElementNumber {
  std::string element;
  /// What it is: "stiffness", "bump gap".
  std::string noun;
  int line = 0;
  /// Of the attribute that it stands in; nullptr for none.
  const AttributeRule* rule = nullptr;
  Scalar number;
  /// Whether the linear model takes it as it is; else it bends a law that this model replaces by a rate.
  bool is_linear = true;
};

/// Masses, and all numbers of the elements; those that a file leaves out have their default.
std::vector<ElementNumber> NumbersOf(const Vehicle& vehicle);

/// Of each parameter, whether it is in a law that the linear model replaces by a rate.
std::vector<bool> AreInCurvedLaws(const Vehicle& vehicle);

/// "fp:tyre 'FL'".
std::string Called(const char* tag, const std::string& name);

/// The number with three digits in the unit given, or where there is none in a multiple of the SI unit in which it lies
/// between 1 and 1000 if that can be: "280 N/m".
std::string Readable(double si, const std::string& si_unit, const std::string& unit = "");

}  // namespace fourpost
