#pragma once

#include <Eigen/Core>

namespace fourpost {

/// How a measured signal goes with a modelled one beside their shapes: measured(t) = gain modelled(t - delay).
struct SignalTiming {
  /// Below zero: the other sign.
  double gain = 1;
  double delay_s = 0;
  /// Normalised mean square error that is left with these [%], see NormalisedMse_percent.
  double nmse_percent = 0;
};

/// The delay within a quarter of a second, in whole samples, at which the correlation of both is greatest in size, then
/// gain and the rest of the delay by least squares of measured = gain (modelled - rest modelled'). Both without means,
/// of one length, 16 samples at least; std::invalid_argument otherwise.
SignalTiming TimingOf(const Eigen::VectorXd& measured, const Eigen::VectorXd& modelled, double rate_Hz);

}  // namespace fourpost
