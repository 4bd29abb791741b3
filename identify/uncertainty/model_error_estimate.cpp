#include "identify/uncertainty/model_error_estimate.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/median.h"
#include "analysis/signals/student_t.h"
#include "identify/uncertainty/time_windows.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Inverse of a symmetric matrix that need not have full rank, through `scale`, the roots of its like's diagonal.
Eigen::MatrixXd Inverse(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& scale) {
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * matrix * scale.cwiseInverse().asDiagonal();
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(scaled);
  constexpr double kLeast = 1e-10;
  const double least = kLeast * std::max(pairs.values.maxCoeff(), 0.0);
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(pairs.values.size());
  for (Index i = 0; i < inverse.size(); ++i)
    if (pairs.values[i] > least) inverse[i] = 1 / pairs.values[i];
  return scale.cwiseInverse().asDiagonal() * pairs.vectors * inverse.asDiagonal() * pairs.vectors.transpose() *
         scale.cwiseInverse().asDiagonal();
}

/// x' M^+ x and the rank of M.
std::pair<double, Index> SquaredDistance(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance,
                                         const Eigen::VectorXd& scale) {
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(scaled);
  const Eigen::VectorXd along = pairs.vectors.transpose() * scale.cwiseInverse().asDiagonal() * x;
  // Directions in which noise of this cluster barely acts are numerically open.
  constexpr double kLeast = 1e-6;
  const double least = kLeast * std::max(pairs.values.maxCoeff(), 0.0);
  double square = 0;
  Index rank = 0;
  for (Index i = 0; i < along.size(); ++i) {
    if (!(pairs.values[i] > least)) continue;
    square += along[i] * along[i] / pairs.values[i];
    ++rank;
  }
  return {square, rank};
}

class Jackknife {
 public:
  Jackknife(const FittedResiduals& fitted, const ResidualNoise& noise) : fitted_(fitted), noise_(noise) {
    const Index n = fitted.jacobian.cols();
    hessian_ = Eigen::MatrixXd::Zero(n, n);
    if (fitted.priors.rows() > 0) hessian_ += fitted.priors.transpose() * fitted.priors;
    hessian_ += fitted.jacobian.transpose() * fitted.weights.asDiagonal() * fitted.jacobian;
    scale_ = hessian_.diagonal().cwiseSqrt();
    covariance_ = Inverse(hessian_, scale_);
    all_.assign(static_cast<std::size_t>(fitted.jacobian.rows()), 1);
    of_all_ = noise.CovarianceOfScores(fitted.jacobian, all_, all_);
  }

  const Eigen::MatrixXd& covariance() const { return covariance_; }

  /// Of each residual: what it says of the parameters, of which all residuals together say n.
  Eigen::VectorXd Leverage() const {
    const Eigen::MatrixXd by_covariance = fitted_.jacobian * covariance_;
    return fitted_.weights.cwiseProduct(by_covariance.cwiseProduct(fitted_.jacobian).rowwise().sum());
  }

  PartedData Over(const ResidualPartition& partition) const {
    PartedData parted = {.name = partition.name, .clusters = partition.clusters, .shifts = {}, .rests_on = {}};
    const auto clusters = static_cast<Index>(partition.clusters.size());
    const Index n = hessian_.rows();
    parted.rests_on.assign(static_cast<std::size_t>(n), -1);
    parted.shifts.resize(n, clusters);
    parted.by_noise.resize(n, clusters);
    for (Index g = 0; g < clusters; ++g) AddCluster(partition, g, parted);
    return parted;
  }

 private:
  void AddCluster(const ResidualPartition& partition, Index g, PartedData& parted) const {
    constexpr double kMuchWorse = 25;  // of variances
    const Index n = hessian_.rows();
    std::vector<char> among(partition.cluster_of.size());
    Eigen::VectorXd score = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < among.size(); ++i) {
      among[i] = partition.cluster_of[i] == static_cast<std::size_t>(g);
      if (!among[i]) continue;
      const auto row = static_cast<Index>(i);
      const double weight = fitted_.weights[row];
      score += fitted_.scores.row(row).transpose();
      information += weight * fitted_.jacobian.row(row).transpose() * fitted_.jacobian.row(row);
    }
    const auto [without, variances] = Without(information);
    parted.shifts.col(g) = without * score;
    for (Index j = 0; j < n; ++j)
      if (variances[j] > kMuchWorse * covariance_(j, j))
        parted.rests_on[static_cast<std::size_t>(j)] = static_cast<int>(g);
    const Eigen::MatrixXd of_noise = OfNoise(information, among);
    parted.by_noise.col(g) = (without * of_noise * without).diagonal().cwiseMax(0.0).cwiseSqrt();
    const auto [square, rank] = SquaredDistance(score, of_noise, scale_);
    parted.disagreement += square;
    parted.degrees += static_cast<double>(rank);
  }

  /// What the other clusters alone determine.
  struct Others {
    Eigen::MatrixXd covariance;
    /// Of each parameter, or the least that it can be.
    Eigen::VectorXd variances;
  };

  /// A direction of which they hold less than a thousandth of all information stays where it is: errors of the
  /// derivatives look like that much.
  Others Without(const Eigen::MatrixXd& information) const {
    constexpr double kLeast = 1e-3;
    const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(hessian_ - information, hessian_);
    const Eigen::VectorXd inverse = pairs.values.unaryExpr([](double v) { return v > kLeast ? 1 / v : 0; });
    return {.covariance = pairs.vectors * inverse.asDiagonal() * pairs.vectors.transpose(),
            .variances = pairs.vectors.cwiseAbs2() * pairs.values.cwiseMax(kLeast).cwiseInverse()};
  }

  /// Covariance of a cluster's score at the optimum: its own noise, less what the parameters follow of that of all.
  Eigen::MatrixXd OfNoise(const Eigen::MatrixXd& information, const std::vector<char>& among) const {
    const Eigen::MatrixXd follows = information * covariance_;
    const Eigen::MatrixXd with_all = noise_.CovarianceOfScores(fitted_.jacobian, among, all_) * follows.transpose();
    Eigen::MatrixXd covariance = noise_.CovarianceOfScores(fitted_.jacobian, among, among) - with_all -
                                 with_all.transpose() + follows * of_all_ * follows.transpose();
    // What the inputs' noise adds scatters, in the data and in its estimate.
    if (fitted_.input_noise.size() > 0) covariance += 2 * noise_.CovarianceOfStretches(fitted_.input_noise, among);
    return covariance;
  }

  const FittedResiduals& fitted_;
  const ResidualNoise& noise_;
  std::vector<char> all_;
  Eigen::MatrixXd of_all_;
  Eigen::MatrixXd hessian_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd scale_;
};

}  // namespace

