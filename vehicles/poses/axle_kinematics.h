#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/poses/suspension_rig.h"
#include "vehicles/poses/wheel_place.h"

namespace fourpost {

/// One wheel of an axle in one position of a travel.
struct WheelStation {
  /// Rise of its centre from the design pose [m].
  double rise = 0;
  WheelPlace place;
  /// Per unit of the travel.
  WheelPlace rate;
  /// Vertical force of the pad [N].
  double load = 0;
};

/// An axle in one position of a travel; SI.
struct AxleStation {
  double travel = 0;
  /// Of the body against the ground, positive with its left side up [rad], and per travel [rad/m]; 0 for an axle that
  /// has one side only.
  double roll = 0;
  double roll_rate = 0;
  /// Order of Axle::wheels.
  std::vector<WheelStation> wheels;
  /// Lateral distance of the feet; empty for an axle that has one side only.
  std::optional<double> track;
  /// Distance of the wheel centres, mean of both sides, to those of the other axle in the design pose; empty unless the
  /// vehicle has two axles.
  std::optional<double> wheelbase;
  /// Of the roll centre above the feet, in heave: roll moves the feet sideways, in the mean, as a turn of the ground
  /// about it; the body does not roll under lateral forces there that both feet share alike. Of a symmetric axle it is
  /// where the lines across the feet's paths meet.
  std::optional<double> roll_centre;
  /// Order of AxleKinematics::struts: length [m]; shortening per travel, of an anti-roll bar the change of e_right -
  /// e_left.
  std::vector<double> lengths;
  std::vector<double> ratios;
};

/// A way in which the wheels of an axle travel, the other axles' wheels held at the height of the design pose.
struct AxleTravel {
  enum class Kind {
    /// All wheels rise alike.
    kHeave,
    /// Those on the right rise as much as those on the left fall: the body rolls to the right against the ground.
    kRoll,
    /// One rises alone.
    kWheel,
  };
  Kind kind = Kind::kHeave;
  /// Index in Axle::wheels of the one that rises alone.
  std::size_t wheel = 0;
  /// "heave", "roll", "FL".
  std::string name;
  /// By rising travel.
  std::vector<AxleStation> stations;
  /// What was asked for and what was reached [m]; less if there is a dead centre.
  double lower = 0;
  double upper = 0;
  double reached_lower = 0;
  double reached_upper = 0;

  /// That of the design pose.
  const AxleStation& Design() const;
};

/// A spring, stop, damper or anti-roll bar that an axle moves.
struct AxleStrut {
  enum class Kind { kSpring, kDamper, kAntiRollBar, kStop, kGas };
  Kind kind = Kind::kSpring;
  /// In Vehicle::springs, dampers or antiroll_bars.
  std::size_t index = 0;
  std::string name;
};
const char* KindName(AxleStrut::Kind kind);

/// Of a vehicle, by kind.
std::vector<AxleStrut> StrutsOf(const Vehicle& vehicle);

/// Response of the wheels of an axle to one load; per N, or N m of an aligning torque.
struct AxleCompliance {
  WheelLoad load = WheelLoad::kLateral;
  /// Each wheel carries the load; if opposed the right one the opposite of it.
  bool is_opposed = false;
  /// Changes per load, order of Axle::wheels.
  std::vector<WheelPlace> wheels;
};
/// "lateral", "braking", "driving", "aligning".
const char* LoadName(WheelLoad load);

/// Kinematics and compliance of one axle.
struct AxleKinematics {
  /// Index in Suspension::axles.
  std::size_t axle = 0;
  /// By kind.
  std::vector<AxleStrut> struts;
  /// Heave, roll, each wheel; without those that its linkage does not allow.
  std::vector<AxleTravel> travels;
  /// In the design pose; empty for a rigid linkage.
  std::vector<AxleCompliance> compliance;
  /// Travels [m] at which the last stop of a side begins, by its motion ratio in the design pose; empty without one.
  std::optional<double> stop_lower = {};
  std::optional<double> stop_upper = {};

  /// Whether a wheel has gone beyond the last stop of a side, into it.
  bool IsBeyondStops(const AxleStation& station) const;
};

/// Travels [m]; a side without a number reaches to where the axle's last stop begins, see AxleKinematics; kUsualTravel
/// without a stop.
struct TravelRange {
  std::optional<double> lower;
  std::optional<double> upper;
  double step = 0.01;
};
inline constexpr double kUsualTravel = 0.06;

/// What of an AxleStation is wanted; all else stays empty, since each costs a solution of its own.
struct StationWants {
  /// Rates, roll rate and motion ratios.
  bool rates = true;
  bool roll_centre = true;
};

/// One axle at these travels [m], in their order; empty where the wheels cannot go there. `travel`: its kind and wheel.
/// The way to each leads from the design pose through those between. Lengths and ratios are those of StrutsOf().
std::vector<std::optional<AxleStation>> StationsAt(SuspensionRig& rig, std::size_t axle,
                                                   std::span<const double> parameters, const AxleTravel& travel,
                                                   std::span<const double> travels, const StationWants& wants);

/// Of one axle in the design pose, see AxleKinematics::compliance.
std::vector<AxleCompliance> ComplianceOf(SuspensionRig& rig, std::size_t axle, std::span<const double> parameters);

/// Of all axles whose wheels can move against the chassis.
std::vector<AxleKinematics> KinematicsOf(SuspensionRig& rig, std::span<const double> parameters,
                                         const TravelRange& range);

}  // namespace fourpost
