#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Classes of ISO 8608, from very good to worst.
inline constexpr std::array<std::string_view, 8> kRoadClasses = {"A", "B", "C", "D", "E", "F", "G", "H"};

/// Geometric mean of the displacement spectral density of a class at 0.1 cycles/m [m^3]: 16e-6 for A, four times as
/// much for each class after; nothing for another name.
std::optional<double> RoadRoughness(std::string_view road_class);

/// A random road under a vehicle at constant speed. Each track has the one-sided spectral density
///   G(n) = roughness (n / n0)^-2, n0 = 0.1 cycles/m                                                     (ISO 8608)
/// over spatial frequency n, within the band of frequencies n speed that the posts follow; the vehicle enters from and
/// leaves to a level road within a second. Left and right track, b apart, have the coherence of an isotropic surface, x
/// K1(x) with x = 2 pi n b and K1 the modified Bessel function (its G being ~ n^-2; after Kamash and Robson, J. Sound
/// Vib. 57, 1978): long waves are alike on both sides, short ones differ.
struct RandomRoad {
  double roughness_m3 = 0;
  /// m/s.
  double speed = 0;
  double lower_Hz = 0.5;
  double upper_Hz = 30;
  double duration_s = 0;
  std::uint64_t seed = 0;

  /// Motion of the vehicle's posts from t = 0, when the foremost meets the road. Each follows the track of its side,
  /// delayed by its distance from the foremost post over speed. Sides and distances are those of the points of the
  /// tyres in the design pose; posts in line follow one track, a post between two sides their mean. Throws
  /// std::invalid_argument naming the field that is out of bounds.
  PostMotion MotionOf(const Vehicle& vehicle) const;
};

}  // namespace fourpost
