#include "vehicles/bench/bench_damper.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "vehicles/laws/hydraulic_damper.h"

namespace fourpost::bench_damper_test {
namespace {

/// A rod that slides in a clamped tube, with these elements between them.
std::string Bench(const std::string& elements) {
  return R"(<?xml version="1.0"?>
<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="tube"/>
  <link name="rod"><inertial><mass value="1"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/>
    <origin xyz="0.4 0 0"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
)" + elements +
         "</robot>\n";
}

const std::string kRate =
    R"(<fp:parameter name="c" value="1500 N*s/m" lower="100 N*s/m" upper="5 kN*s/m" precision="1 N*s/m" source="test"/>)";

const std::string kEnds = R"( parent="tube" child="rod">)";

BenchMotion SineMotion(double amplitude, double frequency_Hz, int samples = 501) {
  const double w = 2 * std::numbers::pi * frequency_Hz;
  std::vector<double> x;
  for (int k = 0; k < samples; ++k) x.push_back(amplitude * std::sin(w * 0.002 * k));
  return MotionThrough(x, 0.002);
}

std::vector<double> Tensions(const Vehicle& vehicle, const BenchMotion& motion, std::vector<double> values) {
  return BenchDamper(vehicle, 0).Tensions(motion, values);
}

TEST(BenchDamper, HasTheForceOfItsLawAtTheValuesGiven) {
  const Vehicle vehicle =
      VehicleOf(Bench(kRate + R"(<fp:damper name="d")" + kEnds + R"(<linear rate="$c"/></fp:damper>)"));
  const BenchMotion motion = SineMotion(0.01, 2);
  const std::vector<double> tensions = Tensions(vehicle, motion, {1200});
  ASSERT_EQ(tensions.size(), 501);
  for (std::size_t k = 0; k < tensions.size(); ++k) ASSERT_DOUBLE_EQ(tensions[k], 1200 * motion.rate[2 * k]);
}

// Of all between its ends, and of nothing else.
TEST(BenchDamper, AddsWhatActsBesideIt) {
  const Vehicle vehicle = VehicleOf(
      Bench(kRate + R"(<fp:damper name="d")" + kEnds +
            R"(<linear rate="$c"/><gas force="60 N" stiffness="2 N/mm"/></fp:damper><fp:damper name="seal")" + kEnds +
            R"(<linear rate="0 N*s/m"/><friction force="30 N" speed="1 mm/s"/></fp:damper>
               <fp:frame name="aside" link="tube" xyz="0 0.1 0"/>
               <fp:damper name="other" parent="aside" child="rod"><linear rate="9 kN*s/m"/></fp:damper>)"));
  const BenchMotion motion = SineMotion(0.01, 2);
  const std::vector<double> tensions = Tensions(vehicle, motion, {1200});
  for (std::size_t k = 0; k < tensions.size(); ++k) {
    const double v = motion.rate[2 * k];
    ASSERT_NEAR(tensions[k], 1200 * v - 60 + 2000 * motion.extension[2 * k] + 30 * std::tanh(v / 1e-3), 1e-9);
  }
}

// Dahl's closed loop of a stroke from -A to A: F tanh(stiffness A / F) where it turns round.
TEST(BenchDamper, RubsAlongTheMeasuredPath) {
  const Vehicle vehicle =
      VehicleOf(Bench(kRate + R"(<fp:damper name="d")" + kEnds +
                      R"(<linear rate="$c"/><friction force="60 N" stiffness="200 N/mm"/></fp:damper>)"));
  for (const double amplitude : {3e-4, 0.01}) {
    const std::vector<double> tensions = Tensions(vehicle, SineMotion(amplitude, 2), {0});
    const double turning = 60 * std::tanh(amplitude * 2e5 / 60);
    // The first cycle, which ends at sample 250, forgets where it began: exp(-4 A stiffness / F) of 60 N, 1.1 N at 3e-4
    // m.
    const double forgotten = 60 * std::exp(-4 * amplitude * 2e5 / 60);
    double most = 0;
    for (std::size_t k = 251; k < tensions.size(); ++k) most = std::max(most, tensions[k]);
    EXPECT_NEAR(most, turning, forgotten + 1e-3);
    // At mid-stroke downwards.
    const double middle = -(60 - (60 + turning) * std::exp(-amplitude * 2e5 / 60));
    EXPECT_NEAR(tensions[375], middle, forgotten + 1e-3);
  }
}

TEST(BenchDamper, MayStandOnASeriesSpring) {
  const Vehicle vehicle = VehicleOf(Bench(kRate + R"(<fp:damper name="d")" + kEnds +
                                          R"(<linear rate="$c"/><series stiffness="400 N/mm"/></fp:damper>)"));
  const std::vector<double> tensions = Tensions(vehicle, SineMotion(0.001, 20), {1500});
  double most = 0;
  for (std::size_t k = 250; k < tensions.size(); ++k) most = std::max(most, tensions[k]);
  const double w = 40 * std::numbers::pi;
  // 25 samples a period see the peak to (pi / 25)^2 / 2.
  EXPECT_NEAR(most, 1500e-3 * w / std::hypot(1, 1500 * w / 4e5), 0.008 * most);
}

constexpr char kHydraulic[] =
    R"(<hydraulic bleed="0.7 mm^2" rebound_valve="10 MPa*s/kg"/><friction force="50 N" speed="5 mm/s"/></fp:damper>)";

// Appendix A's equations by the classical Runge-Kutta method in steps of 5 us.
TEST(BenchDamper, MayBeHydraulic) {
  const Vehicle vehicle = VehicleOf(Bench(R"(<fp:damper name="d")" + kEnds + kHydraulic));
  const BenchMotion motion = SineMotion(0.01, 8);
  const std::vector<double> tensions = Tensions(vehicle, motion, {});
  const HydraulicDamper law = vehicle.dampers[0].HydraulicAt({});
  std::array<double, 2> p = law.Rest();
  constexpr int kFiner = 400;
  const double h = 0.002 / kFiner;
  const double w = 16 * std::numbers::pi;
  const auto x = [&](double t) { return 0.01 * std::sin(w * t); };
  const auto v = [&](double t) { return 0.01 * w * std::cos(w * t); };
  const auto moved = [](std::array<double, 2> a, double s, const std::array<double, 2>& b) {
    return std::array{a[0] + s * b[0], a[1] + s * b[1]};
  };
  double worst = 0;
  double most = 0;
  for (int i = 0; i < 500 * kFiner; ++i) {
    const double t = i * h;
    const auto k1 = law.PressureRates(x(t), v(t), p);
    const auto k2 = law.PressureRates(x(t + h / 2), v(t + h / 2), moved(p, h / 2, k1));
    const auto k3 = law.PressureRates(x(t + h / 2), v(t + h / 2), moved(p, h / 2, k2));
    const auto k4 = law.PressureRates(x(t + h), v(t + h), moved(p, h, k3));
    for (std::size_t j = 0; j < 2; ++j) p[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    if ((i + 1) % kFiner != 0) continue;
    const double force = law.Force(v(t + h), p);
    most = std::max(most, std::abs(force));
    // From the second cycle on: at its start the rate jumps, which steps of 1 ms smooth.
    if (i > 62 * kFiner)
      worst = std::max(worst, std::abs(tensions[static_cast<std::size_t>((i + 1) / kFiner)] - force));
  }
  EXPECT_LT(worst, 0.01 * most);
}

TEST(BenchDamper, GivesNothingWhereAChamberCloses) {
  const Vehicle vehicle = VehicleOf(Bench(R"(<fp:damper name="d")" + kEnds + kHydraulic));
  EXPECT_TRUE(Tensions(vehicle, SineMotion(0.12, 1), {}).empty());
}

}  // namespace
}  // namespace fourpost::bench_damper_test
