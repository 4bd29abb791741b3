// Every force passes one checker: action equals reaction, the power it takes is that of its law, none at rest.
#include "vehicles/body_forces.h"
#include "vehicles/line_forces.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>

namespace fourpost {
namespace {

using SimTK::Vec3;

/// Two free bodies in any pose and motion, and one force between them.
class ForceElements : public testing::Test {
 protected:
  ForceElements() : matter_(system_), forces_(system_) {
    const SimTK::Body::Rigid body(SimTK::MassProperties(2, Vec3(0.1, 0, 0), SimTK::Inertia(1)));
    parent_ = SimTK::MobilizedBody::Bushing(matter_.Ground(), SimTK::Transform(), body, SimTK::Transform());
    child_ = SimTK::MobilizedBody::Bushing(matter_.Ground(), SimTK::Transform(), body, SimTK::Transform());
  }

  BodyLine Line(bool guided) const {
    BodyLine line{.parent = parent_, .child = child_, .parent_station = {0.1, 0.2, 0.9}, .child_station = {0, -0.1, 0}};
    line.guided = guided;
    if (guided) line.axis = Vec3(0.6, 0, 0.8);
    line.design_length = 0.7;
    return line;
  }

  const SimTK::State& Moving() {
    state_ = system_.realizeTopology();
    for (int i = 0; i < state_.getNQ(); ++i) state_.updQ()[i] = 0.1 * std::sin(1.0 + i);
    for (int i = 0; i < state_.getNU(); ++i) state_.updU()[i] = std::cos(2.0 + i);
    for (int i = 0; i < state_.getNZ(); ++i) state_.updZ()[i] = 0.003;
    system_.realize(state_, SimTK::Stage::Dynamics);
    return state_;
  }

  /// Sum of forces, sum of moments about the ground's origin, and power on the bodies.
  struct Balance {
    Vec3 force{0};
    Vec3 moment{0};
    double power = 0;
  };

  Balance BalanceOf(const SimTK::Force::Custom::Implementation& force) {
    SimTK::Vector_<SimTK::SpatialVec> body_forces(matter_.getNumBodies(), SimTK::SpatialVec(Vec3(0), Vec3(0)));
    SimTK::Vector_<Vec3> particle_forces;
    SimTK::Vector mobility_forces(matter_.getNumMobilities(), 0.0);
    force.calcForce(state_, body_forces, particle_forces, mobility_forces);
    Balance balance;
    for (const SimTK::MobilizedBody& body : {parent_, child_}) {
      const SimTK::SpatialVec& f = body_forces[body.getMobilizedBodyIndex()];
      balance.force += f[1];
      balance.moment += f[0] + body.getBodyOriginLocation(state_) % f[1];
      balance.power +=
          SimTK::dot(f[0], body.getBodyAngularVelocity(state_)) + SimTK::dot(f[1], body.getBodyOriginVelocity(state_));
    }
    return balance;
  }

  /// The extension's rate from differences of its value: independent of the element's own velocities.
  double DifferencedRate(const BodyLine& line) {
    constexpr double kStep = 1e-6;
    const auto extension_at = [&](double t) {
      SimTK::State moved = state_;
      // Bushing: dq/dt = u.
      for (int i = 0; i < moved.getNQ(); ++i) moved.updQ()[i] += t * moved.getU()[i];
      system_.realize(moved, SimTK::Stage::Position);
      return Extension(line, moved);
    };
    return (extension_at(kStep) - extension_at(-kStep)) / (2 * kStep);
  }

