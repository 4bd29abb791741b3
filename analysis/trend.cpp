#include "analysis/trend.h"

#include <cmath>
#include <numeric>

namespace fourpost {

std::vector<double> WithoutOffset(std::vector<double> signal) {
  const double mean = std::accumulate(signal.begin(), signal.end(), 0.0) / static_cast<double>(signal.size());
  for (double& sample : signal) sample -= mean;
  return signal;
}

std::vector<double> WithoutTrend(std::vector<double> signal) {
  signal = WithoutOffset(std::move(signal));
  const double middle = 0.5 * (static_cast<double>(signal.size()) - 1);
  double moment = 0;
  double square = 0;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const double place = static_cast<double>(k) - middle;
    moment += place * signal[k];
    square += place * place;
  }
  if (square == 0) return signal;
  for (std::size_t k = 0; k < signal.size(); ++k) signal[k] -= moment / square * (static_cast<double>(k) - middle);
  return signal;
}

double DeviationOf(const std::vector<double>& signal) {
  if (signal.empty()) return 0;
  double square = 0;
  for (const double sample : WithoutOffset(signal)) square += sample * sample;
  return std::sqrt(square / static_cast<double>(signal.size()));
}

}  // namespace fourpost
