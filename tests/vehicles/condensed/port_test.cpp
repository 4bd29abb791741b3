#include "vehicles/condensed/port.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::port_test {
namespace {

double RemainderAt(const PortLaw& law, double x, double v) {
  double remainder = 0;
  Remainders(law, {&x, 1}, {&v, 1}, {&remainder, 1});
  return remainder;
}

void ExpectSlopesOfItsRemainder(const PortLaw& law) {
  // Central differences over 1e-6 of kinked, else smooth laws; points keep off the kinks.
  constexpr double kStep = 1e-6;
  for (const double x : {-0.031, -0.012, 0.003, 0.017})
    for (const double v : {-0.7, -0.08, 0.03, 0.4}) {
      double by_extension = 0;
      double by_rate = 0;
      RemainderSlopes(law, {&x, 1}, {&v, 1}, {&by_extension, 1}, {&by_rate, 1});
      const double in_x = (RemainderAt(law, x + kStep, v) - RemainderAt(law, x - kStep, v)) / (2 * kStep);
      const double in_v = (RemainderAt(law, x, v + kStep) - RemainderAt(law, x, v - kStep)) / (2 * kStep);
      EXPECT_NEAR(by_extension, in_x, 1e-3 + 1e-6 * std::abs(in_x)) << x << " m, " << v << " m/s";
      EXPECT_NEAR(by_rate, in_v, 1e-3 + 1e-6 * std::abs(in_v)) << x << " m, " << v << " m/s";
    }
}

const LiftoffRemainder kTyre{.preload = 3000, .stiffness = 2e5, .damping = 500};

/// Under 3 kN, its linear share that at rest.
TyreRemainder CurvedTyre(double damping) {
  const LoadedTyre law = TyreLaw{.stiffness = 150e3, .progression = 5}.Under(3000);
  return {law, damping, law.Rate(0)};
}

TEST(Port, RemaindersHaveTheirSlopes) {
  ExpectSlopesOfItsRemainder(DashpotRemainder{DashpotLaw(800, 2600).WithFriction(50, 0.01), 1700});
  SpringLaw spring{.stiffness = 2e4, .cubic = 1e7, .knees = {}};
  spring.knees.push_back({.at = -0.02, .side = -1, .stiffness = 1e5, .cubic = 1e8});
  ExpectSlopesOfItsRemainder(SpringRemainder{spring, 2e4});
  ExpectSlopesOfItsRemainder(kTyre);
  ExpectSlopesOfItsRemainder(CurvedTyre(500));
}

TEST(Port, ALiftedTyreLosesItsPull) {
  EXPECT_EQ(RemainderAt(kTyre, -0.01, 0), 0);             // 3000 - 2000 N of compression
  EXPECT_DOUBLE_EQ(RemainderAt(kTyre, -0.02, 0), 1000);   // 3000 - 4000 N
  EXPECT_DOUBLE_EQ(RemainderAt(kTyre, -0.01, -4), 1000);  // 3000 - 2000 - 2000 N
}

// Of all its force, less the linear share.
TEST(Port, ATyreOnItsCurveIsOnTheGroundOrGivesNothing) {
  const TyreRemainder tyre = CurvedTyre(500);
  const auto force = [&](double x, double v) {
    return RemainderAt(tyre, x, v) + 3000 + tyre.stiffness * x + tyre.damping * v;
  };
  EXPECT_EQ(RemainderAt(tyre, 0, 0), 0);
  const double d = tyre.law.place + 0.01;
  EXPECT_NEAR(force(0.01, 0.2), 150e3 * d * (1 + 5 * d) + 500 * 0.2, 1e-11);
  EXPECT_NEAR(force(-0.03, 0.2), 0, 1e-11);
  EXPECT_EQ(KinksOf(tyre).size(), 1U);
}

TEST(Port, SpeedsOfStepsAreThoseOfFriction) {
  EXPECT_EQ(StepOfRate(DashpotRemainder{DashpotLaw(800, 2600).WithFriction(50, 0.01), 1700}), 0.01);
  EXPECT_EQ(StepOfRate(DashpotRemainder{DashpotLaw::Smooth(800, 2600, 0.05), 1700}), 0.05);
  EXPECT_TRUE(std::isinf(StepOfRate(DashpotRemainder{DashpotLaw(800, 2600), 1700})));
  EXPECT_TRUE(std::isinf(StepOfRate(kTyre)));
}

/// Largest error of the mean of slope by rate times a smooth signal, of a bilinear law over a cycle of its rate, for
/// any place of the kink between two samples.
double ErrorOfMendedSlopes(int samples) {
  const DashpotRemainder port{DashpotLaw(800, 2600), 1700};
  const auto mean = [&](int count, double phase) {
    std::vector<double> v;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * k / count + phase;
      v.push_back(std::sin(angle) + 0.3 * std::cos(2 * angle));
    }
    std::vector<double> by_extension(v.size());
    std::vector<double> by_rate(v.size());
    MendedSlopes(port, KinksOf(port), {}, v, by_extension, by_rate);
    double sum = 0;
    for (int k = 0; k < count; ++k)
      sum += by_rate[static_cast<std::size_t>(k)] * std::cos(2 * std::numbers::pi * k / count + phase + 1);
    return sum / count;
  };
  double largest = 0;
  for (int i = 1; i < 10; ++i) {
    const double phase = 2 * std::numbers::pi / samples * i / 10;
    largest = std::max(largest, std::abs(mean(samples, phase) - mean(64 * samples, phase)));
  }
  return largest / 900;
}

