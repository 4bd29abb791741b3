#include "vehicles/multibody/line_forces.h"

#include <cmath>
#include <memory>

#include "tests/vehicles/force_checker.h"

namespace fourpost::line_forces_test {
namespace {

using SimTK::State;
using SimTK::Vec3;

constexpr int kDraws = 20;

/// From body 0 down to body 1 (or the ground), along the line that joins the points or along an axis of body 0.
BodyLine Line(const ForceChecker& checker, bool guided, bool to_ground = false) {
  BodyLine line{.parent = checker.body(0),
                .child = to_ground ? checker.ground() : checker.body(1),
                .parent_station = {0.1, 0.2, 0.9},
                .child_station = {0, -0.1, 0}};
  line.guided = guided;
  if (guided) line.axis = Vec3(0.6, 0, 0.8);
  line.design_length = 0.7;
  return line;
}

/// Runs `check` for lines free and guided, between bodies and to the ground.
template <typename Check>
void ForEachLine(Check check) {
  for (const bool guided : {false, true})
    for (const bool to_ground : {false, true}) {
      SCOPED_TRACE(testing::Message() << (guided ? "guided" : "free") << (to_ground ? " to the ground" : ""));
      check([=](const ForceChecker& checker) { return Line(checker, guided, to_ground); });
    }
}

double DifferencedRate(const ForceChecker& checker, const BodyLine& line) {
  return checker.Rate([&](const State& state) { return Length(line, state); });
}

TEST(BodyLine, HasTheRateOfItsLength) {
  ForEachLine([](auto line_of) {
    ForceChecker checker;
    for (int draw = 0; draw < kDraws; ++draw) {
      checker.Draw();
      const BodyLine line = line_of(checker);
      const LineMotion motion = Motion(line, checker.state());
      EXPECT_EQ(motion.extension, Extension(line, checker.state()));
      EXPECT_NEAR(motion.rate, DifferencedRate(checker, line), 1e-10);  // ForceChecker::Rate
    }
  });
}

TEST(BodyLine, PullsItsEndsTogether) {
  ForceChecker checker;
  checker.Rest();
  // In body axes, which are the ground's: from the child up to the parent.
  const LineMotion motion = Motion(Line(checker, false), checker.state());
  const Vec3 span = Vec3(0.1, 0.2, 0.9) - Vec3(0, -0.1, 0);
  EXPECT_LT((motion.pull - span / span.norm()).norm(), 1e-15);
  EXPECT_NEAR(motion.extension, span.norm() - 0.7, 1e-15);
  EXPECT_NEAR(Motion(Line(checker, true), checker.state()).extension, 0.6 * 0.1 + 0.8 * 0.9 - 0.7, 1e-15);
}

const SpringLaw kLinear{.stiffness = 30e3, .knees = {}};
const SpringLaw kCubic{.stiffness = 30e3, .cubic = 2e6, .knees = {}};
const SpringLaw kMultirate{.stiffness = 30e3, .knees = {{-0.05, -1, 20e3, 0}, {0.04, 1, -10e3, 0}}};
const SpringLaw kMeasured{.curve = MonotoneCurve({-0.1, -0.04, 0.01, 0.05}, {-6000, -1800, 200, 900})};
const SpringLaw kStop{.stiffness = 0, .knees = {{-0.02, -1, 200e3, 5e7}, {0.03, 1, 100e3, 0}}};

// It dissipates nothing and stores nothing: what it gives is its tension times the rate at which it shortens.
TEST(ActuatorForce, IsInternalAndGivesItsTensionTimesItsRate) {
  ForEachLine([](auto line_of) {
    ForceChecker checker;
    const BodyLine line = line_of(checker);
    const std::function<const Platforms&(double)> platforms = [](double) -> const Platforms& {
      static const Platforms inputs = {{.height = 1e9}, {.height = 700}};
      return inputs;
    };
    checker.Add(new ActuatorForce(line, 1, platforms));
    for (int draw = 0; draw < kDraws; ++draw) {
      checker.Draw();
      const ForceChecker::Balance balance = checker.Sum();
      EXPECT_LE(balance.force.norm(), 1e-14 * balance.size);
      EXPECT_LE(balance.moment.norm(), 1e-13 * balance.size);
      EXPECT_NEAR(balance.power, -700 * DifferencedRate(checker, line), 1e-7);  // ForceChecker::Rate
    }
  });
}

TEST(SpringForce, IsInternalAndKeepsEnergyForEveryLaw) {
  for (const SpringLaw& law : {kLinear, kCubic, kMultirate, kMeasured, kStop})
    ForEachLine([&](auto line_of) {
      ForceChecker checker;
      const SpringData data{.line = line_of(checker), .law = law, .preload = -500};
      checker.Add(new SpringForce(data));
      for (int draw = 0; draw < kDraws; ++draw) {
        checker.Draw();
        checker.ExpectBalance(0);
      }
    });
}

TEST(SpringForce, PullsWithItsPreloadAndLaw) {
  ForceChecker checker;
  SpringData data{.line = Line(checker, false), .law = kMultirate, .preload = -500};
  checker.Add(new SpringForce(data));
  for (int draw = 0; draw < kDraws; ++draw) {
    checker.Draw();
    const double x = Length(data.line, checker.state()) - data.line.design_length;
    const double tension = -500 + kMultirate.Force(x);
    // The parent is pulled to the child, the child to the parent.
    EXPECT_NEAR(checker.Sum().power, -tension * DifferencedRate(checker, data.line), 1e-9 * std::abs(tension));
  }
}

// Below the design length of a gas spring, -force + stiffness x pushes the ends apart.
TEST(SpringForce, GasPushesTheEndsApart) {
  ForceChecker checker;
  SpringData data{.line = Line(checker, false), .law = {.stiffness = 2e3, .knees = {}}, .preload = -120};
  auto force = std::make_unique<SpringForce>(data);
  checker.Rest();
  SimTK::Vector_<SimTK::SpatialVec> body_forces(ForceChecker::kBodies + 1, SimTK::SpatialVec(Vec3(0), Vec3(0)));
  SimTK::Vector_<Vec3> particle_forces;
  SimTK::Vector mobility_forces;
  data.line.design_length = Length(data.line, checker.state());
  force->calcForce(checker.state(), body_forces, particle_forces, mobility_forces);
  EXPECT_GT(body_forces[data.line.parent.getMobilizedBodyIndex()][1][2], 0) << "the upper end goes up";
  EXPECT_LT(body_forces[data.line.child.getMobilizedBodyIndex()][1][2], 0) << "the lower end goes down";
}

std::vector<DashpotLaw> Dashpots() {
  return {DashpotLaw(800, 2600), DashpotLaw::Smooth(800, 2600, 0.05),
          DashpotLaw::Digressive(2000, 3000, {0.1, 300}, {0.2, 500}),
          DashpotLaw::Table({-0.5, -0.1, 0.1, 0.5}, {-500, -200, 300, 900}),
          DashpotLaw(800, 2600).WithFriction(50, 0.005)};
}

TEST(DamperForce, IsInternalAndTakesThePowerOfItsLaw) {
  for (const DashpotLaw& law : Dashpots())
    ForEachLine([&](auto line_of) {
      ForceChecker checker;
      const DamperData data{.line = line_of(checker), .dashpot = law, .series = {}};
      checker.Add(new DamperForce(data, checker.forces()));
      for (int draw = 0; draw < kDraws; ++draw) {
        checker.Draw();
        const double rate = DifferencedRate(checker, data.line);
        checker.ExpectBalance(law.Force(rate) * rate, std::abs(law.Force(rate)));
      }
    });
}

TEST(DamperForce, InSeriesIsInternalAndLosesWhatItsDashpotTakes) {
  for (const DashpotLaw& law : Dashpots())
    for (const SpringLaw& spring : {kLinear, kCubic})
      ForEachLine([&](auto line_of) {
        ForceChecker checker;
        const DamperData data{.line = line_of(checker), .dashpot = law, .in_series = true, .series = spring};
        checker.Add(new DamperForce(data, checker.forces()));
        for (int draw = 0; draw < kDraws; ++draw) {
          checker.Draw(0.02);
          const double tension = spring.Force(checker.state().getZ()[0]);
          const double across = DifferencedRate(checker, data.line) - checker.state().getZDot()[0];
          // The spring carries the dashpot's force. Rate's error times the largest slope of these laws.
          EXPECT_NEAR(law.Force(across), tension, 1e-10 * law.GreatestRate() + 1e-12 * std::abs(tension));
          checker.ExpectBalance(tension * across, std::abs(tension));
        }
      });
}

// At a constant rate the spring settles where it carries the dashpot's force; the stiffer it is, the sooner.
TEST(DamperForce, InSeriesWithAStiffSpringIsTheDashpotAlone) {
  const DashpotLaw law(800, 2600);
  ForceChecker alone;
  ForceChecker series;
  const DamperData rigid{.line = Line(alone, false), .dashpot = law, .series = {}};
  const DamperData stiff{
      .line = Line(series, false), .dashpot = law, .in_series = true, .series = {.stiffness = 1e9, .knees = {}}};
  alone.Add(new DamperForce(rigid, alone.forces()));
  series.Add(new DamperForce(stiff, series.forces()));
  for (int draw = 0; draw < kDraws; ++draw) {
    alone.Draw();
    series.Rest();
    SimTK::State state = series.state();
    state.updQ() = alone.state().getQ();
    state.updU() = alone.state().getU();
    const double rate = Motion(rigid.line, alone.state()).rate;
    state.updZ()[0] = law.Force(rate) / 1e9;
    series.Place(state);
    EXPECT_NEAR(series.state().getZDot()[0], 0, 1e-14 * std::abs(rate));  // rounding
    EXPECT_NEAR(series.Sum().power, alone.Sum().power, 1e-14 * std::abs(law.Force(rate) * rate));
    // Elsewhere it settles within c / k, here 0.8 to 2.6 us.
    state.updZ()[0] += 1e-6;
    series.Place(state);
    EXPECT_NEAR(series.state().getZDot()[0], rate - law.Velocity(1e9 * state.getZ()[0]), 1e-12);
    EXPECT_LT(series.state().getZDot()[0], -1e-6 / 2.7e-6);
  }
}

/// With 1 m of oil: any draw is within the stroke.
HydraulicDamper LongDamper() {
  HydraulicDamper damper;
  damper.rebound_volume = damper.annulus_area;
  damper.compression_volume = damper.piston_area;
  // Friction turns over within millimetres per second, which no difference resolves.
  damper.friction_speed = 0.1;
  return damper;
}

TEST(HydraulicForce, IsInternalAndTakesThePowerOfItsValves) {
  ForEachLine([](auto line_of) {
    for (const bool is_mounted : {false, true}) {
      ForceChecker checker;
      const HydraulicData data{
          .line = line_of(checker),
          .damper = {.damper = LongDamper(), .mount = {.stiffness = 300e3, .cubic = 1e9, .knees = {}}},
          .is_mounted = is_mounted};
      const HydraulicDamper& damper = data.damper.damper;
      checker.Add(new HydraulicForce(data, checker.forces()));
      for (int draw = 0; draw < kDraws; ++draw) {
        // Slow, for the pressures of stiff oil change by kilopascals within the steps of Rate.
        checker.Draw(0.3, 0.3, 0.3);
        const std::array<double, 2> p = {damper.gas_pressure + 1e6 * checker.state().getZ()[0],
                                         damper.gas_pressure + 1e6 * checker.state().getZ()[1]};
        const double rate = DifferencedRate(checker, data.line);
        // Oil of 100 J/s and more goes to and fro.
        checker.ExpectBalance(damper.Dissipation(rate, p), std::abs(damper.Force(rate, p)));
      }
    }
  });
}

TEST(HydraulicForce, HasTheForceAndRatesOfItsEquations) {
  ForEachLine([](auto line_of) {
    ForceChecker checker;
    HydraulicData data{.line = line_of(checker), .damper = {.damper = LongDamper(), .mount = {}}};
    HydraulicDamper& damper = data.damper.damper;
    checker.Add(new HydraulicForce(data, checker.forces()));
    for (int draw = 0; draw < kDraws; ++draw) {
      checker.Draw(1);
      const std::array<double, 2> p = {damper.gas_pressure + 1e6 * checker.state().getZ()[0],
                                       damper.gas_pressure + 1e6 * checker.state().getZ()[1]};
      const double rate = DifferencedRate(checker, data.line);
      const ForceChecker::Balance balance = checker.Sum();
      EXPECT_NEAR(balance.power, -damper.Force(rate, p) * rate, 1e-8 * balance.size);
      const auto rates = damper.PressureRates(Length(data.line, checker.state()) - 0.7, rate, p);
      // Rate's 1e-10 m/s times the oil's stiffness over 1 m.
      for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(checker.state().getZDot()[i], rates[static_cast<std::size_t>(i)] / 1e6, 1e-7) << i;
    }
  });
}

/// Lines from body 0 to bodies 1 (left) and 2 (right).
AntiRollData Bar(const ForceChecker& checker, bool guided) {
  AntiRollData bar{.left = Line(checker, guided), .right = Line(checker, false), .stiffness = 12e3, .damping = 40};
  bar.right.child = checker.body(2);
  bar.right.parent_station = {0.1, -0.5, 0.8};
  return bar;
}

TEST(AntiRollForce, IsInternalAndTakesThePowerOfItsDamping) {
  for (const bool guided : {false, true}) {
    ForceChecker checker;
    const AntiRollData bar = Bar(checker, guided);
    checker.Add(new AntiRollForce(bar));
    for (int draw = 0; draw < kDraws; ++draw) {
      checker.Draw();
      const double twist = DifferencedRate(checker, bar.left) - DifferencedRate(checker, bar.right);
      checker.ExpectBalance(40 * twist * twist, 40 * std::abs(twist));
    }
  }
}

TEST(AntiRollForce, PullsOnTheLongerSideAndPushesOnTheOther) {
  ForceChecker checker;
  AntiRollData bar = Bar(checker, false);
  bar.damping = 0;
  checker.Add(new AntiRollForce(bar));
  for (int draw = 0; draw < kDraws; ++draw) {
    checker.Draw();
    const double left = Length(bar.left, checker.state()) - 0.7;
    const double right = Length(bar.right, checker.state()) - 0.7;
    const double tension = 12e3 * (left - right);
    const double power = -tension * (DifferencedRate(checker, bar.left) - DifferencedRate(checker, bar.right));
    EXPECT_NEAR(checker.Sum().power, power, 1e-9 * std::abs(tension));
    EXPECT_NEAR(checker.Energy(), 0.5 * tension * (left - right), 1e-12 * checker.Energy());
  }
}

// Both sides extend alike.
TEST(AntiRollForce, DoesNothingInHeave) {
  ForceChecker checker;
  AntiRollData bar = Bar(checker, false);
  bar.right.child_station = {0, 0.1, 0};
  bar.right.parent_station = {0.1, -0.2, 0.9};
  checker.Add(new AntiRollForce(bar));
  checker.Rest();
  SimTK::State state = checker.state();
  state.updQ()[5] = 0.08;  // body 0 up
  state.updU()[5] = 0.5;
  checker.Place(state);
  const double extension = Extension(bar.left, checker.state());
  EXPECT_GT(extension, 0.01);
  // Rounding of lengths of a metre: the twist.
  EXPECT_LT(checker.Sum().size, 12e3 * 1e-15);
}

TEST(LineForces, VanishAtRestInTheDesignPoseWithoutPreload) {
  const auto expect_none = [](auto make) {
    ForceChecker checker;
    checker.Rest();
    checker.Add(make(checker));
    checker.Rest();
    EXPECT_EQ(checker.Sum().size, 0);
    EXPECT_EQ(checker.Energy(), 0);
    for (int i = 0; i < checker.state().getNZ(); ++i) EXPECT_EQ(checker.state().getZDot()[i], 0);
  };
  const auto at_rest = [](BodyLine line, const ForceChecker& checker) {
    line.design_length = Length(line, checker.state());
    return line;
  };
  SpringData spring{.line = {}, .law = kMultirate};
  expect_none([&](const ForceChecker& checker) {
    spring.line = at_rest(Line(checker, false), checker);
    return new SpringForce(spring);
  });
  DamperData damper{.line = {}, .dashpot = DashpotLaw(800, 2600).WithFriction(50, 0.005), .series = {}};
  DamperData series{.line = {}, .dashpot = {800, 2600}, .in_series = true, .series = kCubic};
  for (DamperData* data : {&damper, &series})
    expect_none([&](const ForceChecker& checker) {
      data->line = at_rest(Line(checker, true), checker);
      return new DamperForce(*data, checker.forces());
    });
  HydraulicData hydraulic{.line = {}, .damper = {}};
  expect_none([&](const ForceChecker& checker) {
    hydraulic.line = at_rest(Line(checker, false), checker);
    return new HydraulicForce(hydraulic, checker.forces());
  });
  AntiRollData bar;
  expect_none([&](const ForceChecker& checker) {
    bar = Bar(checker, true);
    bar.left = at_rest(bar.left, checker);
    bar.right = at_rest(bar.right, checker);
    return new AntiRollForce(bar);
  });
}

// Of the power |v| F^2 / force is lost, whatever F and v.
TEST(FrictionForce, IsInternalAndLosesWhatItsLawSays) {
  ForEachLine([](auto line_of) {
    ForceChecker checker;
    const FrictionData data{.line = line_of(checker), .law = {.force = 60, .stiffness = 2e5}};
    checker.Add(new FrictionForce(data, checker.forces()));
    for (int draw = 0; draw < kDraws; ++draw) {
      checker.Draw(1);
      const double tension = 60 * checker.state().getZ()[0];
      const double rate = DifferencedRate(checker, data.line);
      // Strokes of Rate are far longer than the law's length of 0.3 mm in a second: its terms are of stiffness rate.
      checker.ExpectBalance(std::abs(rate) * tension * tension / 60, 2e5 * std::abs(rate));
    }
  });
}

}  // namespace
}  // namespace fourpost::line_forces_test
