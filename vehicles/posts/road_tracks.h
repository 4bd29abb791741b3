#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Classes of ISO 8608, from very good to worst.
inline constexpr std::array<std::string_view, 8> kRoadClasses = {"A", "B", "C", "D", "E", "F", "G", "H"};

/// Geometric mean of the displacement spectral density of a class at 0.1 cycles/m [m^3]: 16e-6 for A, four times as
/// much for each class after; nothing for another name.
std::optional<double> RoadRoughness(std::string_view road_class);

/// One-sided spectral density of a track's heights over frequency [m^2/Hz] at a speed [m/s],
///   G(n) / speed,  G(n) = roughness (n / n0)^-2,  n = frequency / speed,  n0 = 0.1 cycles/m               (ISO 8608)
double RoadDensity(double roughness_m3, double speed, double frequency_Hz);

/// Coherence of two tracks of an isotropic surface with G ~ n^-2, `distance` apart, x K1(x) with x = 2 pi n distance
/// and K1 the modified Bessel function (after Kamash and Robson, J. Sound Vib. 57, 1978): long waves are alike on both,
/// short ones differ. `spatial_frequency`: n [cycles/m].
double TrackCoherence(double spatial_frequency, double distance);

/// How a vehicle's posts lie along the two tracks of a road, by the points of the tyres in the design pose.
struct RoadTracks {
  struct Place {
    /// +1: on the left track, or the only one; -1: on the right; 0: between them, on their mean.
    int side = 1;
    /// Distance from the foremost post [m].
    double behind = 0;
  };

  /// In the order of Vehicle::posts.
  std::vector<Place> posts;
  /// Of left and right track [m]; 0: one track.
  double distance = 0;

  /// Of the last post [m].
  double length() const;
};

RoadTracks RoadTracksOf(const Vehicle& vehicle);

}  // namespace fourpost