// Third order: an eighth for twice the samples. Plain samples leave up to 1 / 40 with 40.
TEST(Port, MendedSlopesIntegrateAJumpToThirdOrder) {
  EXPECT_LT(ErrorOfMendedSlopes(40), 1e-3);
  EXPECT_LT(ErrorOfMendedSlopes(160), ErrorOfMendedSlopes(40) / 48);
}

/// Force of a bilinear dashpot, 800 and 2600 N s/m, at evenly spaced samples of one cycle of the rate cos(w t + phase),
/// as the balance samples it: linear share and mended remainder.
std::vector<double> ForceUnderASine(std::size_t samples, double phase) {
  const DashpotLaw law(800, 2600);
  const DashpotRemainder remainder{law, 1400};
  std::vector<double> rate(samples);
  for (std::size_t k = 0; k < samples; ++k)
    rate[k] = std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(samples) + phase);
  std::vector<double> force(samples);
  MendedRemainders(remainder, KinksOf(remainder), {}, rate, force);
  for (std::size_t k = 0; k < samples; ++k) force[k] += remainder.rate * rate[k];
  return force;
}

/// Force of a tyre under the deflection mean + amplitude cos(w t + phase), as the balance samples it.
std::vector<double> TyreForceUnderASine(const TyreRemainder& tyre, double mean, double amplitude, std::size_t samples,
                                        double phase) {
  std::vector<double> x(samples);
  std::vector<double> v(samples);
  for (std::size_t k = 0; k < samples; ++k)
    x[k] = mean +
           amplitude * std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(samples) + phase);
  std::vector<double> force(samples);
  MendedRemainders(tyre, KinksOf(tyre), x, v, force);
  for (std::size_t k = 0; k < samples; ++k) force[k] += tyre.law.load + tyre.stiffness * x[k];
  return force;
}

/// Harmonic h of y = Re sum Y_h exp(i h w t) from its samples.
std::complex<double> Harmonic(const std::vector<double>& samples, int h) {
  std::complex<double> sum;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k)
    sum += samples[k] * std::polar(1.0, -2 * std::numbers::pi * h * static_cast<double>(k) / count);
  return sum * (h == 0 ? 1.0 : 2.0) / count;
}

constexpr double kPhases[] = {0, 0.02, 0.1, 0.7, 1.5707, 2.9};

// On the ground, F = k d (1 + q d) at d = d0 + a cos: mean F(d0) + k q a^2 / 2, k a (1 + 2 q d0), k q a^2 / 2.
TEST(Port, AProgressiveTyreUnderASineHasItsDescribingFunction) {
  const TyreRemainder tyre = CurvedTyre(0);
  constexpr double a = 0.006;
  const double d0 = tyre.law.place + 0.001;
  for (const double phase : kPhases) {
    const std::vector<double> force = TyreForceUnderASine(tyre, 0.001, a, 24, phase);
    EXPECT_NEAR(Harmonic(force, 0).real(), 150e3 * (d0 * (1 + 5 * d0) + 5 * a * a / 2), 1e-10);  // rounding
    EXPECT_LT(std::abs(Harmonic(force, 1) - std::polar(150e3 * a * (1 + 10 * d0), phase)), 1e-10);
    EXPECT_LT(std::abs(Harmonic(force, 2) - std::polar(150e3 * 5 * a * a / 2, 2 * phase)), 1e-10);
  }
}

