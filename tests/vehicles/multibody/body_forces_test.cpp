#include "vehicles/multibody/body_forces.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "tests/vehicles/force_checker.h"
#include "vehicles/multibody/simbody_bodies.h"
#include "vehicles/multibody/tyre_foot.h"

namespace fourpost::body_forces_test {
namespace {

using Eigen::Vector3d;
using SimTK::State;
using SimTK::Vec3;

constexpr int kDraws = 20;

BushingData Bushing(const ForceChecker& checker) {
  BushingData data{
      .parent = checker.body(0),
      .child = checker.body(1),
      .parent_station = {0.1, 0.2, 0.3},
      .child_station = {-0.1, 0, 0.2},
      .parent_axes =
          (Eigen::AngleAxisd(0.5, Vector3d::UnitX()) * Eigen::AngleAxisd(0.3, Vector3d::UnitZ())).toRotationMatrix(),
      .child_axes = {},
      .design_place = {}};
  data.stiffness = {30e3, 20e3, 40e3, 200, 300, 400};
  data.damping = {300, 200, 400, 2, 3, 4};
  data.preload = {-100, 50, 700};
  return data;
}

Eigen::Matrix3d RotationOf(const SimTK::MobilizedBody& body, const State& state) {
  return ToEigen(body.getBodyTransform(state)).linear();
}

/// Displacement and turn as the header tells them, written out once more.
Eigen::Matrix<double, 6, 1> Displacement(const BushingData& data, const State& state) {
  const Eigen::Matrix3d axes = RotationOf(data.parent, state) * data.parent_axes;
  const Vec3 span = data.child.findStationLocationInGround(state, data.child_station) -
                    data.parent.findStationLocationInGround(state, data.parent_station);
  const Eigen::AngleAxisd turn(axes.transpose() * RotationOf(data.child, state) * data.child_axes);
  Eigen::Matrix<double, 6, 1> displacement;
  displacement << axes.transpose() * ToEigen(span) - data.design_place, 2 * std::sin(turn.angle() / 2) * turn.axis();
  return displacement;
}

Eigen::Matrix<double, 6, 1> DisplacementRate(const BushingData& data, const ForceChecker& checker) {
  Eigen::Matrix<double, 6, 1> rate;
  for (Eigen::Index i = 0; i < 6; ++i)
    rate[i] = checker.Rate([&](const State& state) { return Displacement(data, state)[i]; });
  return rate;
}

double Dissipation(const BushingData& data, const ForceChecker& checker) {
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> damping(data.damping.data());
  return damping.dot(DisplacementRate(data, checker).cwiseAbs2());
}

TEST(BushingForce, IsInternalAndTakesThePowerOfItsDamping) {
  ForceChecker checker;
  BushingData data = Bushing(checker);
  checker.Add(new BushingForce(data));
  checker.Draw();  // any design pose
  MeasureDesign(data, checker.state());
  for (int draw = 0; draw < kDraws; ++draw) {
    checker.Draw();
    checker.ExpectBalance(Dissipation(data, checker), 1000);
  }
}

TEST(BushingForce, MeasuresTheMotionOfItsChildInTheAxesOfItsParent) {
  ForceChecker checker;
  BushingData data = Bushing(checker);
  checker.Draw();
  MeasureDesign(data, checker.state());
  EXPECT_LT(Motion(data, checker.state()).displacement.norm(), 1e-15);
  for (int draw = 0; draw < kDraws; ++draw) {
    checker.Draw();
    const BushingMotion motion = Motion(data, checker.state());
    EXPECT_LT((motion.displacement - Displacement(data, checker.state())).norm(), 1e-14);  // rounding
    EXPECT_LT((motion.rate - DisplacementRate(data, checker)).norm(), 1e-10);              // ForceChecker::Rate
  }
}

TEST(BushingForce, DoesNotFeelAMotionOfBothBodiesTogether) {
  ForceChecker checker;
  BushingData data = Bushing(checker);
  data.preload.setZero();
  checker.Add(new BushingForce(data));
  checker.Rest();
  MeasureDesign(data, checker.state());
  State state = checker.state();
  for (const int first : {0, 6}) {
    for (int i = 0; i < 6; ++i) state.updQ()[first + i] = 0.3 * std::sin(i + 1.0);
    for (int i = 0; i < 6; ++i) state.updU()[first + i] = std::cos(i + 1.0);
  }
  checker.Place(state);
  // Rounding of metres times 40 kN/m, of 1 m/s times 400 N s/m.
  EXPECT_LT(checker.Sum().size, 1e-10);
}

// One component at a time, in its own axis, against the law in the table of tags.
TEST(BushingForce, HasTheStiffnessOfEachAxis) {
  ForceChecker checker;
  BushingData data = Bushing(checker);
  data.preload.setZero();
  data.parent_axes.setIdentity();
  data.parent_station = data.child_station = Vec3(0);
  checker.Add(new BushingForce(data));
  checker.Rest();
  MeasureDesign(data, checker.state());
  for (int axis = 0; axis < 6; ++axis) {
    // Simbody's coordinates of body 1: three angles, three travels; ours: three travels, three turns.
    State state = checker.state();
    state.updQ() = 0;
    state.updU() = 0;
    const int coordinate = 6 + (axis + 3) % 6;
    constexpr double kTravel = 0.01;
    state.updQ()[coordinate] = kTravel;
    state.updU()[coordinate] = 0.1;
    checker.Place(state);
    const auto k = static_cast<std::size_t>(axis);
    const double measure = axis < 3 ? kTravel : 2 * std::sin(kTravel / 2);
    const double rate = axis < 3 ? 0.1 : 0.1 * std::cos(kTravel / 2);
    const double resistance = data.stiffness[k] * measure + data.damping[k] * rate;
    // A turn's torque works on its small measure.
    const double power = -resistance * rate;
    EXPECT_NEAR(checker.Sum().power, power, 1e-13 * std::abs(power)) << axis;
  }
}

TEST(BushingForce, HasNoForceAtRestInTheDesignPoseButItsPreload) {
  ForceChecker checker;
  BushingData data = Bushing(checker);
  checker.Add(new BushingForce(data));
  checker.Draw(0, 0.3, 0);
  MeasureDesign(data, checker.state());
  const ForceChecker::Balance child = checker.Sum();
  EXPECT_GE(child.size, data.preload.norm() - 1e-9);  // rounding
  data.preload.setZero();
  checker.Draw(0, 0.3, 0);
  MeasureDesign(data, checker.state());
  EXPECT_LT(checker.Sum().size, 1e-10);  // rounding of metres times 40 kN/m
}

/// A tyre on body 0, its platform moving.
class TyreForceTest : public testing::Test {
 protected:
  TyreForceTest() {
    data_.body = checker_.body(0);
    data_.station = {0.2, 0.1, 0.1};
    data_.radius = 0.35;
    data_.vertical = TyreLaw{.stiffness = 200e3}.Under(5000);
    data_.damping = 300;
    data_.lateral = 120e3;
    data_.longitudinal = 20e3;
    data_.lateral_damping = 700;
    data_.longitudinal_damping = 90;
    data_.post = 0;
    checker_.Add(new TyreForce(data_, platforms_));
    checker_.Rest();
    MeasureDesign(data_, checker_.state());
  }

