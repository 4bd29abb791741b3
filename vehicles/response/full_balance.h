#pragma once

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

struct FullBalanceOptions {
  /// Harmonics kept and samples per cycle, as in HarmonicBalanceOptions. Against 31 and 256 these leave 0.006 dB and
  /// 0.03 degrees of the shipped vehicle's response, 0.2 degrees where a channel is near a node.
  int harmonics = 9;
  int samples = 64;
  /// Largest change of any harmonic in the last iteration, relative to itself or to the first harmonic, whichever is
  /// larger; coordinates weighed by the work of moving each alone.
  double tolerance = 1e-5;
  /// About six are needed; a frequency that takes more than this is given up.
  int max_iterations = 50;
  /// Iterates that Anderson acceleration looks back on.
  int history = 5;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Steady response of the full nonlinear multibody system to a stepped sine, by harmonic balance: the motion
///   s(t) = q - q0 = Re sum_{h=0..H} S_h exp(i h w t),   z(t) likewise for the springs of series dampers,
/// for which harmonics 0..H of Multibody::Residual vanish, sampled over one cycle. Unlike SolveHarmonicBalance it sees
/// the pose that damper jacking shifts the vehicle to, products of harmonics, and the sensors' nonlinear kinematics.
/// It starts from the linearised solution and corrects by the condensed model's impedance with mean dashpots, with
/// Anderson acceleration. q0: the design pose, which is the static equilibrium.
///
/// `multibody` must carry the parameters and preloads of `model`. Its post motion is removed afterwards.
/// Where the iteration does not converge, or leaves what Simbody can evaluate, the frequency is reported unconverged
/// and its values are those of SolveHarmonicBalance.
/// Throws std::invalid_argument for a vehicle with loop closures (fp:rod, fp:ball), whose coordinates are not
/// independent, for one with a hydraulic damper, whose pressures it does not know, and for options, an excitation or a
/// model that do not fit.
PeriodicResponse SolveFullBalance(Multibody& multibody, const CondensedModel& model, const Excitation& excitation,
                                  const FullBalanceOptions& options = {});

}  // namespace fourpost
