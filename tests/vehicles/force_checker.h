#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vehicles/multibody/simbody.h"

namespace fourpost {

/// Three free bodies in drawn poses and motions, and one force on them, whose balances are checked.
class ForceChecker {
 public:
  static constexpr int kBodies = 3;

  ForceChecker() : matter_(system_), forces_(system_) {
    const SimTK::Body::Rigid body(SimTK::MassProperties(2, SimTK::Vec3(0.1, 0, 0), SimTK::Inertia(1)));
    for (int i = 0; i < kBodies; ++i)
      bodies_.push_back(SimTK::MobilizedBody::Bushing(matter_.Ground(), SimTK::Transform(), body, SimTK::Transform()));
  }

  const SimTK::MobilizedBody& ground() const { return matter_.getGround(); }
  const SimTK::MobilizedBody& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  const SimTK::GeneralForceSubsystem& forces() const { return forces_; }
  const SimTK::State& state() const { return state_; }

  /// Takes the force; call once, before a pose.
  void Add(SimTK::Force::Custom::Implementation* force) { force_ = SimTK::Force::Custom(forces_, force); }

  /// All bodies at rest in the ground's axes, all states of the force zero.
  void Rest() {
    state_ = system_.realizeTopology();
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  /// Any pose within 0.3 m and 0.3 rad of that and any motion within 1 m/s and 1 rad/s; the force's own states up to
  /// `z`.
  void Draw(double z = 0, double travel = 0.3, double speed = 1) {
    state_ = system_.realizeTopology();
    for (int i = 0; i < state_.getNQ(); ++i) state_.updQ()[i] = travel * Between();
    for (int i = 0; i < state_.getNU(); ++i) state_.updU()[i] = speed * Between();
    for (int i = 0; i < state_.getNZ(); ++i) state_.updZ()[i] = z * Between();
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  void Place(const SimTK::State& state) {
    state_ = state;
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  /// Between -1 and 1.
  double Between() { return std::uniform_real_distribution<>(-1, 1)(engine_); }

  struct Balance {
    SimTK::Vec3 force{0};
    /// About the ground's origin.
    SimTK::Vec3 moment{0};
    double power = 0;
    /// Largest force or moment on a body: what balances are exact to the rounding of.
    double size = 0;
  };

  /// Over all bodies; `with_ground`: the ground as well.
  Balance Sum(bool with_ground = true) const {
    SimTK::Vector_<SimTK::SpatialVec> body_forces;
    SimTK::Vector_<SimTK::Vec3> particle_forces;
    SimTK::Vector mobility_forces;
    force_.calcForceContribution(state_, body_forces, particle_forces, mobility_forces);
    EXPECT_EQ(mobility_forces.norm(), 0);
    Balance balance;
    std::vector<SimTK::MobilizedBody> all = bodies_;
    if (with_ground) all.emplace_back(matter_.getGround());
    for (const SimTK::MobilizedBody& body : all) {
      const SimTK::SpatialVec& f = body_forces[body.getMobilizedBodyIndex()];
      balance.force += f[1];
      balance.moment += f[0] + body.getBodyOriginLocation(state_) % f[1];
      balance.power +=
          SimTK::dot(f[0], body.getBodyAngularVelocity(state_)) + SimTK::dot(f[1], body.getBodyOriginVelocity(state_));
      balance.size = std::max({balance.size, f[0].norm(), f[1].norm()});
    }
    return balance;
  }

  double Energy() const { return Energy(state_); }
  double Energy(const SimTK::State& state) const { return force_.calcPotentialEnergyContribution(state); }

  /// Rate of a number of the state along the present motion, by differences, independent of velocities that the element
  /// computes; pose, the force's own states and time go along.
  double Rate(const std::function<double(const SimTK::State&)>& number) const {
    constexpr double kStep = 1e-4;
    const auto at = [&](double h) {
      SimTK::State moved = state_;
      moved.updTime() += h;
      // Bushing: dq/dt = u.
      moved.updQ() += h * state_.getU();
      moved.updZ() += h * state_.getZDot();
      system_.realize(moved, SimTK::Stage::Velocity);
      return number(moved);
    };
    // Of fourth order: truncation 1e-16 of fifth derivatives, rounding 1e-16 / 1e-4.
    return (8 * (at(kStep) - at(-kStep)) - (at(2 * kStep) - at(-2 * kStep))) / (12 * kStep);
  }

  /// Action and reaction: no force, no moment. Power: what the element gives is what its energy loses, less what it
  /// dissipates. `scale`: of powers that cancel, as rounding sees them.
  void ExpectBalance(double dissipation, double scale = 0) const {
    const Balance balance = Sum();
    // Forces at arms of some metres.
    const double rounding = 1e-14 * balance.size;
    EXPECT_LE(balance.force.norm(), rounding);
    EXPECT_LE(balance.moment.norm(), 10 * rounding);
    const double energy_rate = Rate([this](const SimTK::State& s) { return Energy(s); });
    // Of Rate: 1e-12 / s of the energy and of what its terms are.
    const double differences =
        1e-9 * (std::abs(balance.power) + std::abs(dissipation) + scale) + 1e-11 * std::abs(Energy());
    EXPECT_NEAR(balance.power, -energy_rate - dissipation, differences);
    EXPECT_GE(dissipation, 0);
  }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<SimTK::MobilizedBody> bodies_;
  SimTK::Force force_;
  SimTK::State state_;
  std::mt19937_64 engine_{1};
};

}  // namespace fourpost