bool PartedData::IsSignificant() const {
  constexpr double kNormal = 5;
  if (!(degrees >= 1)) return false;
  const double spread = 2 / (9 * degrees);
  return (std::cbrt(disagreement / degrees) - (1 - spread)) / std::sqrt(spread) > kNormal;
}

Eigen::MatrixXd PartedData::BeyondNoise() const {
  const Eigen::ArrayXXd squares = (shifts.cwiseAbs2() - by_noise.cwiseAbs2()).cwiseMax(0.0).array();
  return shifts.array().sign() * squares.sqrt();
}

std::vector<Contradiction> PartedData::Contradictions(const Eigen::VectorXd& least) const {
  constexpr double kBeyond = 4;
  std::vector<Contradiction> found;
  for (Index j = 0; j < shifts.rows(); ++j)
    for (Index g = 0; g < shifts.cols(); ++g)
      if (std::abs(shifts(j, g)) > std::max(kBeyond * by_noise(j, g), least[j]) && by_noise(j, g) > 0)
        found.push_back({j, g, shifts(j, g), std::abs(shifts(j, g)) / by_noise(j, g)});
  std::stable_sort(found.begin(), found.end(), [](const Contradiction& a, const Contradiction& b) {
    return std::abs(a.shift) > std::abs(b.shift);
  });
  return found;
}

ModelErrorEstimate EstimateModelError(const FittedResiduals& fitted, const ResidualStructure& structure,
                                      const ResidualNoise& noise) {
  constexpr std::size_t kFewest = 3;
  constexpr double kLeastOfNoise = 0.25;
  constexpr double kLeastOfOthers = 0.75;
  const Index n = fitted.jacobian.cols();
  ModelErrorEstimate estimate;
  estimate.reach = Eigen::VectorXd::Zero(n);
  estimate.covariance = Eigen::MatrixXd::Zero(n, n);
  if (n == 0) return estimate;
  const Jackknife jackknife(fitted, noise);
  if (structure.recordings.clusters.size() > 1) estimate.by_recording = jackknife.Over(structure.recordings);
  std::vector<ResidualPartition> partitions = structure.partitions;
  if (noise.HasTime()) partitions.push_back(WindowsOfTime(structure, jackknife.Leverage()));
  double ways = 0;
  double all_degrees = 0;
  Eigen::VectorXd squares_by_degrees = Eigen::VectorXd::Zero(n);
  for (const ResidualPartition& partition : partitions) {
    if (partition.clusters.size() >= kFewest) estimate.ways.push_back(jackknife.Over(partition));
    else estimate.ways.push_back({.name = partition.name, .clusters = partition.clusters});
    const PartedData& way = estimate.ways.back();
    estimate.is_significant = estimate.is_significant || way.IsSignificant();
    const auto clusters = static_cast<double>(way.shifts.cols());
    if (clusters == 0) continue;
    const Eigen::MatrixXd beyond = way.BeyondNoise();
    const Eigen::MatrixXd of_way = (clusters - 1) / clusters * beyond * beyond.transpose();
    estimate.covariance += of_way;
    squares_by_degrees += of_way.diagonal().cwiseAbs2() / (clusters - 1);
    ways += 1;
    all_degrees += clusters - 1;
  }
  if (ways == 0) return estimate;
  const Eigen::VectorXd sums = estimate.covariance.diagonal();
  estimate.covariance *= kErrorInCommon * kErrorInCommon / ways;
  const Eigen::VectorXd variance = estimate.covariance.diagonal();
  std::vector<double> shares;
  std::vector<double> relative;
  for (Index j = 0; j < n; ++j) {
    shares.push_back(variance[j] / jackknife.covariance()(j, j));
    if (fitted.is_relative[static_cast<std::size_t>(j)]) relative.push_back(variance[j]);
  }
  const double least_of_noise = kLeastOfNoise * Median(shares);
  const double least_of_others = relative.empty() ? 0 : kLeastOfOthers * kLeastOfOthers * Median(relative);
  for (Index j = 0; j < n; ++j) {
    double v = std::max(variance[j], least_of_noise * jackknife.covariance()(j, j));
    if (fitted.is_relative[static_cast<std::size_t>(j)]) v = std::max(v, least_of_others);
    estimate.covariance(j, j) = v;
    const double degrees = sums[j] > 0 ? sums[j] * sums[j] / squares_by_degrees[j] : all_degrees;
    estimate.reach[j] = StudentT95(degrees) * std::sqrt(v);
  }
  return estimate;
}

}  // namespace fourpost
