#include "identify/choice/engine_error.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/random_stream.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of a setting's own, beside what is linear in the knobs.
constexpr double kOwnShare = 0.1;

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
    differences.push_back(check.Difference());
  }
  compared.differences = Eigen::Map<const Eigen::VectorXd>(differences.data(), std::ssize(differences));
  return compared;
}

/// The process of one objective, conditioned on what was compared.
class ErrorProcess {
 public:
  ErrorProcess(const Eigen::MatrixXd& features, Compared compared)
      : features_(features),
        own_((kOwnShare * features.rowwise().squaredNorm()).cwiseSqrt()),
        compared_(std::move(compared)) {
    const Eigen::MatrixXd known = features_(compared_.rows, Eigen::all);
    Eigen::MatrixXd among = known * known.transpose();
    among.diagonal() += own_(compared_.rows).cwiseAbs2();
    const LeastNorm solver(among);
    Eigen::MatrixXd toward = features_ * known.transpose();
    for (std::size_t i = 0; i < compared_.rows.size(); ++i)
      toward(compared_.rows[i], static_cast<Index>(i)) += std::pow(own_[compared_.rows[i]], 2);
    gain_ = solver.Solve(Eigen::MatrixXd(toward.transpose())).transpose();
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
    const Eigen::VectorXd slopes = Eigen::VectorXd::NullaryExpr(features_.cols(), [&] { return random.Normal(); });
    Eigen::VectorXd sample = features_ * slopes;
    for (Index s = 0; s < sample.size(); ++s) sample[s] += own_[s] * random.Normal();
    sample *= size;
    return sample + gain_ * (compared_.differences - sample(compared_.rows));
  }

 private:
  const Eigen::MatrixXd& features_;
  Eigen::VectorXd own_;
  Compared compared_;
  Eigen::MatrixXd gain_;
  double squares_ = 0;
};

}  // namespace

std::vector<Eigen::MatrixXd> EngineErrors(const SettingsFile& file, const std::vector<Setting>& settings,
                                          std::size_t present, const std::vector<EngineCheck>& checks, Index draws) {
  const Eigen::MatrixXd features = FeaturesOf(file.knobs, settings, settings[present]);
  std::vector<Eigen::MatrixXd> errors;
  for (std::size_t o = 0; o < file.objectives.size(); ++o) {
    Compared compared = ComparedOf(checks, o);
    if (compared.rows.empty()) return {};
    const ErrorProcess process(features, std::move(compared));
    Eigen::MatrixXd of(features.rows(), draws);
    for (Index d = 0; d < draws; ++d) {
      RandomStream random(file.seed, "engine error", static_cast<std::uint64_t>(d) * file.objectives.size() + o);
      of.col(d) = draws == 1 ? process.Mean() : process.Draw(random);
    }
    errors.push_back(std::move(of));
  }
  return errors;
}

}  // namespace fourpost