  /// Where the foot stands, by what TyreFoot says.
  Vector3d Foot(const State& state) const {
    return ToEigen(data_.body.findStationLocationInGround(state, data_.station)) +
           TyreFoot(RotationOf(data_.body, state), data_.radius).offset;
  }
  Vector3d Shift(const State& state) const {
    return Foot(state) - data_.design_place - Vector3d(0, 0, Platform(state.getTime()).height);
  }
  Vector3d ShiftRate() const {
    Vector3d rate;
    for (int i = 0; i < 3; ++i) rate[i] = checker_.Rate([&](const State& s) { return Shift(s)[i]; });
    return rate;
  }
  double SpringForce(const State& state) const { return data_.vertical.Force(-Shift(state).z()); }

  /// Power on wheel and platform = - energy' - dissipation.
  void ExpectBalancedPower(bool lifts) {
    int lifted = 0;
    for (int draw = 0; draw < 10 * kDraws; ++draw) {
      checker_.Draw();
      const State& state = checker_.state();
      const double spring = lifts ? std::max(0.0, SpringForce(state)) : SpringForce(state);
      const Vector3d rate = ShiftRate();
      const double push = TyreForce::Compression(data_, platforms_(0), state);
      const double dissipation = (spring - push) * rate.z() + 90 * rate.x() * rate.x() + 700 * rate.y() * rate.y();
      const double power = checker_.Sum().power - push * Platform(0).velocity;
      const double energy_rate = checker_.Rate([&](const State& s) { return checker_.Energy(s); });
      EXPECT_NEAR(power, -energy_rate - dissipation, 1e-8 * (std::abs(power) + std::abs(dissipation)));
      EXPECT_GE(dissipation, 0);
      EXPECT_TRUE(!lifts || push >= 0);
      lifted += push == 0;
    }
    EXPECT_EQ(lifted > 0, lifts);
  }

  static PostState Platform(double t) { return {.height = 0.004 + 0.2 * t, .velocity = 0.2}; }

