#include "analysis/trend.h"

#include <utility>

#include "analysis/deviation.h"

namespace fourpost {

std::vector<double> WithoutOffset(std::vector<double> signal) {
  const double mean = Mean(signal);
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

}  // namespace fourpost
