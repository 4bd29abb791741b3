#pragma once

#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A point of an element, as given in a vehicle's file.
struct ElementPoint {
  /// Name in messages: "fp:spring 'coil'", "link 'axle'".
  std::string element;
  /// Which point of the element: "parent's end", "centre of mass".
  const char* part = "";
  int line = 0;
  Point point;
};

/// Points of all two-ended elements, loop closures, tyres and centres of mass; not of sensors.
std::vector<ElementPoint> PointsOf(const Vehicle& vehicle);
/// Points of accelerometers and displacement sensors.
std::vector<ElementPoint> SensorPointsOf(const Vehicle& vehicle);

/// A number of an element, as given in a vehicle's file.
struct ElementNumber {
  std::string element;
  /// Its meaning: "stiffness", "bump gap".
  std::string noun;
  int line = 0;
  /// Where a vehicle file states it: tag, "fp:damper/linear", and attribute.
  std::string tag;
  std::string attribute;
  Scalar number;
  /// Whether the linear model uses it directly; otherwise it bends a law that this model replaces by a rate.
  bool is_linear = true;
};

/// Masses, and all numbers of the elements; numbers missing in the file have their default.
std::vector<ElementNumber> NumbersOf(const Vehicle& vehicle);

/// For each parameter, whether it is in a law that the linear model replaces by a rate.
std::vector<bool> AreInCurvedLaws(const Vehicle& vehicle);

/// "fp:tyre 'FL'".
std::string Called(const char* tag, const std::string& name);

/// The number with three digits in the given unit, or without one in a multiple of the SI unit in which it lies between
/// 1 and 1000 if possible: "280 N/m".
std::string Readable(double si, const std::string& si_unit, const std::string& unit = "");

}  // namespace fourpost
