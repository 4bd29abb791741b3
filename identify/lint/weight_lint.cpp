#include "identify/lint/weight_lint.h"

#include <cmath>
#include <vector>

#include "analysis/short_number.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

/// Weight on the tyres that were weighed [N], masses at this end of their bounds.
double WeightAt(const LoadedStudy& study, const CondensedVehicle& condensed, bool at_upper) {
  std::vector<double> values = study.vehicle.ParameterValues();
  for (const std::size_t index : study.free) {
    const Parameter& parameter = study.vehicle.parameters[index];
    if (parameter.dimension == kMass) values[index] = at_upper ? parameter.upper : parameter.lower;
  }
  const Preloads preloads = condensed.PreloadsAt(values);
  double weight = 0;
  for (const MeasuredLoad& load : study.data.static_loads) weight += preloads.tyre[load.tyre];
  return weight;
}

}  // namespace

void LintWeights(const LoadedStudy& study, const CondensedVehicle& condensed, Diagnostics& diagnostics) {
  constexpr double kDeviations = 3;
  if (study.data.static_loads.empty()) return;
  double measured = 0;
  double sd = 0;
  for (const MeasuredLoad& load : study.data.static_loads) {
    measured += load.load_N;
    sd = std::hypot(sd, load.sd_N);
  }
  const double lightest = WeightAt(study, condensed, false);
  const double heaviest = WeightAt(study, condensed, true);
  if (measured > lightest - kDeviations * sd && measured < heaviest + kDeviations * sd) return;
  const bool is_heavy = measured > heaviest;
  const double beyond = (is_heavy ? measured - heaviest : lightest - measured) / kGravity;
  diagnostics.Warning(
      study.study.static_loads_file->string(), 0,
      "the static loads add up to " + ShortNumber(measured / 1000, 2) + " kN, the vehicle with all masses at their " +
          (is_heavy ? "upper" : "lower") + " bounds to " + ShortNumber((is_heavy ? heaviest : lightest) / 1000, 2) +
          " kN, " + ShortNumber(beyond, 2) + " kg" + (is_heavy ? " less" : " more") + ": " +
          (is_heavy ? "load cells not tared, wheelpans or a load weighed along" : "corners or axles left out") +
          ", or bounds of masses that leave the answer out");
}

}  // namespace fourpost
