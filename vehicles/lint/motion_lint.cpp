#include "vehicles/lint/motion_lint.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/text/units.h"
#include "vehicles/description/element_list.h"
#include "vehicles/lint/bench_vehicle.h"
#include "vehicles/lint/findings.h"
#include "vehicles/loops/motion_name.h"

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

const Finding& FreeMotion(const LintSubject& subject, Direction direction) {
  if (subject.vehicle.tyres.empty()) return kMotionFree;
  if (direction == Direction::kForeAft) return kMotionFreeAlong;
  return direction == Direction::kLateral || direction == Direction::kYaw ? kMotionFreeAcross : kMotionFree;
}

/// What a damper of this rate along `direction` adds to the mode's damping ratio, where that is small:
/// rate |b' shape|^2 / (2 w shape' M shape), b: direction.
double AddedRatio(const LintSubject& subject, const Mode& mode, double rate, const Eigen::VectorXd& direction) {
  const double motion = std::norm((direction.transpose() * mode.shape).value());
  const double inertia = (mode.shape.adjoint() * subject.model.mass * mode.shape).value().real();
  return rate * motion / (2 * std::abs(mode.pole) * inertia);
}

/// By the dampers' friction, which the mode's own ratio leaves out, at the speed of DashpotLaw::MeanRate.
double FrictionRatio(const LintSubject& subject, const Mode& mode) {
  constexpr double kSpeed_mps = 0.1;
  double ratio = 0;
  for (const Damper& damper : subject.vehicle.dampers)
    if (const auto& friction = damper.law.friction)
      ratio += AddedRatio(subject, mode, subject.At(friction->force) / kSpeed_mps,
                          subject.pose.LineLength(damper.line).gradient);
  return ratio;
}

/// By 1 kN*s/m of each tyre along `direction`.
double TyreRatio(const LintSubject& subject, const Mode& mode, const Eigen::Vector3d& direction) {
  double ratio = 0;
  for (const Tyre& tyre : subject.vehicle.tyres)
    ratio += AddedRatio(subject, mode, 1000, subject.pose.FootPosition(tyre, direction).gradient);
  return ratio;
}

/// The attribute of the tyres that would damp the mode; empty where none does.
std::string TyreDamping(const LintSubject& subject, const Mode& mode, Direction direction) {
  constexpr double kWorthwhile = 0.02;
  const bool is_ride =
      direction == Direction::kHeave || direction == Direction::kRoll || direction == Direction::kPitch;
  const double along = TyreRatio(subject, mode, Eigen::Vector3d::UnitX());
  const double across = TyreRatio(subject, mode, Eigen::Vector3d::UnitY());
  if (!is_ride && std::max(along, across) > kWorthwhile)
    return along > across ? "longitudinal_damping" : "lateral_damping";
  return "";
}

}  // namespace

void LintFreeMotions(const LintSubject& subject, FileFaults& findings) {
  if (IsBenchVehicle(subject.vehicle)) return;
  std::set<std::string> reported;  // a motion may have parts that go by one name
  for (const NamedMotion& motion : NameMotions(subject.links, FreeMotions(subject)))
    if (reported.insert(motion.Text()).second)
      findings.Report(FreeMotion(subject, motion.direction), LineOf(subject.vehicle, motion.link), {motion.Text()});
}

void LintBlindSensors(const LintSubject& subject, FileFaults& findings) {
  // Rounding of directions and of levers of some metres.
  constexpr double kRounding = 1e-9;
  using Field = Eigen::MatrixXd CondensedModel::*;
  const auto reads = [&](Eigen::Index sensor) {
    for (const Field field :
         {&CondensedModel::on_position, &CondensedModel::on_velocity, &CondensedModel::on_acceleration,
          &CondensedModel::on_post_height, &CondensedModel::on_post_velocity, &CondensedModel::on_post_acceleration})
      if (!(subject.model.*field).row(sensor).isZero(kRounding)) return true;
    return false;
  };
  for (std::size_t i = 0; i < subject.vehicle.sensors.size(); ++i) {
    const Sensor& sensor = subject.vehicle.sensors[i];
    if (reads(static_cast<Eigen::Index>(i))) continue;
    findings.Report(kSensorBlind, sensor.source_line, {Called("fp:sensor", sensor.name)});
  }
}

void LintRingingModes(const LintSubject& subject, FileFaults& findings) {
  constexpr double kLeastRatio = 0.005;
  constexpr double kFastest_Hz = 30;  // a rig's stepped sines end there
  for (const Mode& mode : subject.modes) {
    if (mode.kind != Mode::Kind::kOscillating || mode.frequency_Hz > kFastest_Hz) continue;
    const double ratio = std::abs(mode.damping_ratio);
    if (ratio + FrictionRatio(subject, mode) >= kLeastRatio) continue;
    const std::vector<NamedMotion> motions = NameMotions(subject.links, mode.shape.real());
    if (motions.empty()) continue;
    const std::string by_tyres = TyreDamping(subject, mode, motions.front().direction);
    std::vector<std::string> words = {mode.name, Readable(mode.frequency_Hz, "Hz"),
                                      FormatQuantity(std::round(1e5 * ratio) / 1e5, "%")};
    if (!by_tyres.empty()) words.push_back(by_tyres);
    findings.Report(by_tyres.empty() ? kModeUndamped : kModeUndampedByTyres,
                    LineOf(subject.vehicle, motions.front().link), words);
  }
}

}  // namespace fourpost
