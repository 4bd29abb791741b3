#include "vehicles/poses/suspension_rig.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/loops/design_kinematics.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr Index kChassisRows = 6;

/// Whose feet the pads carry without yielding.
Vehicle WithoutTyreRates(Vehicle vehicle) {
  for (Tyre& tyre : vehicle.tyres) {
    tyre.law = {};
    tyre.damping = tyre.lateral = tyre.longitudinal = Scalar{};
    tyre.lateral_damping = tyre.longitudinal_damping = Scalar{};
    tyre.preload = Scalar{};
    tyre.lifts_off = false;
  }
  return vehicle;
}

/// Whether a path that starts and ends along these tangents goes by `change`. Where a law has a kink, the path goes a
/// part of the way along each; where the solution has jumped past a dead centre, neither explains it, however short the
/// step.
bool LeadsTo(const Eigen::VectorXd& change, const Eigen::VectorXd& at_start, const Eigen::VectorXd& at_end) {
  // A path bends by this share of a step; one that bends more is about to turn back.
  constexpr double kBend = 0.25;
  constexpr double kNothing = 1e-9;
  const Eigen::VectorXd turn = at_end - at_start;
  const double length = turn.squaredNorm();
  const double part = length > 0 ? std::clamp((change - at_start).dot(turn) / length, 0.0, 1.0) : 0;
  const double off = (change - at_start - part * turn).lpNorm<Eigen::Infinity>();
  return off <= kBend * at_start.lpNorm<Eigen::Infinity>() + kNothing;
}

Preloads WithoutTyres(Preloads preloads) {
  std::fill(preloads.tyre.begin(), preloads.tyre.end(), 0);
  return preloads;
}

}  // namespace

SuspensionRig::SuspensionRig(const Vehicle& vehicle, std::span<const double> parameters)
    : SuspensionRig(vehicle, parameters, CondensedVehicle(vehicle).PreloadsAt(parameters)) {}

SuspensionRig::SuspensionRig(const Vehicle& vehicle, std::span<const double> parameters, Preloads preloads)
    : vehicle_(vehicle),
      multibody_(WithoutTyreRates(vehicle)),
      solver_(multibody_),
      suspension_(SuspensionOf(vehicle, DesignKinematics(vehicle), parameters)) {
  multibody_.SetParameters(parameters, WithoutTyres(std::move(preloads)));
  multibody_.SetPose(multibody_.design_pose());
  if (suspension_.chassis >= 0) {
    chassis_ = suspension_.bodies[static_cast<std::size_t>(suspension_.chassis)].links.front();
    chassis_pose_ = multibody_.LinkPose(chassis_);
  }
  heights_.resize(wheels());
  for (Index i = 0; i < wheels(); ++i) {
    const Tyre& tyre = vehicle_.tyres[static_cast<std::size_t>(i)];
    heights_[i] = (multibody_.LinkPose(tyre.point.link) * tyre.point.xyz).z();
    if (const Joint* const spin = SpinOf(vehicle_, tyre)) spins_.push_back({spin->child, spin->parent});
  }
}

RestSolver::Guides SuspensionRig::GuidesAt(const Kinematics& pose, const Eigen::VectorXd& rise) const {
  const Index chassis_rows = chassis_ >= 0 ? kChassisRows : 0;
  const Index n = multibody_.coordinate_count();
  const Index rows = wheels() + chassis_rows + static_cast<Index>(spins_.size());
  RestSolver::Guides guides{Eigen::VectorXd::Zero(rows), Eigen::MatrixXd::Zero(rows, n),
                            Eigen::MatrixXd::Zero(rows, n)};
  Index row = 0;
  if (chassis_ >= 0) {
    const Point origin{chassis_, Eigen::Vector3d::Zero()};
    const Eigen::AngleAxisd turn(pose.Rotation(chassis_) * chassis_pose_.linear().transpose());
    guides.error.segment<3>(row) = pose.Location(origin) - chassis_pose_.translation();
    guides.error.segment<3>(row + 3) = turn.angle() * turn.axis();
    guides.jacobian.middleRows<3>(row) = pose.PointJacobian(origin);
    guides.jacobian.middleRows<3>(row + 3) = pose.AngularJacobian(chassis_);
    row += kChassisRows;
  }
  // How far they have spun does not matter.
  for (const Spin& spin : spins_)
    guides.jacobian.row(row++) = pose.Rotation(spin.link).col(1).transpose() *
                                 (pose.AngularJacobian(spin.link) - pose.AngularJacobian(spin.parent));
  guides.directions.topRows(row) = guides.jacobian.topRows(row);
  for (Index i = 0; i < wheels(); ++i, ++row) {
    const Tyre& tyre = vehicle_.tyres[static_cast<std::size_t>(i)];
    const Coordinate height = pose.Position(tyre.point, Eigen::Vector3d::UnitZ());
    guides.error[row] = height.value - heights_[i] - rise[i];
    guides.jacobian.row(row) = height.gradient.transpose();
    guides.directions.row(row) = pose.FootPosition(tyre, Eigen::Vector3d::UnitZ()).gradient.transpose();
  }
  return guides;
}

