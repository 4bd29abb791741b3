#include "identify/fit/identifiability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "identify/fit/findings.h"
#include "identify/refine/fit_variables.h"
#include "identify/search/draws.h"
#include "identify/search/dvhde_operators.h"
#include "identify/uncertainty/derivative_noise.h"

namespace fourpost {
namespace {

/// Derivatives of the whitened residuals with respect to FitVariables, the priors' rows last.
struct Slopes {
  Eigen::VectorXd x;
  Evaluation here;
  Eigen::MatrixXd jacobian;
};

double StepOf(const Archive& archive) { return StepFor(archive.problem().accuracy, Differences::kCentral); }

/// Nothing where a point has no answer.
std::optional<Slopes> SlopesAt(Archive& archive, const Eigen::VectorXd& values, Differences differences) {
  const FitVariables variables(archive.lattice());
  Slopes slopes{variables.FromValues(values), archive.EvaluateValues({values}).front(), {}};
  if (!slopes.here.ok()) return std::nullopt;
  std::optional<Eigen::MatrixXd> jacobian =
      DifferenceJacobian(archive, variables, slopes.x, slopes.here.residuals, StepOf(archive), differences);
  if (!jacobian) return std::nullopt;
  slopes.jacobian = *std::move(jacobian);
  return slopes;
}

std::vector<Eigen::Index> NoisyOf(Archive& archive, const Slopes& slopes) {
  const std::optional<Eigen::MatrixXd> again =
      JacobianAgain(archive, FitVariables(archive.lattice()), slopes.x, slopes.here.residuals, StepOf(archive));
  return again ? NoisyColumns(slopes.jacobian, *again) : std::vector<Eigen::Index>();
}

/// `data` about these values; variances are not looked at, so no inflation.
Covariance Judge(const Archive& archive, const Eigen::VectorXd& values, const Eigen::MatrixXd& data, double cost,
                 const Eigen::MatrixXd& priors, const std::vector<Eigen::Index>& held = {}) {
  return EstimateCovariance(data, FitVariables(archive.lattice()).Slopes(values), cost,
                            {.inflate = false, .held = held}, priors);
}

/// Largest singular value.
double Largest(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd squares = SymmetricEigenvaluesOf(jacobian.transpose() * jacobian);
  return std::max(std::sqrt(squares.maxCoeff()), std::numeric_limits<double>::min());
}

}  // namespace

const Finding& UnidentifiedAs(const Eigen::VectorXd& direction) {
  constexpr double kAlike = 0.5;
  // Lengths and angles have no part in the scale, and other open directions may be mixed in.
  const double largest = direction.cwiseAbs().maxCoeff();
  const auto with = (direction.array() > kAlike * largest).count();
  const auto against = (direction.array() < -kAlike * largest).count();
  const bool is_scale = std::min(with, against) == 0 && with + against > 2 && 2 * (with + against) >= direction.size();
  return is_scale ? kScaleUnidentified : kDirectionUnidentified;
}

std::vector<std::string> WeakestDirections(const Lattice& lattice, const Covariance& covariance) {
  const Eigen::Index n = covariance.directions.cols();
  std::vector<std::string> weakest;
  for (Eigen::Index i = std::max<Eigen::Index>(0, std::min<Eigen::Index>(covariance.rank, n - 1)); i < n; ++i)
    weakest.push_back(DescribeDirection(lattice, covariance.directions.col(i)));
  return weakest;
}

namespace {

std::optional<Identifiability> IdentifiabilityBy(Differences differences, Archive& archive,
                                                 const VehicleObjective& objective, std::uint64_t seed) {
  constexpr int kOtherPoints = 2;
  const Eigen::VectorXd values = objective.FileValues();
  const std::optional<Slopes> here = SlopesAt(archive, values, differences);
  if (!here) return std::nullopt;
  const double cost = here->here.cost();
  const Eigen::Index count = here->jacobian.rows() - objective.prior_count();
  const Eigen::MatrixXd priors = here->jacobian.bottomRows(objective.prior_count());
  Eigen::MatrixXd data = here->jacobian.topRows(count);
  const auto judged = [&](const std::vector<Eigen::Index>& held) {
    const Covariance covariance = Judge(archive, values, data, cost, priors, held);
    Identifiability judgement{covariance, {}, WeakestDirections(archive.lattice(), covariance)};
    for (const Eigen::Index j : held)
      judgement.noisy.push_back(archive.lattice().axes()[static_cast<std::size_t>(j)].name);
    return judgement;
  };
  Identifiability before = judged({});
  for (int k = 0; k < kOtherPoints && before.HasUndetermined(); ++k) {
    Draws draws(seed, DrawPurpose::kProbe, k, 0);
    const LatticePoint point = RandomPoint(archive.lattice(), draws);
    const std::optional<Slopes> there = SlopesAt(archive, archive.lattice().Values(point), differences);
    if (!there) continue;
    const auto rows = there->jacobian.topRows(count);
    Eigen::MatrixXd both(data.rows() + count, data.cols());
    // A point of large slopes must not make those of another look small.
    both << data / Largest(data), rows / Largest(rows);
    data = std::move(both);
    before = judged({});
  }
  if (before.HasUndetermined())
    if (const std::vector<Eigen::Index> noisy = NoisyOf(archive, *here); !noisy.empty()) before = judged(noisy);
  return before;
}

}  // namespace

// A model's own derivatives are exact for what it leaves out of them: parameters that do the same have the same slopes,
// and those that do nothing have none. But they may be too rough to distinguish a small slope from none.
std::optional<Identifiability> IdentifiabilityBefore(Archive& archive, const VehicleObjective& objective,
                                                     std::uint64_t seed, Differences differences) {
  if (differences == Differences::kAutomatic && archive.problem().differentiate) {
    std::optional<Identifiability> before = IdentifiabilityBy(Differences::kAutomatic, archive, objective, seed);
    if (before && !before->HasUndetermined()) return before;
  }
  return IdentifiabilityBy(Differences::kCentral, archive, objective, seed);
}

}  // namespace fourpost
