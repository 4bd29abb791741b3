#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// Tyres nearer to each other along the car [m] stand on one axle: both wheels of an axle stand within some
/// centimetres, two axles at least a wheel's diameter apart.
inline constexpr double kSameStation_m = 0.3;

/// A body that moves, and the tyres that it locates.
struct TyreCarrier {
  double mass = 0;
  /// Where its tyres stand along the car [m].
  std::vector<double> stations;
};

/// How many axles stand at these stations.
int AxleCount(std::vector<double> stations);

/// Index of the chassis. A body that locates the tyres of all axles, of several, is it, as a kart's frame. Otherwise
/// the heaviest that locates no tyre, or those of several axles; -1 when there is none, as on a rig that holds the
/// chassis.
int ChassisOf(std::span<const TyreCarrier> bodies);

}  // namespace fourpost
