#include "identify/decision/value_of_information.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace fourpost {
namespace {

using Eigen::Index;

constexpr Index kFewestDraws = 10;

/// r^2 of n pairs without what chance adds; 0 where there is no variance.
double CorrectedShare(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const double variances = x.squaredNorm() * y.squaredNorm();
  if (!(variances > 0)) return 0;
  const double share = x.dot(y) * x.dot(y) / variances;
  return std::max(0.0, share - (1 - share) / static_cast<double>(x.size() - 2));
}

Eigen::VectorXd Centred(const Eigen::VectorXd& values) { return (values.array() - values.mean()).matrix(); }

/// Mean over draws of how far the best setting given x lies below `best`. `x` is centred.
double GainOf(const Eigen::MatrixXd& cost, std::size_t best, const Eigen::VectorXd& x) {
  const Eigen::RowVectorXd reference = cost.row(static_cast<Index>(best));
  Eigen::RowVectorXd least = Eigen::RowVectorXd::Zero(cost.cols());
  for (Index s = 0; s < cost.rows(); ++s) {
    const Eigen::VectorXd difference = (cost.row(s) - reference).transpose();
    const Eigen::VectorXd varying = Centred(difference);
    const double share = CorrectedShare(x, varying);
    // The slope whose line has that share of the variance.
    const double slope =
        share > 0 ? std::copysign(std::sqrt(share * varying.squaredNorm() / x.squaredNorm()), x.dot(varying)) : 0;
    least = least.cwiseMin((difference.mean() + slope * x.array()).matrix().transpose());
  }
  return -least.mean();
}

double Density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi); }
double Below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// E[(Z - c)^+] for c = |z|, accurate in the tail.
double MeanExcess(double c) { return std::max(0.0, Density(c) - c * Below(-c)); }

/// Of lines by rising slope, of equal slopes the highest only, those of the upper envelope, and where each begins.
struct Envelope {
  std::vector<std::size_t> lines;
  std::vector<double> begins;
};

Envelope UpperEnvelope(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  std::vector<std::size_t> order(static_cast<std::size_t>(a.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto at = [](const Eigen::VectorXd& of, std::size_t i) { return of[static_cast<Index>(i)]; };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return at(b, i) != at(b, j) ? at(b, i) < at(b, j) : at(a, i) < at(a, j);
  });
  Envelope envelope;
  for (const std::size_t i : order) {
    double begin = -HUGE_VAL;
    while (!envelope.lines.empty()) {
      const std::size_t last = envelope.lines.back();
      const bool is_parallel = at(b, i) == at(b, last);
      begin = is_parallel ? -HUGE_VAL : (at(a, last) - at(a, i)) / (at(b, i) - at(b, last));
      // Of parallel lines the later is the higher one.
      if (!is_parallel && begin > envelope.begins.back()) break;
      envelope.lines.pop_back();
      envelope.begins.pop_back();
      begin = -HUGE_VAL;
    }
    envelope.lines.push_back(i);
    envelope.begins.push_back(begin);
  }
  return envelope;
}

}  // namespace

double ExpectedRise(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if (a.size() == 0 || a.size() != b.size()) throw std::invalid_argument("lines need an intercept and a slope each");
  const Envelope envelope = UpperEnvelope(a, b);
  double rise = 0;
  for (std::size_t k = 1; k < envelope.lines.size(); ++k) {
    const double step = b[static_cast<Index>(envelope.lines[k])] - b[static_cast<Index>(envelope.lines[k - 1])];
    rise += step * MeanExcess(std::abs(envelope.begins[k]));
  }
  return rise;
}

std::vector<DecidingParameter> DecidingParameters(const Eigen::MatrixXd& cost, std::size_t best, std::size_t rival,
                                                  const Eigen::MatrixXd& parameters) {
  std::vector<DecidingParameter> list;
  if (cost.cols() < kFewestDraws) return list;
  const Eigen::VectorXd difference =
      Centred((cost.row(static_cast<Index>(rival)) - cost.row(static_cast<Index>(best))).transpose());
  for (Index j = 0; j < parameters.cols(); ++j) {
    const Eigen::VectorXd x = Centred(parameters.col(j));
    list.push_back({static_cast<std::size_t>(j), CorrectedShare(x, difference), GainOf(cost, best, x)});
  }
  std::stable_sort(list.begin(), list.end(), [](const DecidingParameter& a, const DecidingParameter& b) {
    return a.gain != b.gain ? a.gain > b.gain : a.explained > b.explained;
  });
  return list;
}

std::vector<InformativeRun> InformativeRuns(const Eigen::MatrixXd& cost, double noise, std::size_t count) {
  std::vector<InformativeRun> runs;
  if (cost.cols() < 2) return runs;
  const Eigen::VectorXd mean = cost.rowwise().mean();
  const Eigen::MatrixXd centred = cost.colwise() - mean;
  Eigen::MatrixXd covariance = centred * centred.transpose() / static_cast<double>(cost.cols() - 1);
  std::vector<bool> is_taken(static_cast<std::size_t>(cost.rows()), false);
  while (runs.size() < count) {
    InformativeRun next;
    for (Index s = 0; s < cost.rows(); ++s) {
      if (is_taken[static_cast<std::size_t>(s)]) continue;
      const double variance = covariance(s, s) + noise * noise;
      if (!(variance > 0)) continue;
      const double gain = ExpectedRise(-mean, covariance.col(s) / std::sqrt(variance));
      if (gain > next.gain) next = {.setting = static_cast<std::size_t>(s), .gain = gain};
    }
    if (!(next.gain > 0)) break;
    const auto s = static_cast<Index>(next.setting);
    next.sd_before = std::sqrt(covariance(s, s));
    const Eigen::VectorXd column = covariance.col(s);
    covariance -= column * column.transpose() / (column[s] + noise * noise);
    next.sd_after = std::sqrt(std::max(0.0, covariance(s, s)));
    is_taken[next.setting] = true;
    runs.push_back(next);
  }
  return runs;
}

}  // namespace fourpost
