#include "identify/search/cmaes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/option_check.h"
#include "identify/search/dvhde_operators.h"

namespace fourpost {
namespace {

constexpr Score kNothing = {0, Failure::kNotFinite};

}  // namespace

void CmaesOptions::Validate() const {
  RequireOption(population == 0 || population >= 4, "population", population, "0 or at least 4");
  RequireOption(deviation > 0 && deviation <= 1, "deviation", deviation, "in (0, 1]");
  RequireOption(least_steps >= 0 && least_steps <= 10, "least_steps", least_steps, "in [0, 10]");
  RequireOption(learning > 0 && learning <= 10, "learning", learning, "in (0, 10]");
  RequireOption(restart_after >= 0, "restart_after", restart_after, "0 or more");
  RequireOption(scouts >= 1, "scouts", scouts, "1 or more");
}

Cmaes::Cmaes(const Lattice& lattice, const CmaesOptions& options, std::uint64_t seed)
    : lattice_(&lattice),
      options_(options),
      seed_(seed),
      n_(static_cast<Eigen::Index>(lattice.size())),
      best_ever_(kNothing),
      best_since_restart_(kNothing) {
  options_.Validate();
  lambda_ = options_.population > 0 ? options_.population : 4 + static_cast<int>(3 * std::log(static_cast<double>(n_)));
  mu_ = lambda_ / 2;
  SetWeights();
  Restart();
}

// The tutorial's defaults (its table 1), with negative weights for the worse half.
void Cmaes::SetWeights() {
  const auto n = static_cast<double>(n_);
  Eigen::VectorXd raw(lambda_);
  for (int i = 0; i < lambda_; ++i) raw[i] = std::log((lambda_ + 1) / 2.0) - std::log(i + 1.0);
  const Eigen::VectorXd good = raw.head(mu_);
  const Eigen::VectorXd bad = raw.tail(lambda_ - mu_);
  mu_eff_ = good.sum() * good.sum() / good.squaredNorm();
  const double mu_eff_bad = bad.sum() * bad.sum() / bad.squaredNorm();
  c_sigma_ = (mu_eff_ + 2) / (n + mu_eff_ + 5);
  d_sigma_ = 1 + 2 * std::max(0.0, std::sqrt((mu_eff_ - 1) / (n + 1)) - 1) + c_sigma_;
  c_c_ = (4 + mu_eff_ / n) / (n + 4 + 2 * mu_eff_ / n);
  c_1_ = 2 / ((n + 1.3) * (n + 1.3) + mu_eff_);
  c_mu_ = std::min(1 - c_1_, 2 * (0.25 + mu_eff_ + 1 / mu_eff_ - 2) / ((n + 2) * (n + 2) + mu_eff_));
  chi_n_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  // Some of the covariance is kept in any case.
  c_1_ = std::min(0.4, options_.learning * c_1_);
  c_mu_ = std::min(0.9 - c_1_, options_.learning * c_mu_);
  const double bad_share =
      std::min({1 + c_1_ / c_mu_, 1 + 2 * mu_eff_bad / (mu_eff_ + 2), (1 - c_1_ - c_mu_) / (n * c_mu_)});
  weights_.resize(lambda_);
  weights_.head(mu_) = good / good.sum();
  weights_.tail(lambda_ - mu_) = bad * std::max(0.0, bad_share) / bad.cwiseAbs().sum();
}

void Cmaes::Restart() {
  scouting_ = true;
  asked_.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(options_.scouts); ++i) {
    Draws draws(seed_, DrawPurpose::kInitial, generation_, i);
    asked_.push_back(RandomPoint(*lattice_, draws));
  }
  sigma_ = options_.deviation;
  covariance_ = Eigen::MatrixXd::Identity(n_, n_);
  path_sigma_ = Eigen::VectorXd::Zero(n_);
  path_c_ = Eigen::VectorXd::Zero(n_);
  since_restart_ = 0;
  since_gain_ = 0;
  best_since_restart_ = kNothing;
  Decompose();
}

void Cmaes::Tell(const std::vector<Score>& scores) {
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return IsBetter(scores[a], scores[b]); });
  state_.generation = generation_++;
  state_.migrated = false;
  CountGain(scores[order.front()]);
  if (scouting_) {
    mean_ = Unit(asked_[order.front()]);
    scouting_ = false;
    return AskSamples();
  }
  Update(order);
  if (options_.restart_after > 0 && since_gain_ >= options_.restart_after) {
    state_.migrated = true;
    return Restart();
  }
  AskSamples();
}

void Cmaes::CountGain(const Score& best) {
  const bool gained = IsBetter(best, best_since_restart_);
  if (gained) best_since_restart_ = best;
  since_gain_ = gained ? 0 : since_gain_ + 1;
  const bool record = IsBetter(best, best_ever_);
  if (record) best_ever_ = best;
  state_.stagnant_generations = record ? 0 : state_.stagnant_generations + 1;
}

