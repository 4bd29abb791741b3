#include "vehicles/lint/parameter_lint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vehicles/description/element_list.h"
#include "vehicles/description/moved_points.h"
#include "vehicles/lint/findings.h"

namespace fourpost {
namespace {

/// Sums of terms that do not change, but for rounding where a factor is zero but for rounding.
constexpr double kRounding = 1e-12;

bool Differs(double a, double b, double scale) { return std::abs(a - b) > kRounding * scale; }

bool Differ(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (a.size() == 0) return false;
  return Differs((a - b).cwiseAbs().maxCoeff(), 0, a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

bool Differ(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  return !std::equal(a.begin(), a.end(), b.begin(), [&](double x, double y) { return !Differs(x, y, scale); });
}

bool Differ(const SpringLaw& a, const SpringLaw& b) {
  for (const double place : {0.01, 0.03, 0.1, 0.3})
    for (const double x : {-place, place}) {
      const double one = a.Force(x);
      const double other = b.Force(x);
      if (Differs(one, other, std::abs(one) + std::abs(other))) return true;
    }
  return false;
}

bool Differ(const CondensedModel::Dashpot& a, const CondensedModel::Dashpot& b) {
  for (const double speed : {0.003, 0.03, 0.3, 3.0})
    for (const double v : {-speed, speed}) {
      const double one = a.law.Force(v);
      const double other = b.law.Force(v);
      if (Differs(one, other, std::abs(one) + std::abs(other))) return true;
    }
  return Differ(a.series, b.series);
}

bool Differ(const Preloads& a, const Preloads& b, double scale) {
  if (Differ(a.spring, b.spring, scale) || Differ(a.tyre, b.tyre, scale)) return true;
  for (std::size_t i = 0; i < a.bushing.size(); ++i)
    if (Differs((a.bushing[i] - b.bushing[i]).norm(), 0, scale)) return true;
  return false;
}

bool Differ(const CondensedModel& a, const CondensedModel& b, double weight) {
  using Field = Eigen::MatrixXd CondensedModel::*;
  for (const Field field :
       {&CondensedModel::mass, &CondensedModel::damping, &CondensedModel::stiffness, &CondensedModel::post_stiffness,
        &CondensedModel::post_damping, &CondensedModel::on_position, &CondensedModel::on_velocity,
        &CondensedModel::on_acceleration, &CondensedModel::on_post_height, &CondensedModel::on_post_velocity,
        &CondensedModel::on_post_acceleration})
    if (Differ(a.*field, b.*field)) return true;
  for (std::size_t i = 0; i < a.dashpots.size(); ++i)
    if (Differ(a.dashpots[i], b.dashpots[i])) return true;
  for (std::size_t i = 0; i < a.rubbings.size(); ++i)
    if (!(a.rubbings[i].law == b.rubbings[i].law)) return true;
  for (std::size_t i = 0; i < std::min(a.stiffenings.size(), b.stiffenings.size()); ++i)
    if (Differ(a.stiffenings[i].law, b.stiffenings[i].law)) return true;
  for (std::size_t i = 0; i < a.curved_tyres.size(); ++i)
    if (!(a.curved_tyres[i].law == b.curved_tyres[i].law)) return true;
  return Differ(a.preloads, b.preloads, weight);
}

/// The ends of a parameter's range, or of one per cent about a fixed value.
std::pair<double, double> RangeOf(const Parameter& parameter) {
  if (parameter.lower < parameter.upper) return {parameter.lower, parameter.upper};
  constexpr double kShare = 0.01;
  return {(1 - kShare) * parameter.value, (1 + kShare) * parameter.value};
}

}  // namespace

void LintIdleParameters(const LintSubject& subject, FileFaults& findings) {
  const Vehicle& vehicle = subject.vehicle;
  const std::vector<bool> are_in_curved_laws = AreInCurvedLaws(vehicle);
  // Of points as drawn, like the reduced model.
  const std::vector<bool> move_points = MovePoints(vehicle);
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[i];
    const auto [lower, upper] = RangeOf(parameter);
    if (lower == upper || are_in_curved_laws[i] || move_points[i]) continue;
    std::vector<double> values = subject.values;
    values[i] = lower;
    const CondensedModel low = subject.condensed.At(values);
    values[i] = upper;
    if (!Differ(low, subject.condensed.At(values), subject.Weight()))
      findings.Report(kParameterIdle, parameter.line, {parameter.name});
  }
}

}  // namespace fourpost
