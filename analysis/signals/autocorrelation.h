#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// Coefficients a_1.. of x_t + a_1 x_{t-1} + .. = e_t by Yule and Walker, of the order up to a tenth of the samples, at
/// most 40, that BIC prefers. Empty for white noise and for a signal that is zero. No mean is removed.
std::vector<double> Autoregression(const Eigen::VectorXd& signal);

/// What passes x_t + a_1 x_{t-1} + ...: white where the coefficients are the signal's.
Eigen::VectorXd Whitened(const Eigen::VectorXd& signal, const std::vector<double>& coefficients);

/// How many independent samples have a mean as uncertain as this signal's: N times its variance over the spectrum of
/// its autoregression at zero frequency; at most N.
double EffectiveSamples(const Eigen::VectorXd& signal);

/// How white a series is.
struct Whiteness {
  /// Autocorrelation from one sample to the next.
  double next = 0;
  /// Of the first 25 autocorrelations, the share beyond 1.96 / sqrt(N): one in twenty of a white series.
  double beyond = 0;

  /// More autocorrelations are beyond their bound than in 99 of 100 white series (of 25, binomial: 5).
  bool IsWhite() const { return beyond <= 0.2; }
};

/// About its mean. White for a series of fewer than 27 samples, and for a constant one.
Whiteness WhitenessOf(const Eigen::VectorXd& series);

}  // namespace fourpost
