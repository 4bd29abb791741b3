#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "vehicles/closed_form/half_car.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// Classical Runge-Kutta of order 4 with fixed steps: y at t = 0, step, ... of y' = f(t, y) from `y`.
template <typename State>
std::vector<State> RungeKutta4(const std::function<State(double, const State&)>& f, State y, double step, int count) {
  std::vector<State> out = {y};
  for (int k = 1; k < count; ++k) {
    const double t = step * (k - 1);
    const State a = f(t, y);
    const State b = f(t + step / 2, y + step / 2 * a);
    const State c = f(t + step / 2, y + step / 2 * b);
    const State d = f(t + step, y + step * c);
    y += step / 6 * (a + 2 * b + 2 * c + d);
    out.push_back(y);
  }
  return out;
}

/// A Land Rover's half as the thesis's Model 1, with dampers of two rates.
inline HalfCar ThesisHalfCar() {
  return {.sprung_mass = 1725,
          .pitch_inertia = 2600,
          .front_mass = 220,
          .rear_mass = 240,
          .front_stiffness = 80e3,
          .rear_stiffness = 120e3,
          .front_tyre_stiffness = 600e3,
          .rear_tyre_stiffness = 640e3,
          .front_damper = {3000, 7000},
          .rear_damper = {4000, 9000},
          .front_length = 1.456,
          .rear_length = 1.338};
}

/// Posts of a half car that move apart: 8 mm at 1.3 Hz in front, 5 mm at 2.1 Hz behind, growing from rest.
inline void HalfCarPosts(double t, std::span<PostState> posts) {
  const auto sine = [t](double amplitude, double hertz) {
    const double w = 2 * std::numbers::pi * hertz;
    // z = a (sin w t - w t exp(-w t)) starts with height, velocity zero.
    const double decay = std::exp(-w * t);
    return PostState{amplitude * (std::sin(w * t) - w * t * decay),
                     amplitude * w * (std::cos(w * t) - (1 - w * t) * decay),
                     amplitude * w * w * (-std::sin(w * t) + (2 - w * t) * decay)};
  };
  posts[0] = sine(0.008, 1.3);
  posts[1] = sine(0.005, 2.1);
}

/// Sensors of a model that read its coordinates and, behind them, their accelerations.
inline RigView ReadAll(CondensedModel& model) {
  const Eigen::Index n = model.mass.rows();
  const Eigen::Index posts = model.post_stiffness.cols();
  model.on_position.setZero(2 * n, n);
  model.on_position.topRows(n).setIdentity();
  model.on_velocity.setZero(2 * n, n);
  model.on_acceleration.setZero(2 * n, n);
  model.on_acceleration.bottomRows(n).setIdentity();
  model.on_post_height.setZero(2 * n, posts);
  model.on_post_velocity.setZero(2 * n, posts);
  model.on_post_acceleration.setZero(2 * n, posts);
  RigView rig{.post_count = static_cast<std::size_t>(posts)};
  for (const auto type : {Sensor::Type::kDisplacement, Sensor::Type::kAccelerometer})
    for (Eigen::Index i = 0; i < n; ++i)
      rig.sensors.push_back(
          {.name = (type == Sensor::Type::kDisplacement ? "q" : "a") + std::to_string(i), .type = type});
  return rig;
}

}  // namespace fourpost
