#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <random>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/resting.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Coordinates, their rates and the heights of the posts, which stand still.
struct MotionState {
  Eigen::VectorXd q;
  Eigen::VectorXd rate;
  Eigen::VectorXd ground;
};

inline MotionState operator*(double scale, const MotionState& motion) {
  return {scale * motion.q, scale * motion.rate, scale * motion.ground};
}

/// The equations of a vehicle as written out by hand, which know nothing of its file.
struct ClosedForm {
  CondensedModel model;
  std::function<Eigen::VectorXd(const MotionState&)> acceleration;
  /// The vehicle's joint coordinates = to_joints times those of the closed form.
  Eigen::MatrixXd to_joints;
};

/// Joint coordinates from those named, in this order; each joint has one.
inline Eigen::MatrixXd JointOrder(const Vehicle& vehicle, std::initializer_list<const char*> joints) {
  const auto n = static_cast<Eigen::Index>(vehicle.joints.size());
  EXPECT_EQ(joints.size(), vehicle.joints.size());
  Eigen::MatrixXd order = Eigen::MatrixXd::Zero(n, n);
  Eigen::Index column = 0;
  for (const char* name : joints) {
    const auto found = std::find_if(vehicle.joints.begin(), vehicle.joints.end(),
                                    [&](const Joint& joint) { return joint.name == name; });
    if (found == vehicle.joints.end()) ADD_FAILURE() << "no joint " << name;
    else order(found - vehicle.joints.begin(), column) = 1;
    ++column;
  }
  return order;
}

/// What the tests of closed forms draw, the same in every run.
class Draw {
 public:
  double Between(double lower, double upper) { return std::uniform_real_distribution<>(lower, upper)(engine_); }

  /// The vehicle with all parameters somewhere within their bounds.
  Vehicle Parameters(Vehicle vehicle) {
    for (Parameter& parameter : vehicle.parameters) parameter.value = Between(parameter.lower, parameter.upper);
    return vehicle;
  }

  /// 10 to 20 mm or 0.01 to 0.02 rad either way, and up to 0.3 m/s or rad/s.
  MotionState SmallMotion(Eigen::Index coordinates, Eigen::Index posts) {
    MotionState motion{Eigen::VectorXd(coordinates), Eigen::VectorXd(coordinates), Eigen::VectorXd(posts)};
    for (double& value : motion.q) value = Either(Between(0.01, 0.02));
    for (double& value : motion.rate) value = Between(-0.3, 0.3);
    for (double& value : motion.ground) value = Either(Between(0.01, 0.02));
    return motion;
  }

 private:
  double Either(double value) { return Between(-1, 1) < 0 ? -value : value; }

  std::mt19937_64 engine_{1};
};

/// Largest deviation as a share of the largest entry.
inline double DeviationBetween(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected) {
  return (actual - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// The condensed vehicle has the matrices, dampers and posts of the closed form.
inline void ExpectSameMatrices(const Vehicle& vehicle, const ClosedForm& closed) {
  // Sums of a few products of doubles.
  constexpr double kRounding = 1e-14;
  // Preloads of some 10 kN times second derivatives of lengths, which vanish here but for what their differences leave:
  // 1e-10 / m, over stiffnesses of some 1 MN/m.
  constexpr double kCurvature = 1e-11;
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Eigen::MatrixXd& p = closed.to_joints;
  ASSERT_EQ(model.mass.rows(), p.rows());
  EXPECT_LT(DeviationBetween(p.transpose() * model.mass * p, closed.model.mass), kRounding);
  EXPECT_LT(DeviationBetween(p.transpose() * model.stiffness * p, closed.model.stiffness), kCurvature);
  EXPECT_EQ(model.damping.norm(), 0);
  EXPECT_LT(DeviationBetween(p.transpose() * model.post_stiffness, closed.model.post_stiffness), kRounding);
  ASSERT_EQ(model.dashpots.size(), closed.model.dashpots.size());
  for (std::size_t i = 0; i < model.dashpots.size(); ++i) {
    EXPECT_LT(DeviationBetween(p.transpose() * model.dashpots[i].direction, closed.model.dashpots[i].direction),
              kRounding);
    for (const double v : {-1.0, 1.0}) EXPECT_EQ(model.dashpots[i].law.Force(v), closed.model.dashpots[i].law.Force(v));
    EXPECT_EQ(model.dashpots[i].series.stiffness, 0);
  }
}

/// Each sensor of the vehicle has this row in the coordinates that `order` takes to its joints'.
inline void ExpectSensorRows(const Vehicle& vehicle, const Eigen::MatrixXd& order,
                             const std::map<std::string, Eigen::RowVectorXd>& rows) {
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  // A load cell with its pan has the row of the one without: on positions the pan has no part.
  const auto has_pan = [](const Sensor& sensor) { return sensor.name.starts_with("F_pan"); };
  const auto pans = std::count_if(vehicle.sensors.begin(), vehicle.sensors.end(), has_pan);
  ASSERT_EQ(rows.size() + static_cast<std::size_t>(pans), vehicle.sensors.size());
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i) {
    const Sensor& sensor = vehicle.sensors[i];
    if (has_pan(sensor)) continue;
    const bool accelerates = sensor.type == Sensor::Type::kAccelerometer;
    const Eigen::MatrixXd& on = accelerates ? model.on_acceleration : model.on_position;
    // Rounding of the positions.
    EXPECT_LT(DeviationBetween(on.row(static_cast<Eigen::Index>(i)) * order, rows.at(sensor.name)), 1e-14)
        << sensor.name;
  }
}

/// Difference of Simbody's acceleration from the closed form's, over the latter.
inline double AccelerationError(Multibody& multibody, const ClosedForm& closed, const MotionState& motion) {
  multibody.SetPostMotion([&](double, std::span<PostState> posts) {
    for (std::size_t p = 0; p < posts.size(); ++p) posts[p] = {.height = motion.ground[static_cast<Eigen::Index>(p)]};
  });
  Eigen::VectorXd state = multibody.RestState();
  const Eigen::Index n = motion.q.size();
  state.head(n) += closed.to_joints * motion.q;
  state.segment(n, n) = closed.to_joints * motion.rate;
  const Eigen::VectorXd acceleration = multibody.StateDerivative(0, state).segment(n, n);
  const Eigen::VectorXd expected = closed.to_joints * closed.acceleration(motion);
  return (acceleration - expected).norm() / expected.norm();
}

/// The closed form is exact here.
inline void ExpectSameAcceleration(Multibody& multibody, const ClosedForm& closed, const MotionState& motion) {
  // Rounding of forces of some 10 kN on the smallest mass or inertia, 25 kg or kg m^2, beside some 10 m/s^2.
  EXPECT_LT(AccelerationError(multibody, closed, motion), 1e-13);
}

/// The closed form is exact to first and second order: what it leaves out is cubic, hence a quarter of the error
/// remains at half the motion, but for terms of higher order.
inline void ExpectSameAccelerationForSmallMotion(Multibody& multibody, const ClosedForm& closed,
                                                 const MotionState& motion) {
  const double error = AccelerationError(multibody, closed, motion);
  const double at_half = AccelerationError(multibody, closed, 0.5 * motion);
  EXPECT_GT(error, 1e-8);  // else rounding is what is compared
  EXPECT_NEAR(at_half / error, 0.25, 0.025);
}

}  // namespace fourpost
