#include "identify/experiments/time_history/release.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "analysis/numerics/decompositions.h"
#include "identify/experiments/time_history/findings.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/condensed/port.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Forces of a pose at rest, and their derivatives. Springs in series with a dashpot carry nothing then.
struct Statics {
  VectorXd force;
  MatrixXd stiffness;
};

Statics StaticsOf(const CondensedModel& model, const std::vector<Port>& ports, const VectorXd& pose) {
  const Index n = model.mass.rows();
  Statics out{.force = model.stiffness * pose, .stiffness = model.stiffness};
  for (const Port& port : ports) {
    if (std::holds_alternative<DashpotRemainder>(port.law)) continue;
    const VectorXd direction = port.direction.head(n);
    const std::array<double, 1> extension = {direction.dot(pose)};
    const std::array<double, 1> rate = {0};
    std::array<double, 1> remainder = {0};
    std::array<double, 1> slope = {0};
    std::array<double, 1> by_rate = {0};
    if (const auto* friction = std::get_if<FrictionRemainder>(&port.law)) {
      // It came there in one stroke.
      const DahlFriction::Stroke stroke = friction->law.After(0, extension[0]);
      remainder[0] = stroke.force;
      slope[0] = stroke.by_extension;
    } else {
      Remainders(port.law, extension, rate, remainder);
      RemainderSlopes(port.law, extension, rate, slope, by_rate);
    }
    out.force += remainder[0] * direction;
    out.stiffness += slope[0] * direction * direction.transpose();
  }
  return out;
}

/// From no tension to this one over the stiffness [m]; nearly all of the sliding force takes a finite stroke.
double StrokeTo(double tension_m, const DahlFriction& law) {
  constexpr double kAll = 1 - 1e-9;
  const double sliding_m = law.force / law.stiffness;
  if (sliding_m == 0) return 0;
  const double share = std::min(kAll, std::abs(tension_m) / sliding_m);
  return std::copysign(-sliding_m * std::log1p(-share), tension_m);
}

}  // namespace

VectorXd Release::Reach(const CondensedModel& model) const {
  VectorXd reach = VectorXd::Constant(Unknowns(model), std::numeric_limits<double>::infinity());
  if (from == From::kHeld) return reach;
  const Index frictions = std::ssize(model.rubbings);
  for (Index i = 0; i < frictions; ++i) {
    const DahlFriction& law = model.rubbings[static_cast<std::size_t>(i)].law;
    reach[reach.size() - frictions + i] = law.force / law.stiffness;
  }
  return reach;
}

Index Release::Unknowns(const CondensedModel& model) const {
  if (from == From::kHeld)
    return std::count_if(held.begin(), held.end(), [](const Hold& hold) { return !hold.reading_m; });
  return (from == From::kRest ? 1 : 2) * model.mass.rows() + std::ssize(model.rubbings);
}

VectorXd HeldPose(const CondensedModel& model, const MatrixXd& rows, const VectorXd& readings) {
  constexpr int kMost = 60;
  constexpr double kGood = 1e-9;  // of the largest force
  const Index n = model.mass.rows();
  const Index m = rows.rows();
  const std::vector<Port> ports = PortsOf(model);
  // Of the holding forces [N]: friction that still sticks is far stiffer than what holds the pose, and the equations
  // would look singular.
  const double unit = model.rubbings.empty() ? 1 : model.Stuck().stiffness.norm();
  VectorXd pose = VectorXd::Zero(n);
  VectorXd holding = VectorXd::Zero(m);
  for (int i = 0; i < kMost; ++i) {
    const Statics statics = StaticsOf(model, ports, pose);
    const VectorXd held = rows.transpose() * holding;
    const VectorXd reached = rows * pose;
    VectorXd left(n + m);
    left.head(n) = statics.force - held;
    left.tail(m) = reached - readings;
    const double scale = 1 + held.norm();
    if (left.head(n).norm() < kGood * scale && left.tail(m).norm() < kGood) return pose;
    MatrixXd system = MatrixXd::Zero(n + m, n + m);
    system.topLeftCorner(n, n) = statics.stiffness;
    system.topRightCorner(n, m) = -unit * rows.transpose();
    system.bottomLeftCorner(m, n) = unit * rows;
    // A wheel in the air and unheld is held by nothing else in a direction that no spring acts in: it stays there.
    left.tail(m) *= unit;
    const VectorXd step = LeastNorm(system, 1e-12).Solve(VectorXd(-left));
    pose += step.head(n);
    holding += unit * step.tail(m);
    if (!pose.allFinite()) break;
  }
  throw SimulationError(kReleaseWithoutPose);
}

