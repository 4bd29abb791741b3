#include "vehicles/laws/hydraulic_damper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::hydraulic_damper_test {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPeakSpeed = 0.5;  // m/s

HydraulicDamper Setting(double bleed, double rebound_valve, double bulk_modulus) {
  return {.bleed_resistance = bleed, .rebound_valve_resistance = rebound_valve, .bulk_modulus = bulk_modulus};
}

struct Sample {
  double x = 0;
  double v = 0;
  std::array<double, 2> pressure{};
  double force = 0;
};

std::array<double, 2> Along(const std::array<double, 2>& p, double step, const std::array<double, 2>& rate) {
  return {p[0] + step * rate[0], p[1] + step * rate[1]};
}

/// x = X sin(w t) from rest, peak speed kPeakSpeed, Runge-Kutta of fourth order with steps of 50 us.
std::vector<Sample> March(const HydraulicDamper& damper, double frequency_Hz, double cycles) {
  constexpr double kStep = 50e-6;
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  std::vector<Sample> samples;
  std::array<double, 2> p = damper.Rest();
  const auto x = [&](double t) { return kPeakSpeed / omega * std::sin(omega * t); };
  const auto v = [&](double t) { return kPeakSpeed * std::cos(omega * t); };
  const long steps = std::lround(cycles / frequency_Hz / kStep);
  for (long k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) * kStep;
    samples.push_back({x(t), v(t), p, damper.Force(v(t), p)});
    const auto k1 = damper.PressureRates(x(t), v(t), p);
    const double mid = t + kStep / 2;
    const auto k2 = damper.PressureRates(x(mid), v(mid), Along(p, kStep / 2, k1));
    const auto k3 = damper.PressureRates(x(mid), v(mid), Along(p, kStep / 2, k2));
    const auto k4 = damper.PressureRates(x(t + kStep), v(t + kStep), Along(p, kStep, k3));
    for (std::size_t i = 0; i < 2; ++i) p[i] += kStep / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return samples;
}

std::vector<Sample> SecondCycle(const HydraulicDamper& damper, double frequency_Hz) {
  std::vector<Sample> samples = March(damper, frequency_Hz, 2);
  samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2));
  return samples;
}

double Work(const std::vector<Sample>& cycle) {
  double work = 0;
  for (std::size_t i = 1; i < cycle.size(); ++i)
    work += 0.5 * (cycle[i].force + cycle[i - 1].force) * (cycle[i].x - cycle[i - 1].x);
  return work;
}

/// What the forces of the reference calculation may differ by: it let both chambers pass one volume flow, which loses
/// the oil W/K in each of its two cycles, and with it pressure of the gas; and half of the last printed digit.
double ReferenceError(const HydraulicDamper& damper, const std::vector<Sample>& cycle) {
  const double lost = 2 * Work(cycle) / damper.bulk_modulus;
  const double pressure = damper.gas_exponent * damper.gas_pressure / damper.gas_volume * lost;
  return pressure * (damper.piston_area - damper.annulus_area) + 0.5;
}

void ExpectExtremes(const HydraulicDamper& damper, double greatest, double least) {
  const std::vector<Sample> cycle = SecondCycle(damper, 2);
  const auto by_force = [](const Sample& a, const Sample& b) { return a.force < b.force; };
  const auto [low, high] = std::minmax_element(cycle.begin(), cycle.end(), by_force);
  EXPECT_NEAR(high->force, greatest, ReferenceError(damper, cycle));
  EXPECT_NEAR(low->force, least, ReferenceError(damper, cycle));
}

// Forces of an independent calculation, 0.5 m/s at 2 Hz.
TEST(HydraulicDamper, HasTheReferenceForces) {
  ExpectExtremes(Setting(4e4, 1e7, 3e8), 1311, -401);
  ExpectExtremes(Setting(1e4, 1e7, 3e8), 844, -327);
  ExpectExtremes(Setting(1e4, 1e6, 1e8), 175, -329);
  ExpectExtremes(Setting(4e4, 3e7, 1e8), 3394, -391);
}

TEST(HydraulicDamper, CompressibleOilHasTheReferenceForceAtTheTurningPoint) {
  const HydraulicDamper damper = Setting(4e4, 3e7, 1e8);
  const std::vector<Sample> cycle = SecondCycle(damper, 12);
  const auto after = std::find_if(cycle.begin(), cycle.end(), [](const Sample& s) { return s.v <= 0; });
  const Sample before = *(after - 1);
  const double force = std::lerp(before.force, after->force, before.v / (before.v - after->v));
  // The reference took a sample: the force falls by some 30 N from one to the next.
  EXPECT_NEAR(force, 1522, ReferenceError(damper, cycle) + (before.force - after->force) / 2);
}

