#include "identify/choice/engine_error.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/random_stream.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Twice the exponent: of 1/2, 3/4, 9/10 and a plane the one whose draws hold most often, see
/// tests/validation/engine_error.csv.
constexpr double kRoughness = 1.5;

/// Two columns a knob: how far it is from its present position, as a share of all its positions, and, where that is
/// none of these, that it is set at all.
Eigen::MatrixXd FeaturesOf(const std::vector<Knob>& knobs, const std::vector<Setting>& settings,
                           const Setting& present) {
  Eigen::MatrixXd features = Eigen::MatrixXd::Zero(std::ssize(settings), 2 * std::ssize(knobs));
  for (std::size_t s = 0; s < settings.size(); ++s)
    for (std::size_t k = 0; k < knobs.size(); ++k) {
      const double span = std::max(1.0, static_cast<double>(knobs[k].positions.size()) - 1);
      if (settings[s][k] == present[k]) continue;
      const bool is_from_one = present[k] != kAsFitted && settings[s][k] != kAsFitted;
      const double from = is_from_one ? present[k] : 0.5 * span;
      const auto row = static_cast<Index>(s);
      features(row, static_cast<Index>(2 * k)) = settings[s][k] == kAsFitted ? 0 : (settings[s][k] - from) / span;
      features(row, static_cast<Index>(2 * k + 1)) = is_from_one ? 0 : 1;
    }
  return features;
}

/// What was compared of one objective.
struct Compared {
  std::vector<Index> rows;
  Eigen::VectorXd differences;
};

Compared ComparedOf(const std::vector<EngineCheck>& checks, std::size_t objective) {
  Compared compared;
  std::vector<double> differences;
  for (const EngineCheck& check : checks) {
    if (check.engine != EngineCheck::Engine::kHistories || check.objective != objective) continue;
    compared.rows.push_back(static_cast<Index>(check.row));
    differences.push_back(std::log((1 + check.by_engine) / (1 + check.by_spectra)));
  }
  compared.differences = Eigen::Map<const Eigen::VectorXd>(differences.data(), std::ssize(differences));
  return compared;
}

Eigen::MatrixXd CovarianceOf(const Eigen::MatrixXd& features) {
  const Eigen::VectorXd sizes = features.rowwise().norm().array().pow(kRoughness);
  Eigen::MatrixXd covariance(features.rows(), features.rows());
  for (Index s = 0; s < covariance.rows(); ++s)
    for (Index t = 0; t < covariance.cols(); ++t)
      covariance(s, t) = 0.5 * (sizes[s] + sizes[t] - std::pow((features.row(s) - features.row(t)).norm(), kRoughness));
  return covariance;
}

/// The process of one objective, conditioned on what was compared.
class ErrorProcess {
 public:
  /// `root`: of the covariance of all settings, times its transpose the same.
  ErrorProcess(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& root, Compared compared)
      : root_(root), compared_(std::move(compared)) {
    const LeastNorm solver(Eigen::MatrixXd(covariance(compared_.rows, compared_.rows)));
    gain_ = solver.Solve(Eigen::MatrixXd(covariance(compared_.rows, Eigen::all))).transpose();
    squares_ = compared_.differences.dot(solver.Solve(compared_.differences));
  }

  Eigen::VectorXd Mean() const { return gain_ * compared_.differences; }

  /// A sample of the process before it was compared, moved to what was found (Matheron's rule).
  Eigen::VectorXd Draw(RandomStream& random) const {
    // With less the tails of one or two comparisons would have no mean.
    constexpr std::size_t kMoreFreedom = 3;
    const std::size_t freedom = compared_.rows.size() + kMoreFreedom;
    double chi2 = 0;
    for (std::size_t i = 0; i < freedom; ++i) chi2 += std::pow(random.Normal(), 2);
    const double size =
        std::sqrt(squares_ / static_cast<double>(compared_.rows.size()) * static_cast<double>(freedom) / chi2);
    const Eigen::VectorXd normal = Eigen::VectorXd::NullaryExpr(root_.cols(), [&] { return random.Normal(); });
    const Eigen::VectorXd sample = size * (root_ * normal);
    return sample + gain_ * (compared_.differences - sample(compared_.rows));
  }

 private:
  const Eigen::MatrixXd& root_;
  Compared compared_;
  Eigen::MatrixXd gain_;
  double squares_ = 0;
};

}  // namespace

std::vector<Eigen::MatrixXd> EngineErrors(const SettingsFile& file, const std::vector<Setting>& settings,
                                          std::size_t present, const std::vector<EngineCheck>& checks, Index draws) {
  if (ComparedOf(checks, 0).rows.empty()) return {};
  const Eigen::MatrixXd covariance = CovarianceOf(FeaturesOf(file.knobs, settings, settings[present]));
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(covariance);
  Eigen::MatrixXd root = pairs.vectors * pairs.values.cwiseMax(0).cwiseSqrt().asDiagonal();
  // But for rounding.
  root.row(static_cast<Index>(present)).setZero();
  std::vector<Eigen::MatrixXd> errors;
  for (std::size_t o = 0; o < file.objectives.size(); ++o) {
    const ErrorProcess process(covariance, root, ComparedOf(checks, o));
    Eigen::MatrixXd of(covariance.rows(), draws);
    for (Index d = 0; d < draws; ++d) {
      RandomStream random(file.seed, "engine error", static_cast<std::uint64_t>(d) * file.objectives.size() + o);
      of.col(d) = (draws == 1 ? process.Mean() : process.Draw(random)).array().exp();
    }
    errors.push_back(std::move(of));
  }
  return errors;
}

}  // namespace fourpost
