#pragma once

#include <complex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// Slower motions count as rigid-body modes [1/s]: nothing on a rig takes ten minutes. Rounding moves the double pole
/// of a rigid-body mode by the root of 1e-16 times some 1000 / s.
inline constexpr double kSlowestMotion_per_s = 1e-2;

/// A part of a mode's motion, in the field's terms, and its share of the kinetic energy.
struct MotionShare {
  std::string motion;
  double share = 0;
};

/// A mode about static equilibrium, dashpots at their mean rates.
struct Mode {
  enum class Kind {
    kOscillating,
    /// Two real poles p1, p2 below zero: frequency sqrt(p1 p2) / 2 pi, damping ratio -(p1 + p2) / (2 sqrt(p1 p2)) > 1.
    kOverdamped,
    /// Rigid-body mode: held by nothing. Frequency and damping ratio are 0.
    kFree,
    /// Unstable: a real pole above zero. Frequency and damping ratio are 0.
    kDiverging,
  };
  Kind kind = Kind::kOscillating;
  /// Oscillating: |pole| / 2 pi, the undamped frequency of the mode.
  double frequency_Hz = 0;
  double damping_ratio = 0;
  /// Of an overdamped mode the slow pole, of a diverging mode the positive one.
  std::complex<double> pole;
  /// Motion of the independent coordinates, largest entry 1. For an overdamped mode that of the fast pole, which brakes
  /// the masses; at the slow pole springs creep and kinetic energy carries no information.
  Eigen::VectorXcd shape;
  /// See NameModes: heave, pitch, roll, front hop, rear tramp ...
  std::string name;
  /// Largest first.
  std::vector<MotionShare> energy;
};

/// "oscillating", "overdamped", "free", "diverging".
const char* KindName(Mode::Kind kind);

/// State matrix of [s, s', extension of each series spring], dashpots at their mean rates.
Eigen::MatrixXd StateMatrix(const CondensedModel& model);

/// Modes by rising frequency, without names: free and diverging ones first, then oscillating and overdamped ones; as
/// many as there are coordinates. Two real poles whose shapes are alike in the metric of the mass matrix make an
/// overdamped mode; the remaining poles belong to series springs and are no modes.
std::vector<Mode> ModesOf(const CondensedModel& model);

}  // namespace fourpost
