#include "analysis/signals/autocorrelation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourpost {
namespace {

using Eigen::Index;

/// A hundred samples leave an order of 10 well determined, and nothing of a rig needs more than 40.
std::size_t LargestOrder(Index samples) { return static_cast<std::size_t>(std::min<Index>(40, samples / 10)); }

/// Divided by N, so that the matrix of all of them is not negative.
std::vector<double> Autocovariances(const Eigen::VectorXd& signal, std::size_t largest) {
  std::vector<double> covariances;
  for (Index lag = 0; lag <= static_cast<Index>(largest); ++lag)
    covariances.push_back(signal.head(signal.size() - lag).dot(signal.tail(signal.size() - lag)) /
                          static_cast<double>(signal.size()));
  return covariances;
}

/// Of all orders, with the variance that each leaves.
struct Recursion {
  std::vector<std::vector<double>> coefficients;
  std::vector<double> variances;
};

Recursion LevinsonDurbin(const std::vector<double>& covariances) {
  Recursion recursion = {.coefficients = {{}}, .variances = {covariances[0]}};
  std::vector<double> now;
  for (std::size_t order = 1; order < covariances.size(); ++order) {
    const double variance = recursion.variances.back();
    if (!(variance > 0)) break;
    double sum = covariances[order];
    for (std::size_t i = 0; i < now.size(); ++i) sum += now[i] * covariances[order - 1 - i];
    const double reflection = -sum / variance;
    std::vector<double> next = now;
    for (std::size_t i = 0; i < now.size(); ++i) next[i] += reflection * now[now.size() - 1 - i];
    next.push_back(reflection);
    now = std::move(next);
    recursion.coefficients.push_back(now);
    recursion.variances.push_back(variance * (1 - reflection * reflection));
  }
  return recursion;
}

}  // namespace

/// What passes x_t + a_1 x_{t-1} + ...
Eigen::VectorXd Whitened(const Eigen::VectorXd& signal, const std::vector<double>& coefficients) {
  Eigen::VectorXd out = signal;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const auto lag = static_cast<Index>(i) + 1;
    out.tail(signal.size() - lag) += coefficients[i] * signal.head(signal.size() - lag);
  }
  return out;
}

std::vector<double> Autoregression(const Eigen::VectorXd& signal) {
  const auto samples = static_cast<double>(signal.size());
  const Recursion recursion = LevinsonDurbin(Autocovariances(signal, LargestOrder(signal.size())));
  std::size_t best = 0;
  double least = 0;
  for (std::size_t order = 0; order < recursion.variances.size(); ++order) {
    if (!(recursion.variances[order] > 0)) break;
    const double criterion = samples * std::log(recursion.variances[order] / recursion.variances[0]) +
                             static_cast<double>(order) * std::log(samples);
    if (criterion >= least) continue;
    least = criterion;
    best = order;
  }
  return recursion.coefficients[best];
}

double EffectiveSamples(const Eigen::VectorXd& signal) {
  const auto samples = static_cast<double>(signal.size());
  const std::vector<double> coefficients = Autoregression(signal);
  const Eigen::VectorXd innovations = Whitened(signal, coefficients);
  double sum = 1;
  for (const double coefficient : coefficients) sum += coefficient;
  const double long_run = innovations.squaredNorm() / (sum * sum);
  return long_run > 0 ? std::min(samples, samples * signal.squaredNorm() / long_run) : samples;
}

Whiteness WhitenessOf(const Eigen::VectorXd& series) {
  constexpr Index kLags = 25;
  Whiteness whiteness;
  const Eigen::VectorXd about = series.array() - series.mean();
  const double squares = about.squaredNorm();
  if (series.size() < kLags + 2 || !(squares > 0)) return whiteness;
  const double bound = 1.96 / std::sqrt(static_cast<double>(series.size()));
  for (Index lag = 1; lag <= kLags; ++lag) {
    const Index count = about.size() - lag;
    const double correlation = about.head(count).dot(about.tail(count)) / squares;
    if (lag == 1) whiteness.next = correlation;
    if (std::abs(correlation) > bound) whiteness.beyond += 1.0 / kLags;
  }
  return whiteness;
}

}  // namespace fourpost