// On the ground while cos > -d0 / a, that is for angles up to s; in the air for the rest. Integrals of F and F cos over
// -s .. s.
TEST(Port, AProgressiveTyreThatLiftsOffHasItsDescribingFunction) {
  const TyreRemainder tyre = CurvedTyre(0);
  constexpr double a = 0.03;
  const double d0 = tyre.law.place;
  const double s = std::acos(-d0 / a);
  const double c1 = std::sin(s);
  const double c2 = s / 2 + std::sin(2 * s) / 4;
  const double c3 = std::sin(s) - std::pow(std::sin(s), 3) / 3;
  const double one = 150e3 * d0 * (1 + 5 * d0);
  const double two = 150e3 * a * (1 + 10 * d0);
  const double three = 150e3 * 5 * a * a;
  const double mean = (one * s + two * c1 + three * c2) / std::numbers::pi;
  const double first = 2 / std::numbers::pi * (one * c1 + two * c2 + three * c3);
  const auto error = [&](std::size_t samples) {
    double largest = 0;
    for (const double phase : kPhases) {
      const std::vector<double> force = TyreForceUnderASine(tyre, 0, a, samples, phase);
      largest = std::max(largest, std::abs(Harmonic(force, 0).real() - mean) / mean);
      largest = std::max(largest, std::abs(Harmonic(force, 1) - std::polar(first, phase)) / first);
    }
    return largest;
  };
  // Mended kinks leave the third order of the spacing, plain samples 3e-3 with 40.
  EXPECT_LT(error(40), 3e-4);
  EXPECT_LT(error(160), error(40) / 48);
}

// (rebound + compression) / 2, whatever the samples: the rest of the force is even, alike in both halves of a cycle.
TEST(Port, ABilinearDashpotUnderASineHasTheMeanOfItsRatesExactly) {
  for (const std::size_t samples : {24u, 40u, 72u})
    for (const double phase : kPhases) {
      const std::complex<double> rate = Harmonic(ForceUnderASine(samples, phase), 1) / std::polar(1.0, phase);
      EXPECT_NEAR(rate.real(), 1700, 1e-11);  // rounding
      EXPECT_NEAR(rate.imag(), 0, 1e-11) << samples << " samples, phase " << phase;
    }
}

// (rebound - compression) / pi times the amplitude of the rate; mended kinks leave the fourth order of the spacing.
TEST(Port, ABilinearDashpotUnderASineHasItsMeanForce) {
  const auto error = [](std::size_t samples) {
    double largest = 0;
    for (const double phase : kPhases)
      largest = std::max(largest, std::abs(Harmonic(ForceUnderASine(samples, phase), 0) - 1800 / std::numbers::pi));
    return largest;
  };
  EXPECT_LT(error(24), 1e-4 * 1800 / std::numbers::pi);
  EXPECT_LT(error(96), error(24) / 100);
  EXPECT_LT(error(1536), 1e-11 * 1800);  // 64 to the fourth
}

/// Laminar valves, alike both ways: linear but for the gas and the lengths of the columns.
const HydraulicRemainder kLaminar = [] {
  const MountedHydraulicDamper law{
      .damper = {.bleed_resistance = 1e12, .compression_valve_resistance = 1e7, .friction = 0}, .mount = {}};
  return HydraulicRemainder{law, HydraulicOil(law).Linear()};
}();

// Of a small motion the linear share is all: what is left goes by the motion to the square.
TEST(Port, ASmallMotionLeavesAHydraulicDamperItsLinearShare) {
  constexpr int kSamples = 2048;
  constexpr double kFrequency_Hz = 20;
  constexpr double kAmplitude = 1e-6;  // m
  const double w = 2 * std::numbers::pi * kFrequency_Hz;
  std::vector<double> x;
  std::vector<double> v;
  std::vector<double> remainder(kSamples);
  for (int k = 0; k < kSamples; ++k) {
    const double angle = 2 * std::numbers::pi * k / kSamples;
    x.push_back(kAmplitude * std::cos(angle));
    v.push_back(-kAmplitude * w * std::sin(angle));
  }
  CycleRemainders(kLaminar, 1 / kFrequency_Hz, x, v, remainder);
  const std::complex<double> share = LaggingShare(kLaminar, w) * kAmplitude;
  // The steps' error, (2 pi / 2048)^2 / 3.
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kSamples;
    EXPECT_NEAR(remainder[k], (share * std::polar(1.0, angle)).real(), 1e-5 * std::abs(share));
  }
}

