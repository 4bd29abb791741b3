#pragma once

#include <complex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// Slower motions count as free [1/s]: nothing on a rig takes ten minutes. Rounding moves the double pole of a free
/// motion by the root of 1e-16 times some 1000 / s.
inline constexpr double kSlowestMotion_per_s = 1e-2;

/// What a mode moves, in the field's terms, and its share of the kinetic energy.
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
    /// Held by nothing: a rigid-body motion. Frequency and damping ratio are 0.
    kFree,
    /// A real pole above zero: it falls over. Frequency and damping ratio are 0.
    kDiverging,
  };
  Kind kind = Kind::kOscillating;
  /// Oscillating: |pole| / 2 pi, the undamped frequency of the mode.
  double frequency_Hz = 0;
  double damping_ratio = 0;
  /// Of the two of an overdamped mode the slow one, of a diverging mode the one above zero.
  std::complex<double> pole;
  /// Motion of the independent coordinates, largest entry 1; of an overdamped mode that of the fast pole, which brakes
  /// the masses, while at the slow one springs creep and kinetic energy tells nothing.
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

/// Modes by rising frequency, without names: free and diverging ones, then what oscillates or is overdamped; as many as
/// there are coordinates. Two real poles whose shapes are alike in the metric of the mass matrix make an overdamped
/// mode; poles that are left over belong to series springs and are no modes.
std::vector<Mode> ModesOf(const CondensedModel& model);

}  // namespace fourpost
