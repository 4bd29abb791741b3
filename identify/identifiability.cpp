#include "identify/identifiability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "identify/difference_jacobian.h"
#include "identify/fit_variables.h"
#include "identify/search/draws.h"
#include "identify/search/dvhde_operators.h"

namespace fourpost {
namespace {

/// Of the whitened residuals with respect to FitVariables, the priors' rows last; nothing where it cannot be told.
std::optional<Eigen::MatrixXd> JacobianAt(Archive& archive, const Eigen::VectorXd& values, double& cost) {
  const Evaluation here = archive.EvaluateValues({values}).front();
  if (!here.ok()) return std::nullopt;
  cost = here.cost();
  const FitVariables variables(archive.lattice());
  const double step = StepFor(archive.problem().accuracy, Differences::kCentral);
  // A model's own derivatives may be good for steps only; too rough to tell a small slope from none.
  return DifferenceJacobian(archive, variables, variables.FromValues(values), here.residuals, step,
                            Differences::kCentral);
}

/// `data` about these values; variances are not looked at, so no inflation.
Covariance Judge(const Archive& archive, const Eigen::VectorXd& values, const Eigen::MatrixXd& data, double cost,
                 const Eigen::MatrixXd& priors) {
  return EstimateCovariance(data, FitVariables(archive.lattice()).Slopes(values), cost, {.inflate = false}, priors);
}

/// Largest singular value.
double Largest(const Eigen::MatrixXd& jacobian) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> squares(jacobian.transpose() * jacobian, Eigen::EigenvaluesOnly);
  return std::max(std::sqrt(squares.eigenvalues().maxCoeff()), std::numeric_limits<double>::min());
}

}  // namespace

std::string RemedyFor(const Eigen::VectorXd& direction) {
  constexpr double kAlike = 0.5;
  // Lengths and angles have no part in the scale, and other open directions may be mixed in.
  const double largest = direction.cwiseAbs().maxCoeff();
  const auto with = (direction.array() > kAlike * largest).count();
  const auto against = (direction.array() < -kAlike * largest).count();
  const bool is_scale = std::min(with, against) == 0 && with + against > 2 && 2 * (with + against) >= direction.size();
  if (is_scale)
    return "accelerations and strut motions do not change when all masses and rates are scaled alike: measure a force "
           "(tyre forces or static loads), leave a mass out of `free`, or give one a prior_sd; where a force is "
           "measured "
           "already, another channel outweighs it by far: check the units";
  return "leave one of them out of `free`, give it a prior_sd, or measure a channel or a pattern of the posts that "
         "tells them apart";
}

std::vector<std::string> WeakestDirections(const Lattice& lattice, const Covariance& covariance) {
  const Eigen::Index n = covariance.directions.cols();
  std::vector<std::string> weakest;
  for (Eigen::Index i = std::min<Eigen::Index>(covariance.rank, n - 1); i < n; ++i)
    weakest.push_back(DescribeDirection(lattice, covariance.directions.col(i)));
  return weakest;
}

std::optional<Identifiability> IdentifiabilityBefore(Archive& archive, const VehicleObjective& objective,
                                                     std::uint64_t seed) {
  constexpr int kOtherPoints = 2;
  const Eigen::VectorXd values = objective.FileValues();
  double cost = 0;
  const std::optional<Eigen::MatrixXd> here = JacobianAt(archive, values, cost);
  if (!here) return std::nullopt;
  const Eigen::Index count = here->rows() - objective.prior_count();
  const Eigen::MatrixXd priors = here->bottomRows(objective.prior_count());
  Eigen::MatrixXd data = here->topRows(count);
  Covariance covariance = Judge(archive, values, data, cost, priors);
  for (int k = 0; k < kOtherPoints && covariance.rank < covariance.directions.cols(); ++k) {
    Draws draws(seed, DrawPurpose::kProbe, k, 0);
    const LatticePoint point = RandomPoint(archive.lattice(), draws);
    double there_cost = 0;
    const auto there = JacobianAt(archive, archive.lattice().Values(point), there_cost);
    if (!there) continue;
    Eigen::MatrixXd both(data.rows() + count, data.cols());
    // A point of large slopes must not make those of another look small.
    both << data / Largest(data), there->topRows(count) / Largest(there->topRows(count));
    data = std::move(both);
    covariance = Judge(archive, values, data, cost, priors);
  }
  return Identifiability{covariance, WeakestDirections(archive.lattice(), covariance)};
}

}  // namespace fourpost
