#include "vehicles/motion_lint.h"

#include <algorithm>
#include <cmath>

#include "vehicles/motion_name.h"

namespace fourpost {
namespace {

using Direction = NamedMotion::Direction;

int LineOf(const Vehicle& vehicle, const std::string& link) {
  const auto found =
      std::find_if(vehicle.links.begin(), vehicle.links.end(), [&](const Link& l) { return l.name == link; });
  return found == vehicle.links.end() ? 0 : found->line;
}

/// In columns.
Eigen::MatrixXd FreeMotions(const LintSubject& subject) {
  Eigen::MatrixXd motions(subject.condensed.size(), 0);
  for (const Mode& mode : subject.modes) {
    if (mode.kind != Mode::Kind::kFree) continue;
    motions.conservativeResize(Eigen::NoChange, motions.cols() + 1);
    motions.rightCols<1>() = mode.shape.real();
  }
  return motions;
}

std::string Remedy(const LintSubject& subject, Direction direction) {
  if (!subject.vehicle.tyres.empty()) {
    if (direction == Direction::kForeAft) return "give the tyres a longitudinal stiffness";
    if (direction == Direction::kLateral || direction == Direction::kYaw) return "give the tyres a lateral stiffness";
  }
  return "add a spring or a bushing, or take a joint without this freedom";
}

/// Whether it moves a damper, if only one whose friction does not show in its mean rate.
bool MovesADamper(const CondensedModel& model, const Eigen::VectorXd& shape) {
  constexpr double kStill = 1e-6;  // of the coordinate that moves most
  return std::any_of(model.dashpots.begin(), model.dashpots.end(), [&](const CondensedModel::Dashpot& dashpot) {
    return dashpot.law.GreatestRate() > 0 && std::abs(dashpot.direction.dot(shape)) > kStill;
  });
}

}  // namespace

void LintFreeMotions(const LintSubject& subject, FileFaults& findings) {
  for (const NamedMotion& motion : NameMotions(subject.links, FreeMotions(subject)))
    findings.Warning(LineOf(subject.vehicle, motion.link),
                     "nothing resists " + motion.Text() + ": " + Remedy(subject, motion.direction));
}

void LintUndampedMotions(const LintSubject& subject, FileFaults& findings) {
  // Rounding of poles, and far below what any damper gives.
  constexpr double kUndamped = 1e-6;
  for (const Mode& mode : subject.modes) {
    if (mode.kind != Mode::Kind::kOscillating || std::abs(mode.damping_ratio) > kUndamped) continue;
    const Eigen::VectorXd shape = mode.shape.real();
    if (MovesADamper(subject.model, shape)) continue;
    for (const NamedMotion& motion : NameMotions(subject.links, shape)) {
      const bool is_ride = motion.direction == Direction::kHeave || motion.direction == Direction::kRoll ||
                           motion.direction == Direction::kPitch;
      if (is_ride)
        findings.Warning(LineOf(subject.vehicle, motion.link),
                         "no damper damps " + motion.Text() + ": add an fp:damper, or damping to a bushing or tyre");
    }
  }
}

}  // namespace fourpost