VectorXd ReleasedState(const Release& release, const CondensedModel& model, const VectorXd& unknowns) {
  const Index n = model.mass.rows();
  VectorXd state = VectorXd::Zero(LinearVehicle(model, LinearVehicle::Rates::kCentre).size() + n);
  if (release.from != Release::From::kHeld) {
    const Index strokes = std::ssize(model.rubbings);
    state.head(unknowns.size() - strokes) = unknowns.head(unknowns.size() - strokes);
    const Index size = state.size();
    state.conservativeResize(size + strokes);
    for (Index i = 0; i < strokes; ++i)
      state[size + i] =
          StrokeTo(unknowns[unknowns.size() - strokes + i], model.rubbings[static_cast<std::size_t>(i)].law);
    return state;
  }
  const auto count = static_cast<Index>(release.held.size());
  MatrixXd rows(count, n);
  VectorXd readings(count);
  Index next = 0;
  for (Index i = 0; i < count; ++i) {
    const Release::Hold& hold = release.held[static_cast<std::size_t>(i)];
    rows.row(i) = model.on_position.row(static_cast<Index>(hold.index));
    readings[i] = hold.reading_m ? *hold.reading_m : unknowns[next++];
  }
  state.head(n) = HeldPose(model, rows, readings);
  return state;
}

EstimatedStart EstimateStart(const std::function<VectorXd(const VectorXd&)>& residuals, const VectorXd& guess,
                             const VectorXd& reach) {
  constexpr int kMost = 30;
  // Metres and metres per second; the motion is as exact as rounding.
  constexpr double kApart = 1e-6;
  // Gains below it are rounding.
  constexpr double kLeastGain = 1e-11;
  EstimatedStart out{.unknowns = guess};
  const Index count = guess.size();
  if (count == 0) return out;
  VectorXd now = residuals(out.unknowns);
  MatrixXd jacobian(now.size(), count);
  double damping = 1e-6;
  for (int i = 0; i < kMost; ++i) {
    for (Index j = 0; j < count; ++j) {
      VectorXd moved = out.unknowns;
      const double step = std::min(kApart, 0.01 * reach[j]);
      // Inward.
      const double apart = moved[j] + step > reach[j] ? -step : step;
      moved[j] += apart;
      if (apart == 0) jacobian.col(j).setZero();
      else jacobian.col(j) = (residuals(moved) - now) / apart;
      // What would leave its reach stays, and is known there.
      const double outward = -jacobian.col(j).dot(now) * out.unknowns[j];
      if (std::abs(out.unknowns[j]) >= reach[j] && outward > 0) jacobian.col(j).setZero();
    }
    const MatrixXd normal = jacobian.transpose() * jacobian;
    const VectorXd scale = normal.diagonal().cwiseSqrt().unaryExpr([](double d) { return d > 0 ? 1 / d : 0; });
    const MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const VectorXd right = scale.cwiseProduct(jacobian.transpose() * now);
    out.covariance = scale.asDiagonal() * LeastNorm(scaled, 1e-10).PseudoInverse() * scale.asDiagonal();
    double gain = 0;
    for (; damping < 1e6; damping *= 10) {
      MatrixXd damped = scaled;
      damped.diagonal().array() += damping;
      const VectorXd moved =
          (out.unknowns - scale.cwiseProduct(Solved(damped, right))).cwiseMin(reach).cwiseMax(-reach);
      const VectorXd there = residuals(moved);
      gain = 1 - there.squaredNorm() / now.squaredNorm();
      if (!(gain > 0)) continue;
      out.unknowns = moved;
      now = there;
      damping = std::max(1e-12, damping / 100);
      break;
    }
    if (!(gain > kLeastGain)) break;
  }
  const Index free = std::max<Index>(1, now.size() - count);
  out.covariance *= now.squaredNorm() / static_cast<double>(free);
  return out;
}

}  // namespace fourpost