TEST(Port, AHydraulicDamperHasTheChangesOfItsCycle) {
  const int samples = 64;
  Eigen::VectorXd x(samples);
  Eigen::VectorXd v(samples);
  Eigen::MatrixXd dx(samples, 1);
  Eigen::MatrixXd dv(samples, 1);
  for (int k = 0; k < samples; ++k) {
    const double angle = 2 * std::numbers::pi * k / samples;
    x[k] = 0.01 * std::cos(angle);
    v[k] = -0.01 * 2 * std::numbers::pi * std::sin(angle);
    dx(k, 0) = 1e-6 * std::sin(2 * angle);
    dv(k, 0) = 1e-6 * 4 * std::numbers::pi * std::cos(2 * angle);
  }
  const auto remainders = [&](const Eigen::VectorXd& extension, const Eigen::VectorXd& rate) {
    Eigen::VectorXd out(samples);
    CycleRemainders(kLaminar, 1, {extension.data(), 64}, {rate.data(), 64}, {out.data(), 64});
    return out;
  };
  Eigen::MatrixXd changes;
  CycleChanges(kLaminar, 1, {x.data(), 64}, {v.data(), 64}, dx, dv, changes);
  const Eigen::VectorXd expected = 0.5 * (remainders(x + dx, v + dv) - remainders(x - dx, v - dv));
  // 1e-6 of columns of 0.1 m.
  EXPECT_LT((changes - expected).cwiseAbs().maxCoeff(), 1e-4 * expected.cwiseAbs().maxCoeff());
}

TEST(Port, HasNoRemainderWhereAHydraulicDampersChamberCloses) {
  const std::vector<double> x(8, 0.12);
  const std::vector<double> v(8, 0.0);
  std::vector<double> remainder(8);
  CycleRemainders(kLaminar, 1, x, v, remainder);
  for (const double at : remainder) EXPECT_TRUE(std::isnan(at));
  EXPECT_TRUE(std::isnan(RemainderAt(kLaminar, 0, 0)));
}

CondensedModel ModelOf(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

TEST(Port, ALinearVehicleHasOnlyThoseOfTyresThatLiftOff) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  EXPECT_EQ(PortsOf(ModelOf(vehicle)).size(), 1u);
  EXPECT_TRUE(HeldPortsOf(ModelOf(vehicle)).empty());
  vehicle.tyres[0].lifts_off = false;
  EXPECT_TRUE(PortsOf(ModelOf(vehicle)).empty());
}

TEST(Port, EveryElementThatIsNotLinearHasOne) {
  Vehicle vehicle = ElementCar();
  for (Tyre& tyre : vehicle.tyres) tyre.lifts_off = true;
  const CondensedModel model = ModelOf(vehicle);
  const std::vector<Port> ports = PortsOf(model);
  std::array<std::size_t, 6> count{};
  for (const Port& port : ports) {
    ++count[port.law.index()];
    EXPECT_GT(port.direction.norm(), 0);
    if (port.liftoff < 0) {
      // Those of tyres come last.
      EXPECT_EQ(count[2], 0u);
      continue;
    }
    EXPECT_EQ(port.post, model.liftoffs[static_cast<std::size_t>(port.liftoff)].post);
  }
  std::size_t dashpots = 0;
  std::size_t series = 0;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots) {
    dashpots += dashpot.law.LeastRate() < dashpot.law.GreatestRate() ? 1 : 0;
    series += dashpot.HasSeries() && !dashpot.series.IsLinear() ? 1 : 0;
  }
  EXPECT_EQ(count[0], dashpots);
  EXPECT_EQ(count[1], model.stiffenings.size() + series);
  EXPECT_EQ(count[2], model.liftoffs.size());
  EXPECT_EQ(count[3], 2U);
  EXPECT_GT(series, 0U);
  EXPECT_EQ(model.liftoffs.size(), vehicle.tyres.size());
}

}  // namespace
}  // namespace fourpost::port_test
