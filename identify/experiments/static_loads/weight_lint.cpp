#include "identify/experiments/static_loads/weight_lint.h"

#include <cmath>
#include <vector>

#include "analysis/text/short_number.h"
#include "identify/experiments/static_loads/findings.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

/// Weight on the tyres that were weighed [N], masses at this end of their bounds.
double WeightAt(const StaticLoadTest& static_loads, const Subject& subject, bool at_upper) {
  std::vector<double> values = subject.vehicle().ParameterValues();
  for (const std::size_t index : subject.free()) {
    const Parameter& parameter = subject.vehicle().parameters[index];
    if (parameter.dimension == kMass) values[index] = at_upper ? parameter.upper : parameter.lower;
  }
  const Preloads preloads = subject.Condensed()->PreloadsAt(values);
  double weight = 0;
  for (const MeasuredLoad& load : static_loads.loads) weight += preloads.tyre[load.tyre];
  return weight;
}

}  // namespace

void LintWeights(const StaticLoadTest& static_loads, const Subject& subject, Diagnostics& diagnostics) {
  constexpr double kDeviations = 3;
  if (static_loads.loads.empty()) return;
  double measured = 0;
  double sd = 0;
  for (const MeasuredLoad& load : static_loads.loads) {
    measured += load.load_N;
    sd = std::hypot(sd, load.sd_N);
  }
  const double lightest = WeightAt(static_loads, subject, false);
  const double heaviest = WeightAt(static_loads, subject, true);
  if (measured > lightest - kDeviations * sd && measured < heaviest + kDeviations * sd) return;
  const bool is_heavy = measured > heaviest;
  const double bound = is_heavy ? heaviest : lightest;
  diagnostics.Report(is_heavy ? kStaticLoadsAboveBounds : kStaticLoadsBelowBounds, {static_loads.plan.table.string()},
                     {ShortNumber(measured / 1000, 2), ShortNumber(bound / 1000, 2),
                      ShortNumber(std::abs(measured - bound) / kGravity, 2)});
}

}  // namespace fourpost
