#include "identify/fit/fitted_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "identify/refine/fit_variables.h"
#include "vehicles/reader/physical_range.h"

namespace fourpost {
namespace {

/// Deviation, its parts and the interval of a parameter; `k`: its place among the free ones.
void DescribeCertainty(const Certainty& certainty, Eigen::Index k, double slope, bool is_logarithmic,
                       const PhysicalRange& physical, FittedParameter& fitted) {
  fitted.state = certainty.states[static_cast<std::size_t>(k)];
  fitted.sd = slope * certainty.total_sd[k];
  fitted.noise_sd = slope * certainty.noise_sd[k];
  fitted.held_sd = slope * certainty.held_sd[k];
  fitted.model_sd = slope * certainty.model_sd[k];
  fitted.limited_by = certainty.LimitedBy(k);
  const double range = fitted.upper - fitted.lower;
  const double moved = certainty.MovedByMissing()[k];
  // `from`: in FitVariables.
  const auto end = [&](double from, double sd, int side) {
    const double reach = from + side * certainty.covariance.reach_95 * sd;
    return is_logarithmic ? fitted.value * std::exp(reach) : fitted.value + reach * range;
  };
  // Noise may reach beyond the range that the file gives; what the model lacks is not known so well.
  const double noise = certainty.noise_sd[k];
  const double total = certainty.SdAboutEnds(k);
  fitted.lower_95 = std::max(end(std::min(0.0, moved), total, -1), std::min(end(0, noise, -1), fitted.lower));
  fitted.upper_95 = std::min(end(std::max(0.0, moved), total, 1), std::max(end(0, noise, 1), fitted.upper));
  if (fitted.state == ParameterState::kDetermined &&
      (fitted.RelativeSd() > kUndeterminedShare ||
       FillsBounds(fitted.lower_95, fitted.upper_95, fitted.lower, fitted.upper)))
    fitted.state = ParameterState::kUndetermined;
  if (!std::isfinite(fitted.sd)) return;
  fitted.lower_95 = std::max(fitted.lower_95, physical.least);
  fitted.upper_95 = std::min(fitted.upper_95, physical.greatest);
}

}  // namespace

std::vector<FittedParameter> DescribeParameters(const VehicleObjective& objective, const Lattice& lattice,
                                                const Eigen::VectorXd& values,
                                                const std::optional<Certainty>& certainty) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const FitVariables variables(lattice);
  const Eigen::VectorXd slopes = variables.Slopes(values);
  const std::vector<double> all = objective.AllParameters(values);
  const std::vector<PhysicalRange> physical = PhysicalRanges(objective.vehicle());
  std::vector<FittedParameter> out;
  for (std::size_t i = 0; i < objective.free().size(); ++i) {
    const Parameter& parameter = objective.vehicle().parameters[objective.free()[i]];
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    FittedParameter fitted;
    fitted.name = parameter.name;
    fitted.start = parameter.value;
    fitted.value = values[k];
    fitted.prior_sd = parameter.prior_sd;
    if (const auto other = parameter.like ? objective.vehicle().IndexOf(parameter.like->parameter) : std::nullopt) {
      fitted.like = parameter.like;
      fitted.from_like =
          std::log(values[k] / all[*other] * objective.vehicle().parameters[*other].value / parameter.value) /
          parameter.like->sd;
    }
    fitted.lower = parameter.lower;
    fitted.upper = parameter.upper;
    fitted.sd = fitted.noise_sd = fitted.held_sd = fitted.model_sd = fitted.lower_95 = fitted.upper_95 = kUnknown;
    if (certainty)
      DescribeCertainty(*certainty, k, slopes[k], variables.is_logarithmic(k), physical[objective.free()[i]], fitted);
    fitted.at_bound = IsAtBound(lattice.axes()[i], values[k]);
    fitted.dimension = parameter.dimension;
    fitted.unit = parameter.unit;
    out.push_back(fitted);
  }
  return out;
}

void AllowForMissing(const VehicleObjective& objective, MissingPhysics missing, FitResult& fit) {
  if (!fit.certainty || fit.certainty->judged.empty() || missing.names.empty()) return;
  const Lattice lattice = objective.MakeProblem().lattice;
  RefineResult explained;
  explained.values.resize(std::ssize(fit.parameters));
  for (Eigen::Index j = 0; j < explained.values.size(); ++j)
    explained.values[j] = fit.parameters[static_cast<std::size_t>(j)].value;
  explained.residuals = std::move(missing.residuals);
  explained.jacobian = std::move(missing.jacobian);
  const ModelErrorEstimate left =
      ModelErrorLeft(objective, lattice, explained, fit.options.refine.loss, fit.certainty->judged);
  fit.certainty->AllowForMissing(std::move(missing.names), std::move(missing.moved), left);
  fit.parameters = DescribeParameters(objective, lattice, explained.values, fit.certainty);
}

}  // namespace fourpost
