#include "identify/experiments/kinematics/kinematic_lint.h"

#include <cmath>

#include "analysis/text/text_table.h"
#include "identify/experiments/kinematics/findings.h"

namespace fourpost {
namespace {

std::string WithUnit(double si, const std::string& unit) {
  return InUnit(si, unit, 3) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

void ReportRefusal(const KinematicAnswer::Refusal& refusal, std::span<const KinematicSweep> sweeps,
                   const std::string& study, Diagnostics& diagnostics) {
  using Kind = KinematicAnswer::Refusal::Kind;
  const KinematicSweep& sweep = sweeps[refusal.sweep];
  const Place place{study, sweep.line};
  switch (refusal.kind) {
    case Kind::kNotReached:
      return diagnostics.Report(
          kKinematicNotReached, place,
          {sweep.axle_name, sweep.motion, WithUnit(refusal.position, sweep.position_unit()), sweep.recording});
    case Kind::kRigid: return diagnostics.Report(kKinematicRigid, place, {sweep.recording, sweep.axle_name});
    case Kind::kNotThere:
      return diagnostics.Report(
          kKinematicNotOfVehicle, place,
          {sweep.axle_name, std::string(sweep.curves[refusal.curve].quantity->name), sweep.motion, sweep.recording});
  }
}

void LintKinematicSigns(std::span<const KinematicMisfit> misfits, const std::string& study, Diagnostics& diagnostics) {
  // Points that are off change a curve's slope; few turn it round over its whole length.
  constexpr double kOpposite = -0.9;
  constexpr double kAboveNoise = 5;
  for (const KinematicMisfit& one : misfits) {
    const auto count = std::ssize(one.curve->measured);
    const Eigen::Map<const Eigen::VectorXd> all(one.curve->measured.data(), count);
    // Under a load the changes themselves have signs, unless a constant is added to them.
    const bool is_centred = !one.sweep->load || one.curve->has_free_offset;
    const Eigen::VectorXd measured = all.array() - (is_centred ? all.mean() : 0);
    const Eigen::VectorXd modelled = one.modelled.array() - (is_centred ? one.modelled.mean() : 0);
    const double least = kAboveNoise * one.curve->sd * std::sqrt(static_cast<double>(count));
    if (measured.norm() < least || modelled.norm() < least) continue;
    if (measured.dot(modelled) < kOpposite * measured.norm() * modelled.norm())
      diagnostics.Report(kKinematicOpposite, {study, one.sweep->line},
                         {std::string(one.curve->quantity->name), one.curve->of_name, one.sweep->recording});
  }
}

void LintKinematicOffsets(std::span<const KinematicMisfit> misfits, const std::string& study,
                          Diagnostics& diagnostics) {
  constexpr double kLarge = 3;
  constexpr double kShare = 0.9;
  for (const KinematicMisfit& one : misfits) {
    if (one.curve->has_free_offset || one.misfit < kLarge || one.curve->measured.size() < 3) continue;
    const Eigen::Map<const Eigen::VectorXd> measured(one.curve->measured.data(), std::ssize(one.curve->measured));
    const double mean = (measured - one.modelled).mean();
    if (mean * mean < kShare * one.rms * one.rms) continue;
    const std::string name(one.curve->quantity->name);
    diagnostics.Report(
        kKinematicConstantOff, {study, one.sweep->line},
        {name, one.curve->of_name, one.sweep->recording, WithUnit(mean, std::string(one.curve->quantity->unit)),
         Rounded(std::abs(mean) / one.curve->sd, 2), name});
  }
}

}  // namespace fourpost