double OilMass(const HydraulicDamper& d, const Sample& s) {
  const auto density = [&](double p) { return d.density * std::exp((p - d.gas_pressure) / d.bulk_modulus); };
  const double gas = d.gas_volume * std::pow(d.gas_pressure / s.pressure[1], 1 / d.gas_exponent);
  return density(s.pressure[0]) * (d.rebound_volume - d.annulus_area * s.x) +
         density(s.pressure[1]) * (d.compression_volume + d.piston_area * s.x + d.gas_volume - gas);
}

TEST(HydraulicDamper, KeepsItsOil) {
  const HydraulicDamper damper = Setting(4e4, 3e7, 1e8);
  const std::vector<Sample> samples = March(damper, 2, 10);
  // Rounding over 100 000 steps; the integrator errs along lines of constant mass.
  for (const Sample& sample : samples)
    EXPECT_NEAR(OilMass(damper, sample) / OilMass(damper, samples.front()), 1, 1e-12);
}

/// Whose oil boils in compression.
HydraulicDamper Boiling() {
  HydraulicDamper damper;
  damper.compression_valve_resistance = 3e7;
  damper.bleed_resistance = 2e5;
  return damper;
}

double LowestReboundPressure(const std::vector<Sample>& samples) {
  const auto by_pressure = [](const Sample& a, const Sample& b) { return a.pressure[0] < b.pressure[0]; };
  return std::min_element(samples.begin(), samples.end(), by_pressure)->pressure[0];
}

TEST(HydraulicDamper, KeepsItsOilWhereItBoils) {
  const HydraulicDamper damper = Boiling();
  const std::vector<Sample> samples = March(damper, 2, 10);
  // A good share of the chamber is vapour.
  EXPECT_LT(LowestReboundPressure(samples), -0.05 * damper.bulk_modulus);
  // Two kinks a cycle, of some GPa/s over half of a step of 50 us: 1e-5 of the bulk modulus to the square.
  for (const Sample& sample : samples) EXPECT_NEAR(OilMass(damper, sample) / OilMass(damper, samples.front()), 1, 1e-7);
}

/// Work - change of energy - loss over the samples, and the work.
std::pair<double, double> Imbalance(const HydraulicDamper& damper, const std::vector<Sample>& samples) {
  double work = 0;
  double loss = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double half = 0.5 * 50e-6;
    const auto power = [&](const Sample& s) { return half * s.force * s.v; };
    const auto taken = [&](const Sample& s) { return half * damper.Dissipation(s.v, s.pressure); };
    work += power(samples[i - 1]) + power(samples[i]);
    loss += taken(samples[i - 1]) + taken(samples[i]);
  }
  const auto energy = [&](const Sample& s) { return damper.Energy(s.x, s.pressure); };
  return {work - loss - (energy(samples.back()) - energy(samples.front())), work};
}

TEST(HydraulicDamper, LosesInItsValvesWhatItDoesNotHold) {
  // 1.3, and a gas of constant temperature, of which the energy has another form.
  for (const double exponent : {1.3, 1.0}) {
    HydraulicDamper damper = Setting(4e4, 3e7, 1e8);
    damper.gas_exponent = exponent;
    for (const double cycles : {0.3, 2.0}) {
      const auto [rest, work] = Imbalance(damper, March(damper, 2, cycles));
      // The trapezoidal rule's (h w)^2 of harmonics up to some hundred hertz.
      EXPECT_NEAR(rest / work, 0, 1e-5) << exponent << " " << cycles;
    }
  }
}

TEST(HydraulicDamper, VapourHoldsWhatItTookToMakeRoom) {
  const HydraulicDamper damper = Boiling();
  for (const double cycles : {0.4, 0.6, 2.0}) {
    const auto [rest, work] = Imbalance(damper, March(damper, 2, cycles));
    // As above; the kinks of boiling cost a hundredth of a step's work each.
    EXPECT_NEAR(rest / work, 0, 1e-4) << cycles;
  }
}

TEST(HydraulicDamper, HoldsAndLosesNothingAtRest) {
  const HydraulicDamper damper;
  EXPECT_EQ(damper.Energy(0, damper.Rest()), 0);
  EXPECT_EQ(damper.Dissipation(0, damper.Rest()), 0);
}

TEST(HydraulicDamper, RestsAtRest) {
  const HydraulicDamper damper;
  const std::array<double, 2> rest = damper.Rest();
  EXPECT_EQ(damper.PressureRates(0, 0, rest)[0], 0);
  EXPECT_EQ(damper.PressureRates(0, 0, rest)[1], 0);
  EXPECT_EQ(damper.Force(0, rest), 0);
  EXPECT_EQ(damper.SteadyForce(0), 0);
}