  ForceChecker checker_;
  TyreData data_;
  Platforms now_{1};
  std::function<const Platforms&(double)> platforms_ = [this](double t) -> const Platforms& {
    now_[0] = Platform(t);
    return now_;
  };
};

TEST_F(TyreForceTest, PushesWithStiffnessDampingAndPreloadAndHoldsItsFoot) {
  for (int draw = 0; draw < kDraws; ++draw) {
    checker_.Draw();
    const State& state = checker_.state();
    const Vector3d rate = ShiftRate();
    const Vector3d shift = Shift(state);
    const Vector3d force(-20e3 * shift.x() - 90 * rate.x(), -120e3 * shift.y() - 700 * rate.y(),
                         5000 - 200e3 * shift.z() - 300 * rate.z());
    EXPECT_LT((ToEigen(checker_.Sum().force) - force).norm(), 1e-10 * force.norm());
    EXPECT_NEAR(TyreForce::Compression(data_, platforms_(0), state), force.z(), 1e-10 * force.norm());
  }
}

// Whether the tyre may lift or not, its rate constant or not.
TEST_F(TyreForceTest, BalancesThePowerOfWheelAndPlatform) {
  const LoadedTyre linear = data_.vertical;
  for (const bool lifts : {false, true})
    for (const LoadedTyre& vertical : {linear, TyreLaw{.stiffness = 150e3, .progression = 5}.Under(5000)}) {
      data_.lifts_off = lifts;
      data_.vertical = vertical;
      ExpectBalancedPower(lifts);
    }
}

TEST_F(TyreForceTest, StaysUprightHoweverItsLinkPitches) {
  State state = checker_.state();
  state.updQ()[1] = 0.4;  // pitch
  const Vec3 centre = data_.body.findStationLocationInGround(checker_.state(), data_.station);
  checker_.Place(state);
  const Vec3 moved = data_.body.findStationLocationInGround(checker_.state(), data_.station) - centre;
  EXPECT_LT((Shift(checker_.state()) + Vector3d(0, 0, Platform(0).height) - ToEigen(moved)).norm(), 1e-15);
}

// Tyres of before had no radius: force at the point, nothing else.
TEST_F(TyreForceTest, WithoutRadiusActsAtItsPoint) {
  data_.radius = 0;
  data_.lateral = data_.longitudinal = data_.lateral_damping = data_.longitudinal_damping = 0;
  checker_.Rest();
  MeasureDesign(data_, checker_.state());
  for (int draw = 0; draw < kDraws; ++draw) {
    checker_.Draw();
    const Vec3 point = data_.body.findStationLocationInGround(checker_.state(), data_.station);
    const Vec3 velocity = data_.body.findStationVelocityInGround(checker_.state(), data_.station);
    const double squeeze = data_.design_place.z() + Platform(0).height - point[2];
    const Vec3 force(0, 0, 5000 + 200e3 * squeeze + 300 * (Platform(0).velocity - velocity[2]));
    const ForceChecker::Balance sum = checker_.Sum();
    EXPECT_LT((sum.force - force).norm(), 1e-13 * force.norm());  // rounding
    EXPECT_LT((sum.moment - point % force).norm(), 1e-13 * force.norm());
    EXPECT_NEAR(sum.power, SimTK::dot(force, velocity), 1e-13 * force.norm());
  }
}

TEST_F(TyreForceTest, LiftsOffWherePreloadAndSqueezeAreUsedUp) {
  data_.lifts_off = true;
  const double lifted = 5000 / 200e3;
  for (const double above : {-0.001, 0.001, 0.1}) {
    State state = checker_.state();
    state.updQ() = 0;
    state.updQ()[5] = Platform(0).height + lifted + above;
    state.updU() = 0;
    state.updU()[5] = Platform(0).velocity;
    checker_.Place(state);
    // Rounding of the height.
    EXPECT_NEAR(checker_.Sum().force[2], above < 0 ? -200e3 * above : 0, 200e3 * 1e-16);
    // 0 in the design pose, least where the tyre leaves its platform: what the preload had stored.
    const double left = above < 0 ? 0.5 * 200e3 * above * above : 0;
    EXPECT_NEAR(checker_.Energy(), left - 0.5 * 5000 * lifted, 1e-10);
  }
}

TEST_F(TyreForceTest, HoldsItsFootInThePlaneThoughLifted) {
  data_.lifts_off = true;
  State state = checker_.state();
  state.updQ() = 0;
  state.updU() = 0;
  state.updQ()[4] = 0.02;  // to the left
  state.updQ()[5] = Platform(0).height + 0.1;
  checker_.Place(state);
  EXPECT_EQ(checker_.Sum().force[2], 0);
  EXPECT_NEAR(checker_.Sum().force[1], -120e3 * 0.02, 1e-9);  // rounding
}

TEST_F(TyreForceTest, WithoutStiffnessPushesWithItsPreloadAtAnyHeight) {
  data_.lifts_off = true;
  data_.vertical = TyreLaw().Under(5000);
  data_.damping = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    checker_.Draw();
    EXPECT_EQ(checker_.Sum().force[2], 5000);
    EXPECT_NEAR(checker_.Rate([&](const State& s) {
      const Vector3d shift = Shift(s);
      return checker_.Energy(s) - 0.5 * (20e3 * shift.x() * shift.x() + 120e3 * shift.y() * shift.y());
    }),
                -5000 * checker_.Rate([&](const State& s) { return Shift(s).z(); }), 1e-6);
  }
}

}  // namespace
}  // namespace fourpost::body_forces_test
