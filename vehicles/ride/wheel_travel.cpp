#include "vehicles/ride/wheel_travel.h"

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

constexpr Eigen::Index kChassisRows = 6;
/// Singular values below this share of the largest count as zero; exact redundancy leaves about 1e-16, a joint's lever
/// of a millimetre against metres 1e-3.
constexpr double kRankTolerance = 1e-9;

Eigen::MatrixXd Constraints(const Suspension& suspension, Eigen::Index coordinates) {
  const auto wheels = static_cast<Eigen::Index>(suspension.wheels.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(kChassisRows + wheels, coordinates);
  if (suspension.chassis >= 0) {
    const BodyMotion& chassis = suspension.bodies[static_cast<std::size_t>(suspension.chassis)];
    rows.topRows<kChassisRows>() << chassis.com_jacobian, chassis.spin_jacobian;
  }
  for (Eigen::Index i = 0; i < wheels; ++i)
    rows.row(kChassisRows + i) = suspension.wheels[static_cast<std::size_t>(i)].foot_rise.transpose();
  return rows;
}

Eigen::MatrixXd NullSpace(const Eigen::MatrixXd& rows) {
  const SingularValues parts = SingularValuesOf(rows, SingularValues::kRight);
  const double largest = parts.values.size() > 0 ? parts.values[0] : 0;
  const Eigen::Index rank = largest > 0 ? (parts.values.array() >= kRankTolerance * largest).count() : 0;
  return parts.right.rightCols(rows.cols() - rank);
}

}  // namespace

HeldChassis::HeldChassis(const Suspension& suspension, Eigen::MatrixXd stiffness)
    : stiffness_(std::move(stiffness)),
      constraints_(Constraints(suspension, stiffness_.rows())),
      free_(NullSpace(constraints_)),
      leading_(constraints_, kRankTolerance),
      yielding_(free_.transpose() * stiffness_ * free_, kRankTolerance),
      holding_(constraints_.transpose(), kRankTolerance) {
  for (const Wheel& wheel : suspension.wheels) wheel_y_.push_back(wheel.foot.y());
}

std::optional<WheelTravel> HeldChassis::Move(const Eigen::VectorXd& rise) const {
  Eigen::VectorXd wanted(constraints_.rows());
  wanted << Eigen::VectorXd::Zero(kChassisRows), rise;
  const Eigen::VectorXd led = leading_.Solve(wanted);
  // Rounding of some ten coordinates is far below, a wheel that cannot move misses by a share of its rise.
  constexpr double kMissed = 1e-6;
  if ((constraints_ * led - wanted).norm() > kMissed * rise.norm()) return std::nullopt;
  WheelTravel travel{.rise = rise, .motion = led, .force = {}};
  travel.motion -= free_ * yielding_.Solve(Eigen::VectorXd(free_.transpose() * (stiffness_ * led)));
  travel.force = holding_.Solve(Eigen::VectorXd(stiffness_ * travel.motion)).tail(rise.size());
  return travel;
}

std::optional<WheelTravel> HeldChassis::MoveOne(std::size_t wheel) const {
  const auto count = static_cast<Eigen::Index>(wheel_y_.size());
  return Move(Eigen::VectorXd::Unit(count, static_cast<Eigen::Index>(wheel)));
}

std::optional<WheelTravel> HeldChassis::MoveTogether(const Axle& axle) const {
  Eigen::VectorXd rise = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(wheel_y_.size()));
  for (const std::size_t i : axle.wheels) rise[static_cast<Eigen::Index>(i)] = 1;
  return Move(rise);
}

std::optional<WheelTravel> HeldChassis::MoveAll() const {
  return Move(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(wheel_y_.size())));
}

std::optional<WheelTravel> HeldChassis::Roll(const Axle& axle) const {
  double middle = 0;
  for (const std::size_t i : axle.wheels) middle += wheel_y_[i] / static_cast<double>(axle.wheels.size());
  Eigen::VectorXd rise = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(wheel_y_.size()));
  for (const std::size_t i : axle.wheels) rise[static_cast<Eigen::Index>(i)] = wheel_y_[i] - middle;
  return Move(rise);
}

Eigen::MatrixXd StiffnessWithoutTyres(const Vehicle& vehicle, const Kinematics& pose,
                                      std::span<const double> parameters, const CondensedModel& model) {
  Eigen::MatrixXd rest = model.stiffness;
  for (std::size_t t = 0; t < vehicle.tyres.size(); ++t) {
    const Tyre& tyre = vehicle.tyres[t];
    const double rates[] = {tyre.longitudinal.At(parameters), tyre.lateral.At(parameters),
                            tyre.law.RateAt(parameters, model.preloads.tyre[t])};
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::VectorXd direction = pose.FootPosition(tyre, Eigen::Vector3d::Unit(i)).gradient;
      rest -= rates[i] * direction * direction.transpose();
    }
  }
  return rest;
}

}  // namespace fourpost
