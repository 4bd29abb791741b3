#include "identify/uncertainty/other_optima.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/decompositions.h"
#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

double LogVolume(const Eigen::MatrixXd& covariance) {
  return SymmetricEigenvaluesOf(covariance).cwiseMax(1e-300).array().log().sum();
}

}  // namespace

std::vector<EndedStart> OtherOptima(const std::vector<EndedStart>& ends, const ParameterSpread& best, double cost,
                                    double inflation, const Eigen::MatrixXd& covariance) {
  constexpr double kMostRise = 30;
  const FitVariables variables(best.lattice);
  const auto count = static_cast<double>(best.judged.size());
  // By how much noise would have to be larger for deviations like these.
  const double wider = std::exp((LogVolume(covariance) - LogVolume(best.noise)) / count);
  const Eigen::ArrayXd sd = covariance.diagonal().array().sqrt();
  std::vector<Eigen::VectorXd> known = {variables.FromValues(best.values)(best.judged)};
  std::vector<EndedStart> others;
  for (const EndedStart& end : ends) {
    if (!((end.cost - cost) / (inflation * inflation * wider) <= kMostRise)) continue;
    const Eigen::VectorXd x = variables.FromValues(end.values)(best.judged);
    const bool is_known = std::any_of(
        known.begin(), known.end(), [&](const Eigen::VectorXd& one) { return ((x - one).array().abs() <= sd).all(); });
    if (is_known) continue;
    known.push_back(x);
    others.push_back(end);
  }
  return others;
}

}  // namespace fourpost