TEST(HydraulicDamper, SteadyForceHoldsThePressuresOfStiffOil) {
  const HydraulicDamper damper = Setting(4e4, 1e7, 1e20);
  for (const double v : {-1.0, -0.2, -1e-3, 1e-3, 0.2, 1.0}) {
    const double friction = damper.friction * std::tanh(v / damper.friction_speed);
    const double difference = (damper.SteadyForce(v) - friction) / damper.annulus_area;
    const auto rates = damper.PressureRates(0, v, {damper.gas_pressure + difference, damper.gas_pressure});
    // Of what the motion alone would give; rounding of forces of 50 N or more in pressures down to 100 Pa.
    const double alone = damper.bulk_modulus * damper.annulus_area / damper.rebound_volume * v;
    EXPECT_NEAR(rates[0] / alone, 0, 1e-12) << v;
  }
}

TEST(HydraulicDamper, SteadyForceIncreasesWithSpeed) {
  const HydraulicDamper damper;
  // Slower than what empties the rebound chamber.
  for (double v = -1.2; v < 2; v += 0.01) EXPECT_LT(damper.SteadyForce(v), damper.SteadyForce(v + 0.01));
}

TEST(HydraulicDamper, ForceStopsFallingAtCavitation) {
  const HydraulicDamper damper = Boiling();
  const std::array<double, 2> boiling = {damper.cavitation_pressure, damper.gas_pressure};
  const std::array<double, 2> half_empty = {damper.cavitation_pressure - 0.7 * damper.bulk_modulus,
                                            damper.gas_pressure};
  EXPECT_EQ(damper.Force(0, half_empty), damper.Force(0, boiling));
  EXPECT_NEAR(damper.SteadyForce(-1),
              (damper.cavitation_pressure - damper.gas_pressure) * damper.annulus_area - damper.friction,
              16 * kUlp * 1200);
}

// The chamber grows by A_a v and takes in the valves' flow, as dense as where it comes from.
TEST(HydraulicDamper, VapourGoesBeforeThePressureRises) {
  const HydraulicDamper damper = Boiling();
  const double stretch = 0.3;
  const std::array<double, 2> p = {damper.cavitation_pressure - stretch * damper.bulk_modulus, damper.gas_pressure};
  const double inflow = -damper.MassFlow(damper.cavitation_pressure - damper.gas_pressure);
  const double content =
      damper.density * std::exp((p[0] - damper.gas_pressure) / damper.bulk_modulus) * damper.rebound_volume;
  for (const double v : {-0.5, 0.5}) {
    const double rate = inflow / content + damper.annulus_area * v / damper.rebound_volume;
    EXPECT_NEAR(damper.PressureRates(0, v, p)[0] / (rate * damper.bulk_modulus), 1, 16 * kUlp);
  }
}

TEST(HydraulicDamper, IsNanForNanAndWhereAChamberCloses) {
  const HydraulicDamper damper;
  const auto expect_nan = [](const std::array<double, 2>& rates) {
    EXPECT_TRUE(std::isnan(rates[0]));
    EXPECT_TRUE(std::isnan(rates[1]));
  };
  expect_nan(damper.PressureRates(kNan, 0, damper.Rest()));
  expect_nan(damper.PressureRates(0, kNan, damper.Rest()));
  expect_nan(damper.PressureRates(0, 0, {kNan, kNan}));
  expect_nan(damper.PressureRates(0.1, 0, damper.Rest()));
  expect_nan(damper.PressureRates(-0.1, 0, damper.Rest()));
  EXPECT_TRUE(std::isnan(damper.Force(0, {kNan, 2e6})));
  EXPECT_TRUE(std::isnan(damper.Force(kNan, damper.Rest())));
  EXPECT_TRUE(std::isnan(damper.SteadyForce(kNan)));
}

template <typename Change>
void ExpectRefused(Change change, const std::string& message) {
  HydraulicDamper damper;
  change(damper);
  EXPECT_THAT([&] { damper.Validate(); }, ThrowsMessage<std::invalid_argument>(StrEq(message)));
}

TEST(HydraulicDamper, ValidatesItsNumbers) {
  using D = HydraulicDamper;
  const std::string positive = ", must be positive and finite";
  EXPECT_NO_THROW(D{}.Validate());
  ExpectRefused([](D& d) { d.bleed_resistance = 0; }, "HydraulicDamper: bleed_resistance = 0" + positive);
  ExpectRefused([](D& d) { d.bulk_modulus = kNan; }, "HydraulicDamper: bulk_modulus = nan" + positive);
  ExpectRefused([](D& d) { d.gas_exponent = -1; }, "HydraulicDamper: gas_exponent = -1" + positive);
  ExpectRefused([](D& d) { d.friction = -1; }, "HydraulicDamper: friction = -1, must be finite and not negative");
  ExpectRefused([](D& d) { d.annulus_area = 1; },
                "HydraulicDamper: annulus_area = 1, must be positive and at most piston_area");
  ExpectRefused([](D& d) { d.cavitation_pressure = 3e6; },
                "HydraulicDamper: cavitation_pressure = 3e+06, must be positive and below gas_pressure");
}

}  // namespace
}  // namespace fourpost::hydraulic_damper_test
