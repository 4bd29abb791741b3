#pragma once

#include <optional>
#include <span>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/ride/ride_geometry.h"
#include "vehicles/ride/suspension.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

// Numbers by which a chassis engineer judges a car, in the design pose, SI. By hand they follow from rates, roll
// centres and masses; Milliken and Milliken, Race Car Vehicle Dynamics, 1995, chapters 16 to 18; Gillespie,
// Fundamentals of Vehicle Dynamics, 1992, chapters 5 and 7. What a vehicle does not have is empty; so are numbers of
// roll and pitch where joints to the ground guide the chassis, and where the tyres' feet are not on the ground.

struct AxleNumbers {
  double load_N = 0;
  /// Share of the bodies' weights that the wheels carry along as they rise together [kg], and the rest of the load.
  std::optional<double> unsprung_kg;
  std::optional<double> sprung_kg;
  /// sqrt(ride rates / sprung mass) and sqrt((wheel + tyre rates) / unsprung mass), over 2 pi: undamped, of the axle
  /// alone.
  std::optional<double> ride_Hz;
  std::optional<double> hop_Hz;
  /// [N m/rad]: AxleRates::roll_Nm without the effect of preloads; and with the tyres in series, k_t y^2.
  std::optional<double> elastic_roll_Nm;
  std::optional<double> roll_on_tyres_Nm;
  /// Above the feet; lateral forces there, shared by both feet alike, do not roll the body.
  std::optional<double> roll_centre_m;
  /// Both wheels are carried by one body.
  bool is_beam = false;
  /// Support angles in the side view, as tangents: vertical force between body and wheels per braking or driving force,
  /// positive against the pitch that the force causes. Brakes act on the links of the tyres; a beam axle takes the
  /// driving torque, otherwise the body does.
  double braking_support = 0;
  double driving_support = 0;
  /// Share of the load transfer that the linkage takes instead of the springs: support times wheelbase / height of the
  /// centre of mass, times the axle's share of the force. Brake forces are shared as the static loads; the axle drives
  /// alone. In front anti-dive and anti-lift, in the rear anti-lift and anti-squat.
  std::optional<double> anti_braking;
  std::optional<double> anti_driving;
  /// Change of each side's load per lateral acceleration [N per m/s^2], and the share of all axles.
  std::optional<double> load_transfer;
  std::optional<double> load_transfer_share;
};

struct CornerNumbers {
  /// Load less an even share of the axle's unsprung mass.
  std::optional<double> sprung_kg;
  /// Sum over its dampers of motion ratio^2 force / speed [N s/m], at 0.1 m/s of each damper, without friction and
  /// mounts.
  double bump_Nspm = 0;
  double rebound_Nspm = 0;
  /// rate / (2 sqrt(wheel rate sprung mass)).
  std::optional<double> bump_ratio;
  std::optional<double> rebound_ratio;
};

struct ChassisNumbers {
  std::vector<AxleNumbers> axles;
  /// In the order of Vehicle::tyres.
  std::vector<CornerNumbers> corners;
  /// Of two axles, two wheels each: (front right + rear left) / all; left / all.
  std::optional<double> cross_weight;
  std::optional<double> left_share;
  /// Of two axles [m].
  std::optional<double> wheelbase_m;
  /// Height of the centre of mass above the feet.
  std::optional<double> com_height_m;
  /// Of the sprung mass m_s above the line that joins the roll centres, unsprung masses at the wheel centres.
  std::optional<double> roll_arm_m;
  /// Roll of the body per lateral acceleration [rad per m/s^2]:
  ///   sum m lever / (sum of roll stiffnesses on tyres - g sum m lever lean),
  /// over all bodies; lever: how far aside of the feet the body's centre of mass goes per roll of the chassis, of the
  /// chassis its height above the roll axis; lean: how far the body rolls with it: 1 on trailing arms, 0 of a beam
  /// axle. Tyres do not yield sideways.
  std::optional<double> roll_gradient;
  /// Where the lines across the paths of braked feet meet in the side view [m], x and z; empty if they are parallel.
  struct PitchCentre {
    double x = 0;
    double z = 0;
  };
  std::optional<PitchCentre> pitch_centre;
};

/// `loads_N`: of the tyres. `whole`: of the vehicle.
ChassisNumbers ChassisNumbersOf(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                                const HeldChassis& held, const RideGeometry& ride, std::span<const double> loads_N,
                                const MassProperties& whole, std::span<const double> parameters);

}  // namespace fourpost
