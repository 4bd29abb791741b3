#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "vehicles/ride/suspension.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

// Ride geometry of the suspension in the design pose, chassis held: see HeldChassis for the boundary conditions,
// Suspension for the definition of the chassis. SI.

/// Rates at a wheel. The wheel rate is the vertical force at the wheel per rise of its foot, including the change of
/// motion ratios under preload, without the tyre; the ride rate is the wheel rate in series with the tyre,
///   ride = wheel tyre / (wheel + tyre).
/// Infinite if the wheel cannot move.
struct WheelRates {
  struct Rates {
    double wheel_Npm = std::numeric_limits<double>::infinity();
    double ride_Npm = 0;
  };
  double tyre_Npm = 0;
  /// This wheel alone moves, the others are held; includes its share of an anti-roll bar or a beam axle.
  Rates alone;
  /// All wheels of the axle move together.
  Rates together;
};

/// Moment about the longitudinal axis per roll of the axle's wheels against the chassis [N m/rad], tyres rigid; empty
/// for an axle that has one side only or cannot roll.
struct AxleRates {
  std::optional<double> roll_Nm;
};

/// A spring, a damper or an anti-roll bar, and its motion ratio to a wheel. Motion ratio = shortening of the element
/// per rise of the wheel; for an anti-roll bar, change of e_right - e_left.
struct StrutGeometry {
  /// In the design pose [m]; for an anti-roll bar, the difference of its lines' lengths.
  double length_m = 0;
  /// In the design pose [N/m]; for a damper its mean rate [N s/m] without mount and friction.
  double rate = 0;
  /// Index in Suspension::wheels of the wheel that, moved alone, moves it most; -1: none moves it.
  int wheel = -1;
  /// Motion ratio if that wheel moves alone; empty if it cannot.
  std::optional<double> alone;
  /// If all wheels of its axle move together; empty if they cannot.
  std::optional<double> together;
};

struct RideGeometry {
  /// Orders of Suspension::wheels and axles.
  std::vector<WheelRates> wheels;
  std::vector<AxleRates> axles;
  /// Orders of Vehicle::springs, dampers and antiroll_bars.
  std::vector<StrutGeometry> springs;
  std::vector<StrutGeometry> dampers;
  std::vector<StrutGeometry> antiroll_bars;
  /// Share of each moving body's weight that the wheels carry as they rise together, sum of m dz/d(rise) [kg]; for an
  /// arm between chassis and wheel the share of its outer end. Empty without wheels, or if they cannot rise.
  std::optional<double> unsprung_mass_kg;
};

/// `pose`: the design pose. `tyre_loads`: there [N].
RideGeometry RideGeometryOf(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                            const HeldChassis& held, std::span<const double> tyre_loads,
                            std::span<const double> parameters);

}  // namespace fourpost
