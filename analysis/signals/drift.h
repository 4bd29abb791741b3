#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// The straight line through a signal, by least squares: its value at the first and at the last sample.
struct TrendLine {
  double first = 0;
  double last = 0;
};
TrendLine TrendOf(const std::vector<double>& signal);
void RemoveTrend(std::vector<double>& signal);

/// Takes away what is slower than the cut-off, without a shift in time: the signal less what a Butterworth low-pass of
/// second order makes of it, forwards and then backwards, so that half is left at the cut-off, 94 % at twice it
/// and 99.6 % at four times. Its mean goes first. Ends are reflected about their samples. Throws std::invalid_argument
/// unless 0 < cutoff_Hz < rate_Hz / 2.
void RemoveSlow(std::span<double> signal, double rate_Hz, double cutoff_Hz);

/// The integral over time from the first sample on, that of cubics through four samples: 0.6 % off a sine of eight
/// samples a period, 0.04 % of sixteen. A mean of the signal becomes a ramp.
std::vector<double> IntegralOf(const std::vector<double>& signal, double rate_Hz);

}  // namespace fourpost
