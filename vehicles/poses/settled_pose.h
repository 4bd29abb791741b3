#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Where a vehicle comes to rest on its platforms at height 0, in its full geometry, by its springs' given preloads and
/// free lengths. What has its preload from equilibrium keeps its length of the design pose: a tyre the height of its
/// foot, a spring its length, a bushing the place of its points; its force is whatever rest takes, shared by rates
/// where several can carry it, see PreloadMap. Tyres roll until they carry nothing sideways or fore and aft, and
/// dampers nothing but their gas. Where only tyres hold the car, the middle of their feet stays, and
/// their turn about it.
struct SettledPose {
  struct Strut {
    /// "fp:spring 'coil'", as in messages; fp:tyre: the height of its foot, downward.
    std::string element;
    /// In the design pose and at rest [m].
    double design_length = 0;
    double length = 0;
    /// At rest [N]: tension of a spring, push of a tyre.
    double force = 0;
    /// Whether it kept its length.
    bool is_held = false;
    /// Force in the design pose that holds it there, if all springs and tyres share the loads by their rates, see
    /// PreloadMap; and the free length that gives it. Empty for stops and gas, or if nothing holds that pose.
    std::optional<double> holding_force;
    std::optional<double> holding_length;
  };
  /// Of each link, ground axes; order of Vehicle::links.
  std::vector<Eigen::Isometry3d> design;
  std::vector<Eigen::Isometry3d> rest;
  /// In the order of Vehicle::springs and tyres.
  std::vector<Strut> springs;
  std::vector<Strut> tyres;
  /// Of each bushing, the largest displacement at rest [m, rad], of those with a rate; of each anti-roll bar the change
  /// of its lines' difference [m].
  std::vector<double> bushings;
  std::vector<double> antiroll_bars;

  /// Greatest shift of a link's origin [m].
  double Shift() const;
  /// Greatest turn of a link [rad].
  double Turn() const;
};

/// Empty if no pose at rest is found. Throws FaultyInput if the loops cannot be assembled.
std::optional<SettledPose> Settle(const Vehicle& vehicle, std::span<const double> parameters);

}  // namespace fourpost
