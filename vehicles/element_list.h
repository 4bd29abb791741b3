#pragma once

#include <string>
#include <vector>

#include "vehicles/vehicle.h"

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

/// What sort of number it is, and where it usually lies on road vehicles, with a decade to spare on either side or
/// more.
struct NumberKind {
  const char* noun = "";
  const char* si_unit = "";
  double least = 0;
  double greatest = 0;
};

/// A number that a vehicle's file gives to an element.
struct ElementNumber {
  std::string element;
  int line = 0;
  NumberKind kind;
  Scalar number;
};

/// Rates, masses and radii; a wheel's, a bushing's, an anti-roll bar's ...
std::vector<ElementNumber> NumbersOf(const Vehicle& vehicle);

/// "fp:tyre 'FL'".
std::string Called(const char* tag, const std::string& name);

/// The number with three digits in the unit given, or where there is none in a multiple of the SI unit in which it lies
/// between 1 and 1000 if that can be: "280 N/m".
std::string Readable(double si, const std::string& si_unit, const std::string& unit = "");

}  // namespace fourpost
