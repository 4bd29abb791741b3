#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "vehicles/ride/suspension.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

// What a chassis engineer knows a suspension by, in the design pose, chassis held: see HeldChassis for what moves and
// what is held, Suspension for what the chassis is. SI.

/// Rates at a wheel. The wheel rate is the vertical force at the wheel per rise of its foot, with the change of motion
/// ratios under preload, without the tyre; the ride rate is the wheel rate in series with the tyre,
///   ride = wheel tyre / (wheel + tyre).
/// Infinite where the wheel cannot move.
struct WheelRates {
  struct Rates {
    double wheel_Npm = std::numeric_limits<double>::infinity();
    double ride_Npm = 0;
  };
  double tyre_Npm = 0;
  /// This wheel alone moves, the others are held; it shares what an anti-roll bar or a beam axle adds.
  Rates alone;
  /// All wheels of the axle move together.
  Rates together;
};

/// Moment about the longitudinal axis per roll of the axle's wheels against the chassis [N m/rad], tyres rigid; nothing
/// for an axle that has one side only or cannot roll.
struct AxleRates {
  std::optional<double> roll_Nm;
};

/// A spring, a damper or an anti-roll bar, and how it follows a wheel. Motion ratio = compression of the element per
/// rise of the wheel; of an anti-roll bar, change of e_right - e_left.
struct StrutGeometry {
  /// In the design pose [m]; of an anti-roll bar, the difference of its lines' lengths.
  double length_m = 0;
  /// In the design pose [N/m], of a damper its mean rate [N s/m] without mount and friction.
  double rate = 0;
  /// Index in Suspension::wheels of the one that moves it most when moved alone; -1: none moves it.
  int wheel = -1;
  /// Motion ratio when that wheel moves alone; nothing when it cannot.
  std::optional<double> alone;
  /// When all wheels of its axle move together; nothing when they cannot.
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
  /// What the wheels carry of the weight of each moving body as they rise together, sum of m dz/d(rise) [kg]; of an arm
  /// between chassis and wheel that is the share of its outer end. Nothing without wheels, or when they cannot rise.
  std::optional<double> unsprung_mass_kg;
};

/// `pose`: the design pose.
RideGeometry RideGeometryOf(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                            const HeldChassis& held, std::span<const double> parameters);

}  // namespace fourpost
