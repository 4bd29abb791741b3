#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// Tyres nearer to each other along the car [m] belong to one axle: both wheels of an axle stand within some
/// centimetres, two axles at least a wheel's diameter apart.
inline constexpr double kSameStation_m = 0.3;

/// A body that moves, and the tyres that it locates.
struct TyreCarrier {
  double mass = 0;
  /// Positions of its tyres along the car [m].
  std::vector<double> stations;
};

/// Number of axles at these positions.
int AxleCount(std::vector<double> stations);

/// Index of the chassis. It is the body that locates the tyres of all axles or of several, such as a kart's frame.
/// Otherwise it is the heaviest body that locates no tyre, or those of several axles; -1 if there is none, as on a rig
/// that holds the chassis.
int ChassisOf(std::span<const TyreCarrier> bodies);

}  // namespace fourpost