void Cmaes::AskSamples() {
  samples_.clear();
  asked_.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(lambda_); ++i) {
    Draws draws(seed_, DrawPurpose::kTrial, generation_, i);
    samples_.push_back(Sample(draws));
    asked_.push_back(Rounded(samples_.back()));
  }
}

Eigen::VectorXd Cmaes::Sample(Draws& draws) const {
  constexpr int kTries = 10;
  Eigen::VectorXd x(n_);
  for (int k = 0; k < kTries; ++k) {
    Eigen::VectorXd z(n_);
    for (Eigen::Index j = 0; j < n_; ++j) z[j] = draws.Normal();
    x = mean_ + sigma_ * (axes_ * scales_.cwiseProduct(z));
    if (x.minCoeff() >= 0 && x.maxCoeff() <= 1) break;
  }
  return x.cwiseMax(0.0).cwiseMin(1.0);
}

void Cmaes::Update(const std::vector<std::size_t>& order) {
  ++since_restart_;
  const auto n = static_cast<double>(n_);
  Eigen::MatrixXd steps(n_, lambda_);
  for (int i = 0; i < lambda_; ++i) steps.col(i) = (samples_[order[static_cast<std::size_t>(i)]] - mean_) / sigma_;
  const Eigen::VectorXd mean_step = steps.leftCols(mu_) * weights_.head(mu_);
  mean_ += sigma_ * mean_step;

  const auto whitened = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
    return axes_ * (axes_.transpose() * step).cwiseQuotient(scales_);
  };
  path_sigma_ = (1 - c_sigma_) * path_sigma_ + std::sqrt(c_sigma_ * (2 - c_sigma_) * mu_eff_) * whitened(mean_step);
  const double expected = std::sqrt(1 - std::pow(1 - c_sigma_, 2 * since_restart_));
  const bool steady = path_sigma_.norm() / expected < (1.4 + 2 / (n + 1)) * chi_n_;
  path_c_ *= 1 - c_c_;
  if (steady) path_c_ += std::sqrt(c_c_ * (2 - c_c_) * mu_eff_) * mean_step;

  const double unsteady = steady ? 0 : c_1_ * c_c_ * (2 - c_c_);
  covariance_ *= 1 + unsteady - c_1_ - c_mu_ * weights_.sum();
  covariance_ += c_1_ * path_c_ * path_c_.transpose();
  for (int i = 0; i < lambda_; ++i) {
    const Eigen::VectorXd step = steps.col(i);
    // Scaled so that negative weights keep the covariance positive.
    const double weight = weights_[i] >= 0 ? weights_[i] : weights_[i] * n / whitened(step).squaredNorm();
    covariance_ += c_mu_ * weight * step * step.transpose();
  }
  sigma_ *= std::exp(std::min(1.0, c_sigma_ / d_sigma_ * (path_sigma_.norm() / chi_n_ - 1)));
  Decompose();
}

void Cmaes::Decompose() {
  // No deviation below a share of a step: the distribution would go on shrinking about a point already evaluated.
  for (Eigen::Index j = 0; j < n_; ++j) {
    const double least = options_.least_steps * Step(j, mean_.size() > 0 ? mean_[j] : 0.5);
    covariance_(j, j) = std::max(covariance_(j, j), least * least / (sigma_ * sigma_));
  }
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(covariance_);
  axes_ = pairs.vectors;
  const double largest = pairs.values.maxCoeff();
  scales_ = pairs.values.cwiseMax(1e-14 * largest).cwiseSqrt();
}

LatticePoint Cmaes::Rounded(const Eigen::VectorXd& unit) const {
  LatticePoint point(lattice_->size());
  for (Eigen::Index j = 0; j < n_; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    const double ratio = Ratio(j);
    const double share = ratio > 0 ? std::expm1(unit[j] * ratio) / std::expm1(ratio) : unit[j];
    const std::int64_t last = lattice_->count(axis);
    point[axis] = std::clamp<std::int64_t>(1 + std::llround(share * static_cast<double>(last - 1)), 1, last);
  }
  return point;
}

Eigen::VectorXd Cmaes::Unit(const LatticePoint& point) const {
  Eigen::VectorXd unit(n_);
  for (Eigen::Index j = 0; j < n_; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    const double share = static_cast<double>(point[axis] - 1) / static_cast<double>(lattice_->count(axis) - 1);
    const double ratio = Ratio(j);
    unit[j] = ratio > 0 ? std::log1p(share * std::expm1(ratio)) / ratio : share;
  }
  return unit;
}

double Cmaes::Ratio(Eigen::Index axis) const {
  const LatticeAxis& range = lattice_->axes()[static_cast<std::size_t>(axis)];
  return options_.logarithmic && !range.discrete && range.lower > 0 ? std::log(range.upper / range.lower) : 0;
}

double Cmaes::Step(Eigen::Index axis, double unit) const {
  const double linear = 1 / static_cast<double>(lattice_->count(static_cast<std::size_t>(axis)) - 1);
  const double ratio = Ratio(axis);
  return ratio > 0 ? linear * std::expm1(ratio) / (ratio * std::exp(unit * ratio)) : linear;
}

}  // namespace fourpost
