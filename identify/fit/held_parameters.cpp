#include "identify/fit/held_parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "identify/refine/difference_jacobian.h"
#include "identify/refine/fit_variables.h"
#include "identify/search/archive.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// In the unit of FitVariables.
double DeviationOf(const Parameter& parameter, const FitVariables& variables, Index j) {
  const double range = variables.upper()[j] - variables.lower()[j];
  if (!parameter.prior_sd) return range / std::sqrt(12.0);
  return variables.is_logarithmic(j) ? *parameter.prior_sd / parameter.value
                                     : *parameter.prior_sd / (parameter.upper - parameter.lower);
}

/// Of those that are held and have a range: the ones within it, or the others.
std::vector<std::size_t> PlacesHeld(const VehicleObjective& objective, bool are_inside) {
  std::vector<std::size_t> places;
  const std::vector<std::size_t>& free = objective.free();
  for (std::size_t i = 0; i < objective.vehicle().parameters.size(); ++i) {
    const Parameter& parameter = objective.vehicle().parameters[i];
    const bool is_free = std::find(free.begin(), free.end(), i) != free.end();
    const bool is_inside = parameter.lower <= parameter.value && parameter.value <= parameter.upper;
    if (!is_free && parameter.lower < parameter.upper && is_inside == are_inside) places.push_back(i);
  }
  return places;
}

/// At the file's values; nothing where it cannot be evaluated or the user stops it.
std::optional<Eigen::MatrixXd> JacobianOf(const VehicleObjective& objective, const RefineOptions& refine, int threads,
                                          const std::function<bool()>& stop, std::int64_t& evaluated) {
  if (objective.free().empty() || stop()) return std::nullopt;
  Archive archive(objective.MakeProblem(), threads);
  archive.StopBatches(stop);
  const FitVariables variables(archive.lattice());
  std::optional<Eigen::MatrixXd> jacobian;
  try {
    const Eigen::VectorXd at = objective.FileValues();
    const Evaluation here = archive.EvaluateValues({at}).front();
    if (here.ok())
      jacobian = DifferenceJacobian(archive, variables, variables.FromValues(at), here.residuals,
                                    refine.DifferenceStep(archive.problem()), Differences::kAutomatic);
  } catch (const BatchStopped&) {
  }
  evaluated += archive.counts().paid;
  return jacobian;
}

}  // namespace

HeldParameters HeldAt(const VehicleObjective& objective, const Eigen::VectorXd& values, const RefineOptions& refine,
                      int threads, const std::function<bool()>& stop, std::int64_t& evaluated) {
  const std::vector<std::size_t> places = PlacesHeld(objective, true);
  Vehicle fitted = objective.vehicle();
  const std::vector<double> all = objective.AllParameters(values);
  for (std::size_t i = 0; i < all.size(); ++i) fitted.parameters[i].value = all[i];
  for (Parameter& parameter : fitted.parameters) {
    parameter.prior_sd.reset();
    parameter.like.reset();
  }
  const auto of = [&](const std::vector<std::size_t>& some) {
    return JacobianOf(VehicleObjective(fitted, some, objective.blocks()), refine, threads, stop, evaluated);
  };
  HeldParameters held{.left_out = PlacesHeld(objective, false)};
  const auto add = [&](const std::vector<std::size_t>& some, const Eigen::MatrixXd& jacobian) {
    held.places.insert(held.places.end(), some.begin(), some.end());
    held.jacobian.conservativeResize(jacobian.rows(), held.jacobian.cols() + jacobian.cols());
    held.jacobian.rightCols(jacobian.cols()) = jacobian;
  };
  if (const std::optional<Eigen::MatrixXd> together = of(places)) {
    add(places, *together);
  } else {
    for (const std::size_t place : places)
      if (const std::optional<Eigen::MatrixXd> alone = of({place})) add({place}, *alone);
      else held.left_out.push_back(place);
  }
  if (stop()) held.left_out.clear();
  if (held.places.empty()) return held;
  const FitVariables variables(VehicleObjective(fitted, held.places, objective.blocks()).MakeProblem().lattice);
  held.variable_sd.resize(std::ssize(held.places));
  for (Index i = 0; i < held.variable_sd.size(); ++i)
    held.variable_sd[i] =
        DeviationOf(objective.vehicle().parameters[held.places[static_cast<std::size_t>(i)]], variables, i);
  return held;
}

}  // namespace fourpost