  void ExpectInternal(const Balance& balance, double tension, const BodyLine& line) {
    const double rounding = 1e-12 * std::abs(tension);
    EXPECT_LT(balance.force.norm(), rounding);
    EXPECT_LT(balance.moment.norm(), rounding);
    // Truncation and rounding of the difference: 1e-12 and 1e-16 / 1e-6.
    EXPECT_NEAR(balance.power, -tension * DifferencedRate(line), 1e-8 * std::abs(tension));
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::MobilizedBody parent_;
  SimTK::MobilizedBody child_;
  SimTK::State state_;
};

TEST_F(ForceElements, SpringIsInternalAndItsPowerIsThatOfItsLaw) {
  for (const bool guided : {false, true}) {
    const SpringData data{.line = Line(guided), .law = {.stiffness = 30e3, .knees = {}}, .preload = -500};
    Moving();
    const double tension = data.preload + data.law.Force(Extension(data.line, state_));
    ASSERT_GT(std::abs(tension), 100);
    ExpectInternal(BalanceOf(SpringForce(data)), tension, data.line);
  }
}

TEST_F(ForceElements, DashpotIsInternalAndItsPowerIsThatOfItsLaw) {
  for (const bool guided : {false, true}) {
    const DamperData data{.line = Line(guided), .dashpot = {800, 2600}, .series = {}};
    Moving();
    const double rate = DifferencedRate(data.line);
    ASSERT_GT(std::abs(rate), 0.01);
    ExpectInternal(BalanceOf(DamperForce(data, forces_)), data.dashpot.Force(rate), data.line);
    EXPECT_LT(BalanceOf(DamperForce(data, forces_)).power, 0) << "a dashpot only takes power";
  }
}

TEST_F(ForceElements, DashpotsRatesAreThoseOfReboundAndBump) {
  const DashpotLaw dashpot{800, 2600};
  EXPECT_EQ(dashpot.Force(0.5), 1300);
  EXPECT_EQ(dashpot.Force(-0.5), -400);
  EXPECT_EQ(dashpot.Force(0), 0);
  EXPECT_EQ(dashpot.Velocity(1300), 0.5);
  EXPECT_EQ(dashpot.Velocity(-400), -0.5);
}

TEST_F(ForceElements, SeriesDamperIsInternalAndItsSpringCarriesTheDashpotsForce) {
  DamperData data{
      .line = Line(false), .dashpot = {800, 2600}, .in_series = true, .series = {.stiffness = 400e3, .knees = {}}};
  // The system owns the element: its state belongs to the system's.
  auto* force = new DamperForce(data, forces_);
  const SimTK::Force::Custom owner(forces_, force);
  Moving();
  const double tension = 400e3 * state_.getZ()[0];
  ASSERT_GT(tension, 0);
  ExpectInternal(BalanceOf(*force), tension, data.line);
  system_.realize(state_, SimTK::Stage::Acceleration);
  const double dashpot_rate = DifferencedRate(data.line) - state_.getZDot()[0];
  EXPECT_NEAR(data.dashpot.Force(dashpot_rate), tension, 1e-6 * tension);  // the differenced rate, as above
}

TEST_F(ForceElements, TyrePushesUpWithStiffnessAndDamping) {
  TyreData data{.body = child_, .station = {0.2, 0, -0.3}, .design_place = {0, 0, 0.1}};
  data.stiffness = 200e3;
  data.damping = 300;
  data.preload = 5000;
  data.post = 0;
  Platforms platforms{{.height = 0.01, .velocity = 0.2}};
  const std::function<const Platforms&(double)> platforms_at = [&](double) -> const Platforms& { return platforms; };
  Moving();
  const double height = child_.findStationLocationInGround(state_, data.station)[2];
  const double velocity = child_.findStationVelocityInGround(state_, data.station)[2];
  const double push = 5000 + 200e3 * (0.01 - (height - 0.1)) + 300 * (0.2 - velocity);
  const Balance balance = BalanceOf(TyreForce(data, platforms_at));
  EXPECT_LT((balance.force - Vec3(0, 0, push)).norm(), 1e-11 * std::abs(push));  // rounding
  EXPECT_NEAR(balance.power, push * velocity, 1e-11 * std::abs(push * velocity));
}

TEST_F(ForceElements, NothingActsAtRestWithoutPreload) {
  SpringData spring{.line = Line(false), .law = {.stiffness = 30e3, .knees = {}}};
  DamperData damper{.line = Line(false), .dashpot = {800, 2600}, .series = {}};
  Moving();
  state_.updU() = 0;
  system_.realize(state_, SimTK::Stage::Dynamics);
  spring.line.design_length = Length(spring.line, state_);
  SimTK::Vector_<SimTK::SpatialVec> none(matter_.getNumBodies(), SimTK::SpatialVec(Vec3(0), Vec3(0)));
  SimTK::Vector_<SimTK::SpatialVec> forces = none;
  SimTK::Vector_<Vec3> particles;
  SimTK::Vector mobility;
  SpringForce(spring).calcForce(state_, forces, particles, mobility);
  DamperForce(damper, forces_).calcForce(state_, forces, particles, mobility);
  for (int i = 0; i < forces.size(); ++i) EXPECT_EQ(forces[i], none[i]);
}

}  // namespace
}  // namespace fourpost
