#include "vehicles/bench/offset_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/signals/deviation.h"
#include "analysis/signals/turning_points.h"
#include "analysis/text/short_number.h"
#include "vehicles/bench/findings.h"

namespace fourpost {
namespace {

double Span(std::span<const double> signal) {
  const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
  return *most - *least;
}

std::vector<double> AtSamples(const BenchMotion& motion) {
  std::vector<double> extension;
  for (std::size_t k = 0; k < motion.extension.size(); k += motion.steps) extension.push_back(motion.extension[k]);
  return extension;
}

/// Mean of neighbouring turning points, at one of which friction pulls and at the other pushes, of the slowest quarter
/// of the half cycles: what lies in line with a dashpot, and filters, turn the force's phase least there.
double AtRest(std::span<const double> force, const std::vector<std::size_t>& turns) {
  std::vector<std::size_t> slow;
  for (std::size_t i = 1; i < turns.size(); ++i) slow.push_back(i);
  std::stable_sort(slow.begin(), slow.end(),
                   [&](std::size_t a, std::size_t b) { return turns[a] - turns[a - 1] > turns[b] - turns[b - 1]; });
  slow.resize((slow.size() + 3) / 4);
  double sum = 0;
  for (const std::size_t i : slow) sum += 0.5 * (force[turns[i]] + force[turns[i - 1]]);
  return sum / static_cast<double>(slow.size());
}

BenchMotion Centred(BenchMotion motion, double mean) {
  for (double& value : motion.extension) value -= mean;
  return motion;
}

}  // namespace

void CheckBenchOffsets(const BenchDamper& damper, const RecordedForce& recorded, std::span<const double> values,
                       const std::string& file, Diagnostics& diagnostics) {
  const auto& [motion, filter, force, first, end] = recorded;
  // A linear model of a bilinear damper with a spring in line is off by a tenth at 20 Hz.
  constexpr double kOfForce = 0.15;
  std::vector<double> extension = AtSamples(motion);
  std::vector<double> modelled = damper.Tensions(motion, values);
  const auto settled = [from = first, count = end - first](std::span<const double> signal) {
    return signal.subspan(from, count);
  };
  if (first >= end || end > force.size() || modelled.size() != force.size()) return;
  const double mean = Mean(settled(extension));
  const double stroke = Span(settled(extension));
  if (filter) {
    filter->Apply(extension);
    filter->Apply(modelled);
  }
  const std::vector<std::size_t> turns = TurningPoints(settled(extension));
  const double span = Span(settled(force));
  if (turns.size() < 2 || span == 0) return;
  const double rest = AtRest(settled(force), turns);
  if (!damper.HasSprings() && std::abs(rest - AtRest(settled(modelled), turns)) > kOfForce * span)
    diagnostics.Report(rest < 0 ? kForcePushes : kForcePulls, {file},
                       {ShortNumber(rest) + " N", ShortNumber(span) + " N"});
  if (std::abs(mean) <= stroke) return;
  std::vector<double> centred = damper.Tensions(Centred(motion, mean), values);
  if (filter) filter->Apply(centred);
  double most = 0;
  for (std::size_t k = first; k < std::min(end, centred.size()); ++k)
    most = std::max(most, std::abs(centred[k] - modelled[k]));
  if (centred.size() == modelled.size() && most <= kOfForce * span) return;
  diagnostics.Report(kDisplacementOffset, {file}, {ShortNumber(mean) + " m", ShortNumber(stroke) + " m"});
}

}  // namespace fourpost
