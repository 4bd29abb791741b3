#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fourpost {

/// Exponents of the SI base units; angles are dimensionless.
struct Dimension {
  int kilogram = 0;
  int metre = 0;
  int second = 0;
  bool operator==(const Dimension&) const = default;
};

inline constexpr Dimension kDimensionless{};
inline constexpr Dimension kMass{1, 0, 0};
inline constexpr Dimension kLength{0, 1, 0};
inline constexpr Dimension kTime{0, 0, 1};
inline constexpr Dimension kVelocity{0, 1, -1};
inline constexpr Dimension kAcceleration{0, 1, -2};
inline constexpr Dimension kForce{1, 1, -2};
inline constexpr Dimension kStiffness{1, 0, -2};
inline constexpr Dimension kDamping{1, 0, -1};
inline constexpr Dimension kInertia{1, 2, 0};
inline constexpr Dimension kFrequency{0, 0, -1};
inline constexpr Dimension kPressure{1, -1, -2};
inline constexpr Dimension kFlowResistance{0, -1, -1};  // pressure per mass flow
inline constexpr Dimension kArea{0, 2, 0};
inline constexpr Dimension kVolume{0, 3, 0};
inline constexpr Dimension kCubicStiffness{1, -2, -2};
inline constexpr Dimension kTorque{1, 2, -2};
inline constexpr Dimension kAngularDamping{1, 2, -1};
inline constexpr Dimension kDensity{1, -3, 0};
inline constexpr Dimension kPerLength{0, -1, 0};

/// A unit such as "kN*s/m": its size in SI and its dimension.
struct Unit {
  double si = 1;
  Dimension dimension;
};

/// Reads a product of units with powers, from left to right: "N/mm", "kN*s/m", "kg*m^2", "1/s", "s^-2", "deg", "%".
/// Names: those of kScales, g for grams, in and lbf too. Powers: -9..9 but not 0. No blanks.
/// Nothing for an unknown name. Hz is 1/s as rad/s is: a frequency in rad/s is not converted to cycles.
std::optional<Unit> ParseUnit(std::string_view text);

/// A number with a unit, as a user writes it.
struct Quantity {
  double si = 0;
  Unit unit;
  /// The unit as written, 1/m of "3/m"; empty when there was none.
  std::string unit_text;
};

/// Reads "32 N/mm" or "0.3"; the number must be finite. Nothing when the text is not a number with a known unit.
/// Powers of ten are exact: "1.1 mm" is the double 0.0011.
std::optional<Quantity> ParseQuantity(std::string_view text);

/// The usual SI unit of a dimension: "N/m" for a stiffness, "kg*m^2" for an inertia, "1" for a pure number.
std::string SiUnit(const Dimension& dimension);

/// The unit that was most likely meant with a bare number of this size, of a vehicle's part: "mm" for a length of 30,
/// "N/mm" for a stiffness of 32, "N/m" for one of 32000; the SI unit where only one is usual.
std::string LikelyUnit(const Dimension& dimension, double number);

/// What a dimension is called: "stiffness"; the SI unit where it has no name.
std::string DimensionName(const Dimension& dimension);

/// The number in this unit, at the fewest digits that ParseQuantity reads back to the same double: "31.42 N/mm".
/// Only in degrees some doubles cannot be reached; the nearest is given then, one rounding away.
/// No unit is shown for "" and "1". Throws std::invalid_argument for an unknown unit.
std::string FormatQuantity(double si, const std::string& unit_text);

}  // namespace fourpost
