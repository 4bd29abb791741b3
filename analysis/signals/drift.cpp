#include "analysis/signals/drift.h"

#include <algorithm>
#include <cstddef>

#include "analysis/signals/low_pass.h"

namespace fourpost {

TrendLine TrendOf(const std::vector<double>& signal) {
  const auto n = static_cast<double>(signal.size());
  double mean = 0;
  for (const double value : signal) mean += value / n;
  double product = 0;
  double square = 0;
  const double middle = (n - 1) / 2;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const double t = static_cast<double>(k) - middle;
    product += t * (signal[k] - mean);
    square += t * t;
  }
  const double slope = square > 0 ? product / square : 0;
  return {mean - slope * middle, mean + slope * middle};
}

void RemoveTrend(std::vector<double>& signal) {
  const TrendLine line = TrendOf(signal);
  const double steps = std::max(1.0, static_cast<double>(signal.size()) - 1);
  for (std::size_t k = 0; k < signal.size(); ++k)
    signal[k] -= line.first + (line.last - line.first) * static_cast<double>(k) / steps;
}

void RemoveSlow(std::span<double> signal, double rate_Hz, double cutoff_Hz) {
  const LowPass filter(2, cutoff_Hz, rate_Hz);
  double mean = 0;
  for (const double value : signal) mean += value / static_cast<double>(signal.size());
  for (double& value : signal) value -= mean;
  // Reflected about the samples at the ends, as far as the filter remembers.
  constexpr double kForgotten = 1e-4;
  const std::size_t ends = std::min(signal.size() - 1, filter.SettlingSamples(kForgotten));
  std::vector<double> slow;
  slow.reserve(signal.size() + 2 * ends);
  for (std::size_t k = ends; k > 0; --k) slow.push_back(2 * signal.front() - signal[k]);
  slow.insert(slow.end(), signal.begin(), signal.end());
  for (std::size_t k = 1; k <= ends; ++k) slow.push_back(2 * signal.back() - signal[signal.size() - 1 - k]);
  for (int pass = 0; pass < 2; ++pass) {
    filter.Apply(slow);
    std::reverse(slow.begin(), slow.end());
  }
  for (std::size_t k = 0; k < signal.size(); ++k) signal[k] -= slow[k + ends];
}

std::vector<double> IntegralOf(const std::vector<double>& signal, double rate_Hz) {
  std::vector<double> integral(signal.size());
  const std::size_t n = signal.size();
  const double step = 1 / rate_Hz;
  const auto at = [&](std::size_t k) { return signal[std::min(k, n - 1)]; };
  for (std::size_t k = 1; k < n; ++k) {
    // Of the cubic through four samples about the step; at the ends of the straight line.
    const double inner = at(k - 1) + at(k);
    const double outer = k >= 2 && k + 1 < n ? at(k - 2) + at(k + 1) : inner;
    integral[k] = integral[k - 1] + step * (13 * inner - outer) / 24;
  }
  return integral;
}

}  // namespace fourpost
