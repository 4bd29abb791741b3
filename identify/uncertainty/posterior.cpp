#include "identify/uncertainty/posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "identify/uncertainty/truncated_normal.h"

namespace fourpost {
namespace {

/// Of a symmetric matrix that is positive definite but for rounding.
class Spectrum {
 public:
  explicit Spectrum(const Eigen::MatrixXd& matrix) : pairs_(SymmetricEigenpairsOf(matrix)) {
    constexpr double kRounding = 1e-13;
    pairs_.values = pairs_.values.cwiseMax(kRounding * std::max(pairs_.values.maxCoeff(), 1e-300));
  }

  Eigen::MatrixXd Power(double exponent) const {
    return pairs_.vectors * pairs_.values.array().pow(exponent).matrix().asDiagonal() * pairs_.vectors.transpose();
  }
  double LogDeterminant() const { return pairs_.values.array().log().sum(); }

 private:
  SymmetricEigenpairs pairs_;
};

}  // namespace

Posterior::Posterior(const std::vector<PosteriorOptimum>& optima, const Eigen::MatrixXd& covariance,
                     Eigen::VectorXd lower, Eigen::VectorXd upper)
    : lower_(std::move(lower)), upper_(std::move(upper)) {
  AddMode(optima.front(), covariance);
  if (optima.front().hessian.size() > 0) {
    const Spectrum cost(optima.front().hessian);
    const Spectrum known(covariance);
    temperature_ = std::exp((known.LogDeterminant() + cost.LogDeterminant()) / static_cast<double>(size()));
    const Eigen::MatrixXd stretch = known.Power(0.5) * cost.Power(0.5);
    for (std::size_t k = 1; k < optima.size(); ++k)
      AddMode(optima[k], stretch * Spectrum(optima[k].hessian).Power(-1) * stretch.transpose());
  }
  SetShares(temperature_);
}

void Posterior::AddMode(const PosteriorOptimum& optimum, const Eigen::MatrixXd& covariance) {
  const Spectrum spectrum(covariance);
  Mode mode = {.optimum = optimum,
               .precision = spectrum.Power(-1),
               .root = spectrum.Power(0.5),
               .log_determinant = spectrum.LogDeterminant()};
  mode.log_within = LogWithin(mode);
  modes_.push_back(std::move(mode));
}

void Posterior::SetShares(double temperature) {
  double sum = 0;
  for (Mode& mode : modes_) {
    mode.log_share = -(mode.optimum.cost - modes_.front().optimum.cost) / (2 * temperature) +
                     (mode.log_determinant - modes_.front().log_determinant) / 2 + mode.log_within -
                     modes_.front().log_within;
    sum += std::exp(mode.log_share);
  }
  for (Mode& mode : modes_) {
    mode.log_share -= std::log(sum);
    shares_.push_back(std::exp(mode.log_share));
  }
}

double Posterior::LogWithin(const Mode& mode) const {
  constexpr int kPlain = 4096;
  int within = 0;
  for (int i = 0; i < kPlain; ++i) {
    Draws draws(0, DrawPurpose::kPosterior, -1, static_cast<std::size_t>(i));
    Eigen::VectorXd standard(mode.root.cols());
    for (double& component : standard) component = draws.Normal();
    within += Holds(mode.optimum.centre + mode.root * standard);
  }
  // None of them: less than one.
  return std::log((within + 0.5) / (kPlain + 1));
}

bool Posterior::Holds(const Eigen::VectorXd& x) const {
  return (x.array() >= lower_.array()).all() && (x.array() <= upper_.array()).all();
}

double Posterior::LogNormalOf(const Mode& mode, const Eigen::VectorXd& x) const {
  const Eigen::VectorXd d = x - mode.optimum.centre;
  return mode.log_share - mode.log_within - mode.log_determinant / 2 - d.dot(mode.precision * d) / 2;
}

double Posterior::LogNormal(const Eigen::VectorXd& x) const {
  std::vector<double> logs;
  for (const Mode& mode : modes_) logs.push_back(LogNormalOf(mode, x));
  const double largest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - largest);
  return largest + std::log(sum);
}

const Posterior::Mode& Posterior::NearestTo(const Eigen::VectorXd& x) const {
  return *std::max_element(modes_.begin(), modes_.end(),
                           [&](const Mode& a, const Mode& b) { return LogNormalOf(a, x) < LogNormalOf(b, x); });
}

double Posterior::LogDensity(const Eigen::VectorXd& x, double cost) const {
  if (!std::isfinite(cost) || !Holds(x)) return -std::numeric_limits<double>::infinity();
  const Mode& mode = NearestTo(x);
  const Eigen::VectorXd d = x - mode.optimum.centre;
  const double parabola = d.dot(mode.optimum.hessian * d);
  const double scale = parabola > 0 ? d.dot(mode.precision * d) / parabola : 1 / temperature_;
  const double rise = cost - mode.optimum.cost - mode.optimum.slope.dot(d);
  return -(mode.optimum.cost - modes_.front().optimum.cost) / (2 * temperature_) - scale * rise / 2;
}

double Posterior::ShareWithin(const Eigen::VectorXd& from, const Eigen::VectorXd& moved) const {
  double share = 1;
  for (Eigen::Index j = 0; j < moved.size(); ++j) {
    const double room = (moved[j] > 0 ? upper_[j] : lower_[j]) - from[j];
    if (moved[j] != 0) share = std::min(share, room / moved[j]);
  }
  return std::max(share, 0.0);
}

Eigen::VectorXd Posterior::DrawNormal(std::uint64_t seed, std::size_t i, const Eigen::VectorXd& moved) const {
  // Multiples of the golden ratio: any number of draws meets the shares as nearly as it can.
  constexpr double kGolden = 0.6180339887498949;
  double left = std::fmod(0.5 + kGolden * static_cast<double>(i), 1.0);
  std::size_t k = 0;
  while (k + 1 < modes_.size() && left >= shares_[k]) left -= shares_[k++];
  Draws draws(seed, DrawPurpose::kPosterior, 0, i);
  Eigen::VectorXd centre = modes_[k].optimum.centre;
  if (k == 0 && moved.size() > 0) centre += draws.Uniform() * ShareWithin(centre, moved) * moved;
  return DrawNormalWithin(centre, modes_[k].root, lower_, upper_, draws);
}

}  // namespace fourpost
