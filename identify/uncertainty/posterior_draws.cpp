#include "identify/uncertainty/posterior_draws.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "identify/search/archive.h"

namespace fourpost {
namespace {

using Points = std::vector<Eigen::VectorXd>;

Points NormalPoints(const Posterior& posterior, const PosteriorDrawOptions& options) {
  Points points;
  for (std::size_t i = 0; i < options.count; ++i) {
    if (options.stop && options.stop()) throw BatchStopped();
    points.push_back(posterior.DrawNormal(options.seed, i, options.moved));
  }
  return points;
}

/// Adding up to 1; empty where no point has a density.
std::vector<double> Normalised(const std::vector<double>& log_weights) {
  const double largest = *std::max_element(log_weights.begin(), log_weights.end());
  if (!std::isfinite(largest)) return {};
  std::vector<double> weights;
  double sum = 0;
  for (const double log : log_weights) {
    weights.push_back(std::exp(log - largest));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

double EffectiveCount(const std::vector<double>& weights) {
  double squares = 0;
  for (const double weight : weights) squares += weight * weight;
  return squares > 0 ? 1 / squares : 0;
}

/// Each point as often as its weight asks for, by one random number (Kitagawa, J. Comput. Graph. Stat. 5, 1996).
Points Resampled(const Points& points, const std::vector<double>& weights, std::size_t count, std::uint64_t seed) {
  Draws draws(seed, DrawPurpose::kPosterior, 1, 0);
  const double first = draws.Uniform();
  Points resampled;
  double below = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    below += weights[i] * static_cast<double>(count);
    while (resampled.size() < count && first + static_cast<double>(resampled.size()) < below)
      resampled.push_back(points[i]);
  }
  while (resampled.size() < count) resampled.push_back(resampled.back());  // rounding of the sum
  return resampled;
}

double Correlation(const Points& a, const Points& b, Eigen::Index j) {
  const auto count = static_cast<double>(a.size());
  double mean_a = 0;
  double mean_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i][j] / count;
    mean_b += b[i][j] / count;
  }
  double aa = 0;
  double bb = 0;
  double ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += std::pow(a[i][j] - mean_a, 2);
    bb += std::pow(b[i][j] - mean_b, 2);
    ab += (a[i][j] - mean_a) * (b[i][j] - mean_b);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 1;
}

class Ensemble {
 public:
  Ensemble(const Posterior& posterior, const CostsOf& costs_of, const PosteriorDrawOptions& options, Points points,
           std::vector<double> log_densities)
      : posterior_(posterior),
        costs_of_(costs_of),
        options_(options),
        points_(std::move(points)),
        log_densities_(std::move(log_densities)),
        evaluated_(static_cast<std::int64_t>(points_.size())) {
    const auto least = static_cast<std::size_t>(2 * (posterior.size() + 1));
    if (points_.size() >= least) return;
    Points more;
    for (std::size_t i = points_.size(); i < least; ++i) more.push_back(posterior.DrawNormal(options.seed, i));
    for (const double log : LogDensities(more)) log_densities_.push_back(log);
    points_.insert(points_.end(), more.begin(), more.end());
  }

  PosteriorDraws Run() {
    constexpr double kForgotten = 0.2;
    constexpr int kFirstLook = 16;
    Points half_way = points_;
    PosteriorDraws draws{.method = DrawMethod::kEnsemble, .points = {}, .remembered = 1};
    int next_look = kFirstLook;
    while (evaluated_ + static_cast<std::int64_t>(points_.size()) <= options_.max_evaluations) {
      MoveHalf(draws.generations, 0);
      MoveHalf(draws.generations, 1);
      if (++draws.generations != next_look) continue;
      draws.remembered = Remembered(half_way);
      if (draws.remembered < kForgotten) break;
      half_way = points_;
      next_look *= 2;
    }
    draws.accepted = moved_ > 0 ? accepted_ / moved_ : 0;
    draws.points.assign(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(options_.count));
    return draws;
  }

 private:
  std::vector<double> LogDensities(const Points& points) {
    const std::vector<double> costs = costs_of_(points);
    evaluated_ += static_cast<std::int64_t>(points.size());
    std::vector<double> logs;
    for (std::size_t i = 0; i < points.size(); ++i) logs.push_back(posterior_.LogDensity(points[i], costs[i]));
    return logs;
  }

  /// Members of even or odd number, each along the line to a random one of the others.
  void MoveHalf(int generation, std::size_t half) {
    Points asked;
    std::vector<std::size_t> movers;
    std::vector<double> log_limits;
    for (std::size_t i = half; i < points_.size(); i += 2) {
      Draws draws(options_.seed, DrawPurpose::kEnsemble, generation, i);
      const auto others = static_cast<std::int64_t>((points_.size() + half) / 2);
      const auto other = static_cast<std::size_t>(2 * draws.Integer(0, others - 1)) + 1 - half;
      // Density 1 / sqrt(z) from 1/2 to 2.
      const double stretch = std::pow(1 + draws.Uniform(), 2) / 2;
      const double chance = draws.Uniform();
      ++moved_;
      const Eigen::VectorXd to = points_[other] + stretch * (points_[i] - points_[other]);
      if (!posterior_.Holds(to)) continue;
      asked.push_back(to);
      movers.push_back(i);
      log_limits.push_back(std::log(chance) - static_cast<double>(to.size() - 1) * std::log(stretch));
    }
    const std::vector<double> logs = LogDensities(asked);
    for (std::size_t k = 0; k < movers.size(); ++k) {
      const std::size_t i = movers[k];
      if (!std::isfinite(logs[k]) || logs[k] - log_densities_[i] < log_limits[k]) continue;
      points_[i] = asked[k];
      log_densities_[i] = logs[k];
      ++accepted_;
    }
  }

  double Remembered(const Points& before) const {
    double largest = 0;
    for (Eigen::Index j = 0; j < posterior_.size(); ++j) largest = std::max(largest, Correlation(before, points_, j));
    return largest;
  }

  const Posterior& posterior_;
  const CostsOf& costs_of_;
  const PosteriorDrawOptions& options_;
  Points points_;
  std::vector<double> log_densities_;
  std::int64_t evaluated_;
  double moved_ = 0;
  double accepted_ = 0;
};

}  // namespace

PosteriorDraws DrawNormals(const Posterior& posterior, const PosteriorDrawOptions& options) {
  return {.method = DrawMethod::kNormal, .points = NormalPoints(posterior, options)};
}

PosteriorDraws DrawByCost(const Posterior& posterior, const CostsOf& costs_of, const PosteriorDrawOptions& options) {
  const Points normal = NormalPoints(posterior, options);
  const std::vector<double> costs = costs_of(normal);
  std::vector<double> log_densities;
  std::vector<double> log_weights;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    log_densities.push_back(posterior.LogDensity(normal[i], costs[i]));
    log_weights.push_back(log_densities[i] - posterior.LogNormal(normal[i]));
  }
  const std::vector<double> weights = Normalised(log_weights);
  const double effective = EffectiveCount(weights);
  PosteriorDraws draws{.method = DrawMethod::kWeighted, .points = {}};
  if (effective >= kLeastEffectiveShare * static_cast<double>(options.count))
    draws.points = Resampled(normal, weights, options.count, options.seed);
  else draws = Ensemble(posterior, costs_of, options, normal, log_densities).Run();
  draws.effective = effective;
  return draws;
}

}  // namespace fourpost