RestSolver::Guide SuspensionRig::GuideTo(const Eigen::VectorXd& rise) const {
  return [this, rise](const Kinematics& pose) { return GuidesAt(pose, rise); };
}

SuspensionRig::Pose SuspensionRig::Design() {
  const Eigen::VectorXd rise = Eigen::VectorXd::Zero(wheels());
  const RestSolver::Rest start{multibody_.design_pose(), {}};
  const std::optional<RestSolver::Rest> rest = solver_.Solve(start, GuideTo(rise));
  return {rest ? *rest : start, rise};
}

Eigen::VectorXd SuspensionRig::PadForces(const Pose& pose) const { return pose.rest.forces.tail(wheels()); }

bool SuspensionRig::IsRigid(const Pose& pose) { return solver_.FreeMotions(pose.rest, GuideTo(pose.rise)) == 0; }

Kinematics SuspensionRig::At(const Pose& pose) {
  multibody_.SetPose(pose.rest.q);
  return Kinematics(multibody_);
}

std::optional<Eigen::VectorXd> SuspensionRig::Tangent(const Pose& pose, const Eigen::VectorXd& rise) {
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(pose.rest.forces.size(), 1);
  motions.bottomRows(wheels()) = rise;
  const std::optional<Eigen::MatrixXd> motion =
      solver_.Respond(pose.rest, GuideTo(pose.rise), Eigen::MatrixXd::Zero(pose.rest.q.size(), 1), motions);
  if (!motion) return std::nullopt;
  return Eigen::VectorXd(motion->col(0));
}

std::optional<SuspensionRig::Pose> SuspensionRig::Follow(const Pose& from, double step, const Eigen::VectorXd& way,
                                                         const Eigen::VectorXd& rise, Eigen::VectorXd& tangent) {
  const std::optional<RestSolver::Rest> rest =
      solver_.Solve({from.rest.q + step * tangent, from.rest.forces}, GuideTo(rise));
  if (!rest) return std::nullopt;
  Pose pose{*rest, rise};
  const std::optional<Eigen::VectorXd> there = Tangent(pose, way);
  if (!there || !LeadsTo(rest->q - from.rest.q, step * tangent, step * *there)) return std::nullopt;
  tangent = *there;
  return pose;
}

SuspensionRig::Pose SuspensionRig::Move(const Pose& from, const Eigen::VectorXd& rise) {
  constexpr double kShortest_m = 1e-5;
  Pose pose = from;
  const Eigen::VectorXd way = rise - from.rise;
  std::optional<Eigen::VectorXd> tangent = Tangent(pose, way);
  double step = 1;
  for (double done = 0; done < 1 && tangent;) {
    step = std::min(step, 1 - done);
    const Eigen::VectorXd next = done + step >= 1 ? rise : Eigen::VectorXd(from.rise + (done + step) * way);
    if (std::optional<Pose> followed = Follow(pose, step, way, next, *tangent)) {
      pose = *std::move(followed);
      done += step;
      step *= 2;
    } else {
      step /= 2;
      if (step * way.lpNorm<Eigen::Infinity>() < kShortest_m) return pose;
    }
  }
  return pose;
}

std::optional<Eigen::VectorXd> SuspensionRig::Yield(const Pose& pose, WheelLoad load, const Eigen::VectorXd& factors) {
  const Kinematics place = At(pose);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(pose.rest.q.size(), 1);
  for (Index i = 0; i < wheels(); ++i) {
    const Tyre& tyre = vehicle_.tyres[static_cast<std::size_t>(i)];
    const int link = tyre.point.link;
    const auto foot = [&](const Eigen::Vector3d& direction) { return place.FootPosition(tyre, direction).value; };
    // The material point of the link at the foot.
    const Eigen::Vector3d ground(foot(Eigen::Vector3d::UnitX()), foot(Eigen::Vector3d::UnitY()),
                                 foot(Eigen::Vector3d::UnitZ()));
    const Point patch{link,
                      place.Rotation(link).transpose() * (ground - place.Location({link, Eigen::Vector3d::Zero()}))};
    Eigen::VectorXd direction;
    switch (load) {
      case WheelLoad::kLateral: direction = place.PointJacobian(patch).row(1); break;
      case WheelLoad::kBraking: direction = -place.PointJacobian(patch).row(0); break;
      case WheelLoad::kDriving: direction = place.PointJacobian(tyre.point).row(0); break;
      case WheelLoad::kAligning: direction = place.AngularJacobian(link).row(2); break;
    }
    forces.col(0) += factors[i] * direction;
  }
  const std::optional<Eigen::MatrixXd> motion =
      solver_.Respond(pose.rest, GuideTo(pose.rise), forces, Eigen::MatrixXd::Zero(pose.rest.forces.size(), 1));
  if (!motion) return std::nullopt;
  return Eigen::VectorXd(motion->col(0));
}

}  // namespace fourpost
