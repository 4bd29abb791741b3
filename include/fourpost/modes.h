#pragma once

#include <complex>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/diagnostics.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

// About static equilibrium in the design pose; laws of dampers and springs at their mean rates.

/// How a body moves in a mode; ground axes.
struct BodyShape {
  std::string body;
  /// Of its centre of mass along x, y, z [m], and about x, y, z [rad]. The largest component of the mode is 1:
  /// rotations count by the body's radius of gyration about that axis.
  Eigen::Vector3cd translation;
  Eigen::Vector3cd rotation;
};

struct Mode {
  /// "heave", "roll", "front hop", ...
  std::string name;
  /// "oscillating", "overdamped" (two real poles), "free" (a rigid-body mode) or "diverging" (unstable); of the last
  /// two frequency and damping ratio are 0, and times NaN.
  std::string kind;
  /// Undamped frequency, |pole| / 2 pi; overdamped: of the product of both poles.
  double frequency_Hz = 0;
  double damped_frequency_Hz = 0;
  double damping_ratio = 0;
  /// 1.8 over the angular frequency, and 4.6 over the decay rate.
  double rise_time_s = 0;
  double settling_time_s = 0;
  /// On and above the real axis [1/s]: two of an overdamped mode, the slow one first.
  std::vector<std::complex<double>> poles;
  /// Shares of the kinetic energy by motion.
  std::map<std::string, double> kinetic_energy;
  std::vector<BodyShape> shape;
};

/// X' = a X + b z,  y = c X + d z + d_rate z' + d_acceleration z'' of heights z of the posts [m] and readings y of the
/// sensors; X is internal.
struct StateSpace {
  std::vector<std::string> posts;
  std::vector<std::string> sensors;
  Eigen::MatrixXd a;
  Eigen::MatrixXd b;
  Eigen::MatrixXd c;
  Eigen::MatrixXd d;
  Eigen::MatrixXd d_rate;
  Eigen::MatrixXd d_acceleration;
};

struct Modes {
  /// By rising frequency; free and diverging ones first.
  std::vector<Mode> modes;
  StateSpace state_space;
  std::vector<Finding> warnings;
};

/// Poles followed while a parameter changes.
struct PolePath {
  /// Its mode at the vehicle's value: "heave", "heave, slow pole", "creep" of the mount of a damper.
  std::string mode;
  /// One per value [1/s], on or above the real axis; NaN where it is the conjugate of another.
  Eigen::VectorXcd poles;
};

/// Modes of a vehicle at its values. Throws Error.
Modes FindModes(const Vehicle& vehicle);

/// The poles at these SI values of one parameter, the others as the vehicle has them, by rising frequency at the first
/// value. Rigid-body modes are left out. Throws Error.
std::vector<PolePath> FollowPoles(const Vehicle& vehicle, const std::string& parameter,
                                  const std::vector<double>& values);

}  // namespace fourpost::api
