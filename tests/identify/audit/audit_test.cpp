#include "identify/audit/audit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"
#include "identify/audit/audit_equations.h"

namespace fourpost::audit_test {
namespace {

using Complex = std::complex<double>;
using Kind = RigFault::Kind;
using Where = RigFault::Where;

constexpr double kNoise = 0.003;
constexpr double kMass = 1000;
constexpr double kRate = 2e5;

Eigen::RowVectorXd Row(double x) { return Eigen::RowVector2d(1, -x); }

AuditedSensor Accelerometer(const std::string& name, double x) {
  AuditedSensor sensor{.name = name, .motion = Row(x), .tilt = Eigen::RowVector2d::Zero()};
  sensor.motion_by_place = {Eigen::RowVector2d(0, -1), Eigen::RowVector2d::Zero(), Eigen::RowVector2d::Zero()};
  return sensor;
}

/// A bar on two tyres at x = 1 and -1 m, with heave and pitch (nose down) as coordinates: any motion will do, forces
/// are those that move its mass.
AuditSubject Bar(std::uint64_t seed) {
  AuditSubject bar;
  bar.car.coordinates = 2;
  for (const auto& [name, x] : {std::pair{"front", 1.0}, {"middle", 0.1}, {"rear", -1.0}, {"tail", -1.6}})
    bar.car.sensors.push_back(Accelerometer(name, x));
  bar.car.sensors.push_back({.name = "strut",
                             .device = Device::kStruts,
                             .motion = Eigen::RowVector2d(1, 0.4),
                             .tilt = Eigen::RowVector2d::Zero()});
  bar.car.tyres = {{.name = "front", .foot = Row(1), .post = 0, .compliance = 1 / kRate, .cell = "F_front"},
                   {.name = "rear", .foot = Row(-1), .post = 1, .compliance = 1 / kRate, .cell = "F_rear"}};
  bar.car.balance = AuditedBalance{.lever = Eigen::Vector2d(1, 1),
                                   .inertia = kMass * Eigen::RowVector2d(1, 0),
                                   .gravity = Eigen::RowVector2d::Zero(),
                                   .inertia_slope = {Eigen::RowVector2d(1, 0)},
                                   .gravity_slope = {Eigen::RowVector2d::Zero()}};
  bar.car.reach = Eigen::VectorXd::Constant(1, 100);
  bar.weight = AuditedWeight{
      .measured = 9.81 * kMass, .sd = 20, .modelled = 9.81 * kMass, .slope = Eigen::VectorXd::Constant(1, 9.81)};
  RandomStream noise(seed, "audit test");
  const auto normal = [&] { return Complex(noise.Normal(), noise.Normal()); };
  AuditedRun run{.name = "bounce"};
  for (int i = 0; i < 40; ++i) run.frequency_Hz.push_back(0.5 * std::pow(10, i / 39.0));
  run.posts.setZero(2, 40);
  run.motions.setZero(5, 40);
  run.motion_sd.setConstant(5, 40, kNoise);
  run.forces.setZero(2, 40);
  run.force_sd.setZero(2, 40);
  for (Eigen::Index f = 0; f < 40; ++f) {
    const double omega = 2 * std::numbers::pi * run.frequency_Hz[static_cast<std::size_t>(f)];
    const Eigen::Vector2cd q = {1.0 + 0.3 * normal(), 0.3 * normal()};
    for (Eigen::Index s = 0; s < 5; ++s)
      run.motions(s, f) =
          (bar.car.sensors[static_cast<std::size_t>(s)].motion.cast<Complex>() * q)(0) + kNoise * normal();
    for (Eigen::Index t = 0; t < 2; ++t) {
      // Half of the mass above each tyre, and pitch that adds nothing to the sum.
      const Complex force = -omega * omega * kMass * (0.5 * q[0] + (t == 0 ? 0.2 : -0.2) * q[1]);
      run.forces(t, f) = force;
      run.force_sd(t, f) = 0.005 * std::abs(force);
      run.posts(t, f) = (bar.car.tyres[static_cast<std::size_t>(t)].foot.cast<Complex>() * q)(0) + force / kRate;
      run.forces(t, f) += run.force_sd(t, f) * normal();
    }
  }
  bar.runs = {run};
  return bar;
}

RigFault Fault(const AuditSubject& subject, Kind kind, const std::string& name) {
  for (const RigFault& fault : PossibleFaults(subject, {}))
    if (fault.kind == kind && fault.name == name && fault.axis == 0) return fault;
  throw std::invalid_argument("no fault of " + name);
}

Audit WithFault(Kind kind, const std::string& name, double size) {
  const AuditSubject bar = Bar(1);
  // To correct by the opposite is to put it in.
  return AuditRig(Corrected(bar, Fault(bar, kind, name), size));
}

/// The first suspicion is this one, of this size to four standard deviations and the change of size by itself.
void ExpectSuspicion(const Audit& audit, Kind kind, const std::string& name, double size) {
  ASSERT_FALSE(audit.suspicions.empty());
  const Suspicion& first = audit.suspicions.front();
  EXPECT_EQ(first.fault.kind, kind);
  EXPECT_EQ(first.fault.name, name);
  EXPECT_NEAR(first.size, size, 4 * first.sd + 0.05 * std::abs(size));
  EXPECT_LT(audit.misfit, 1.3);
}

TEST(Audit, GoodRecordsRaiseNoSuspicion) {
  // 20 audits of some 40 faults each at 4.5 standard deviations: one in 180 such tests would fail by chance.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) EXPECT_TRUE(AuditRig(Bar(seed)).suspicions.empty()) << seed;
}

TEST(Audit, WhatIsLeftOverIsNoise) {
  const Audit audit = AuditRig(Bar(3));
  // With the tolerance of a reading, noise is overstated a little.
  EXPECT_GT(audit.misfit, 0.6);
  EXPECT_LT(audit.misfit, 1.1);
}

TEST(Audit, NamesScalesOfSensors) {
  ExpectSuspicion(WithFault(Kind::kScale, "middle", 0.04), Kind::kScale, "middle", 1 / 1.04 - 1);
}
TEST(Audit, NamesSigns) { ExpectSuspicion(WithFault(Kind::kScale, "tail", -2), Kind::kScale, "tail", -2); }
TEST(Audit, NamesUnits) {
  ExpectSuspicion(WithFault(Kind::kScale, "rear", 8.80665), Kind::kScale, "rear", 1 / 9.80665 - 1);
}
TEST(Audit, NamesDelays) { ExpectSuspicion(WithFault(Kind::kDelay, "rear", 0.003), Kind::kDelay, "rear", -0.003); }
TEST(Audit, NamesExchangedSensors) {
  ExpectSuspicion(WithFault(Kind::kExchange, "front and rear", 0), Kind::kExchange, "front and rear", 0);
}
TEST(Audit, NamesExchangedLoadCells) {
  ExpectSuspicion(WithFault(Kind::kExchange, "F_front and F_rear", 0), Kind::kExchange, "F_front and F_rear", 0);
}
TEST(Audit, NamesPlaces) { ExpectSuspicion(WithFault(Kind::kPlace, "tail", 0.1), Kind::kPlace, "tail", -0.1); }
TEST(Audit, NamesPostsOnAnotherClock) {
  ExpectSuspicion(WithFault(Kind::kDelay, "posts", 0.003), Kind::kDelay, "posts", -0.003);
}
TEST(Audit, NamesScaleOfPosts) {
  ExpectSuspicion(WithFault(Kind::kScale, "posts", 0.05), Kind::kScale, "posts", 1 / 1.05 - 1);
}

TEST(Audit, NamesWheelpans) {
  ExpectSuspicion(WithFault(Kind::kWheelpan, "F_front", -14), Kind::kWheelpan, "F_front", 14);
  // Each is weighed, where several are of one mass as well.
  const Audit both = WithFault(Kind::kWheelpan, "all load cells", 14);
  ExpectSuspicion(both, Kind::kWheelpan, "F_front", -14);
  ASSERT_EQ(both.suspicions.size(), 2U);
  EXPECT_EQ(both.suspicions[1].fault.name, "F_rear");
  EXPECT_NEAR(both.suspicions[1].size, -14, 4 * both.suspicions[1].sd);
}

/// 14 kg more on the post of the front tyre than the file has.
AuditSubject WithHeavierPan() {
  const AuditSubject bar = Bar(1);
  return Corrected(bar, Fault(bar, Kind::kWheelpan, "F_front"), -14);
}

TEST(Audit, AWheelpanThatAParameterSetsIsUnknownWithinItsReach) {
  AuditSubject bar = WithHeavierPan();
  ASSERT_FALSE(AuditRig(bar).suspicions.empty());
  bar.car.reach = Eigen::Vector2d(bar.car.reach[0], 20);
  bar.car.balance->inertia_slope.emplace_back(Eigen::RowVector2d::Zero());
  bar.car.balance->gravity_slope.emplace_back(Eigen::RowVector2d::Zero());
  bar.weight->slope = Eigen::Vector2d(9.81, 0);
  bar.car.tyres[0].wheelpan_slope = Eigen::Vector2d(0, 1);
  const Audit free = AuditRig(bar);
  EXPECT_TRUE(free.suspicions.empty());
  EXPECT_LT(free.misfit, 1.1);
  // Not far beyond it: masses stay within three times their reach.
  bar.car.reach[1] = 0.5;
  EXPECT_FALSE(AuditRig(bar).suspicions.empty());
}

// Found one after the other, by derivatives, a wheelpan takes its part of the tyre's rate: 55 kg of 60.
TEST(Audit, WeighsAWheelpanTogetherWithTheRateOfItsTyre) {
  AuditSubject bar = Bar(1);
  bar = Corrected(bar, Fault(bar, Kind::kWheelpan, "F_front"), -60);
  bar = Corrected(bar, Fault(bar, Kind::kDelay, "strut"), -0.012);
  const Audit audit = AuditRig(bar);
  const auto named = [&](Kind kind, const std::string& name, double size, double within) {
    return std::any_of(audit.suspicions.begin(), audit.suspicions.end(), [&](const Suspicion& one) {
      return one.fault.kind == kind && one.fault.name == name && std::abs(one.size - size) < within;
    });
  };
  // 1.5 standard deviations, which are mostly of what a good rig may be off by: these readings are not.
  EXPECT_TRUE(named(Kind::kWheelpan, "F_front", 60, 4));
  EXPECT_TRUE(named(Kind::kDelay, "strut", 0.012, 0.001));
}

TEST(Audit, TellsTheWheelpanOfALoadCell) {
  const std::optional<FoundWheelpan> heavier = WheelpanBy(AuditRig(WithHeavierPan()), "F_front", 14);
  ASSERT_TRUE(heavier);
  EXPECT_NEAR(heavier->kg, 14, 4 * heavier->sd);
  // None beside the file's would have been seen.
  const std::optional<FoundWheelpan> same = WheelpanBy(AuditRig(Bar(1)), "F_front", 14);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->kg, 0);
  EXPECT_FALSE(WheelpanBy(AuditRig(Bar(1)), "F_front", 0.1));
}

TEST(Audit, NamesAChannelThatMeasuresSomethingElse) {
  AuditSubject bar = Bar(1);
  RandomStream noise(7, "audit test");
  for (Complex& reading : bar.runs[0].motions.row(1)) reading = Complex(noise.Normal(), noise.Normal());
  const Audit audit = AuditRig(bar);
  ASSERT_FALSE(audit.suspicions.empty());
  EXPECT_EQ(audit.suspicions[0].fault.kind, Kind::kOther);
  EXPECT_EQ(audit.suspicions[0].fault.name, "middle");
}

TEST(Audit, ForcesTimeAndWeightCannotBeToldApart) {
  const Audit audit = WithFault(Kind::kScale, "loads at rest", 0.1);
  ASSERT_FALSE(audit.suspicions.empty());
  std::vector<std::string> names = {audit.suspicions[0].fault.name};
  for (const Suspicion::Rival& rival : audit.suspicions[0].rivals) names.push_back(rival.fault.name);
  EXPECT_THAT(names, testing::IsSupersetOf({"loads at rest", "all load cells", "frequency"}));
}

TEST(Audit, SaysWhatRedundancyDoesNotShow) {
  AuditSubject bar = Bar(1);
  // As many sensors as coordinates, and no force.
  bar.runs[0].motions.bottomRows(3).setConstant(std::nan(""));
  bar.runs[0].forces.setConstant(std::nan(""));
  bar.weight.reset();
  bar.car.reach.resize(0);
  bar.car.balance.reset();
  // A bound on coordinates is all that is left: a sensor may be off by any size that moves them within it. Sizes beyond
  // a whole reading and a period are none.
  const Audit audit = AuditRig(bar);
  EXPECT_FALSE(audit.is_redundant);
  for (const Resolution& resolution : audit.resolutions)
    EXPECT_FALSE(std::isfinite(resolution.sd)) << resolution.fault.name;
}

TEST(AuditEquations, CoordinatesLeaveNothingOver) {
  const AuditSubject bar = Bar(1);
  const AuditEquations equations(bar, {});
  AuditSubject moved = bar;
  const Eigen::Vector2cd change(Complex(0.1, 0.2), Complex(-0.3, 0.1));
  for (std::size_t s = 0; s < 5; ++s)
    moved.runs[0].motions.row(static_cast<Eigen::Index>(s)).array() +=
        (bar.car.sensors[s].motion.cast<Complex>() * change)(0);
  for (std::size_t t = 0; t < 2; ++t)
    moved.runs[0].posts.row(static_cast<Eigen::Index>(t)).array() +=
        (bar.car.tyres[t].foot.cast<Complex>() * change)(0);
  const Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(equations.unknowns());
  const Eigen::VectorXd difference = equations.Misclosures(moved, unknowns) - equations.Misclosures(bar, unknowns);
  for (std::size_t i = 0; i < equations.rows().size(); ++i) {
    if (equations.rows()[i].kind == AuditEquations::Row::Kind::kSensor ||
        equations.rows()[i].kind == AuditEquations::Row::Kind::kTyre) {
      // The bound on coordinates takes a share of (noise / 10)^2.
      EXPECT_NEAR(difference[static_cast<Eigen::Index>(i)], 0, 1e-3);
    }
  }
}

TEST(Audit, ClearsChannelsWhoseScaleAndDelayItWouldHaveSeen) {
  const Resolution scale{.fault = {.kind = Kind::kScale, .name = "s"}, .sd = 0.01};
  const Resolution delay{.fault = {.kind = Kind::kDelay, .name = "s"}, .sd = 0.0005};
  Audit audit;
  audit.is_redundant = true;
  audit.resolutions = {scale, delay};
  EXPECT_TRUE(ClearsChannels(audit, {"s"}));
  EXPECT_FALSE(ClearsChannels(audit, {"s", "other"}));
  audit.resolutions[1].sd = 0.005;
  EXPECT_FALSE(ClearsChannels(audit, {"s"}));
  audit.resolutions[1].sd = 0.0005;
  audit.suspicions.emplace_back();
  EXPECT_FALSE(ClearsChannels(audit, {"s"}));
}

}  // namespace
}  // namespace fourpost::audit_test
