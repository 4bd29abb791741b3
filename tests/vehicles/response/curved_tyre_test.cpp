// Tyres whose rate changes with their load: closed forms of a quarter car, and the engines against each other.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/acceptance.h"
#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/description/gravity.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/reduced_march.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost::curved_tyre_test {
namespace {

using testing::IsEmpty;

constexpr double kProgression = 20;

Vehicle ProgressiveQuarterCar() {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 800);
  Set(vehicle, "c_rebound", 2600);
  MakeProgressive(vehicle, kProgression, 0.6);
  return vehicle;
}

/// Natural frequencies [rad/s] of a quarter car without damping, by the quadratic for their squares.
std::array<double, 2> NaturalFrequencies(double sprung, double unsprung, double k, double tyre) {
  const double sum = k / sprung + (k + tyre) / unsprung;
  const double root = std::sqrt(sum * sum / 4 - k * tyre / (sprung * unsprung));
  // Their product is known; the difference would cancel.
  const double upper = sum / 2 + root;
  return {std::sqrt(k * tyre / (sprung * unsprung) / upper), std::sqrt(upper)};
}

// By the rate under the load: sqrt(k^2 + 4 k q F). Linear dampers of little rate leave moduli of poles.
TEST(CurvedTyre, HasTheNaturalFrequenciesOfItsLoad) {
  std::vector<double> hops;
  for (const double sprung : {150.0, 300.0}) {
    Vehicle vehicle = ProgressiveQuarterCar();
    Set(vehicle, "m_sprung", sprung);
    Set(vehicle, "c_bump", 1e-6);
    Set(vehicle, "c_rebound", 1e-6);
    const double load = (sprung + 22) * kGravity;
    const double k = 0.6 * 230e3;
    const double tyre = std::sqrt(k * k + 4 * k * kProgression * load);
    const auto expected = NaturalFrequencies(sprung, 22, 15e3, tyre);
    const std::vector<Mode> modes = ModesOf(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
    ASSERT_EQ(modes.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(2 * std::numbers::pi * modes[i].frequency_Hz, expected[i], 1e-9 * expected[i]);
    hops.push_back(modes[1].frequency_Hz);
  }
  EXPECT_GT(hops[1], 1.08 * hops[0]);
}

// So slowly that the car stands on its posts: what its tyre reads is its load, and the body follows.
TEST(CurvedTyre, CarriesItsLoadWhereverPostsStand) {
  Prepared car(ProgressiveQuarterCar());
  const FrequencyResponse slow = car.Linearised({{0.01}, {0.05}, {1}}).response;
  for (const ChannelResponse& channel : slow.channels)
    if (channel.name == "z_sprung") {
      EXPECT_NEAR(std::abs(channel.response[0]), 1, 1e-4);
    } else if (channel.name == "F_tyre") {
      // Of the inertia at (2 pi 0.01)^2 times 0.05 m.
      EXPECT_LT(std::abs(channel.response[0]) * 0.05, 0.1);
    }
}

void ExpectAccepted(const FrequencyResponse& response, const FrequencyResponse& reference) {
  const EngineDeviation deviation = DeviationOf(response, reference);
  EXPECT_GT(deviation.channels, 3);
  const auto expect = [](const DeviationAt& of, double accepted, const char* unit) {
    EXPECT_LT(of.value, accepted) << unit << ' ' << of.channel << " at " << of.frequency_Hz << " Hz";
  };
  expect(deviation.gain_dB, kAccepted_dB, "dB");
  expect(deviation.phase_deg, kAccepted_deg, "degrees");
}

/// Means of the load cells, over the largest first harmonic of force.
void ExpectSameMeans(const FrequencyResponse& a, const FrequencyResponse& b) {
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    if (a.channels[c].name.rfind("F_", 0) != 0) continue;
    for (std::size_t i = 0; i < a.frequency_Hz.size(); ++i) {
      const double size = std::abs(b.channels[c].response[i]) * b.amplitude_m[i];
      EXPECT_NEAR(a.channels[c].mean[i], b.channels[c].mean[i], 3e-3 * size) << a.channels[c].name;
    }
  }
}

/// Least reading of a load cell in the steady motion, by Simbody.
double LeastForce(Prepared& prepared, const Excitation& excitation) {
  const auto cell = static_cast<Eigen::Index>(
      std::find_if(prepared.vehicle.sensors.begin(), prepared.vehicle.sensors.end(),
                   [](const Sensor& sensor) { return sensor.type == Sensor::Type::kLoadCell; }) -
      prepared.vehicle.sensors.begin());
  MultibodySystem system(prepared.multibody, 1e-7);
  const double omega = 2 * std::numbers::pi * excitation.frequency_Hz[0];
  double least = 0;
  int samples = 0;
  system.Run(
      [&](double t, std::span<PostState> states) {
        for (std::size_t p = 0; p < states.size(); ++p) {
          const double z = excitation.shape[p] * excitation.amplitude_m[0];
          states[p] = {z * (1 - std::cos(omega * t)), z * omega * std::sin(omega * t),
                       z * omega * omega * std::cos(omega * t)};
        }
      },
      0, 1 / (64 * excitation.frequency_Hz[0]),
      [&](double, const Eigen::VectorXd& y) {
        if (++samples > 64 * 20) least = std::min(least, y[cell]);
      },
      [&] { return samples > 64 * 22; });
  return least;
}

/// In motions on the ground, and in one in which the tyres leave it.
void ExpectEnginesAgree(const Vehicle& vehicle, const Excitation& on_ground, const Excitation& lifting,
                        bool is_linear) {
  Prepared prepared(vehicle);
  EXPECT_NEAR(LeastForce(prepared, lifting), -prepared.model.preloads.tyre[0], 1e-9 * prepared.model.preloads.tyre[0]);
  for (const Excitation& excitation : {on_ground, lifting}) {
    const FrequencyResponse marched = prepared.Marched(excitation, 256);
    const PeriodicResponse full = prepared.Full(excitation);
    EXPECT_THAT(full.unconverged_Hz, IsEmpty());
    ExpectAccepted(full.response, marched);
    ExpectSameMeans(full.response, marched);
    if (!is_linear) continue;
    const PeriodicResponse balance = prepared.Linearised(excitation);
    EXPECT_THAT(balance.unconverged_Hz, IsEmpty());
    ExpectAccepted(balance.response, marched);
    ExpectSameMeans(balance.response, marched);
    const MarchedResponse reduced =
        MarchReduced(prepared.model, RigViewOf(vehicle), excitation, {.tolerance = 1e-4, .samples_per_cycle = 256});
    EXPECT_TRUE(reduced.unsteady.empty());
    ExpectAccepted(reduced.response, marched);
  }
}

TEST(CurvedTyre, EnginesAgreeOnAProgressiveQuarterCar) {
  ExpectEnginesAgree(ProgressiveQuarterCar(), {{1.3, 6, 14}, {0.02, 0.006, 0.003}, {1}}, {{12}, {0.015}, {1}}, true);
}

TEST(CurvedTyre, EnginesAgreeOnAMeasuredQuarterCarWithADampedTyre) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  MeasureTyres(vehicle);
  vehicle.tyres[0].damping = {300};
  ExpectEnginesAgree(vehicle, {{1.3, 6, 14}, {0.02, 0.006, 0.003}, {1}}, {{12}, {0.015}, {1}}, true);
}

// Arms that turn: where tyres hop the linear kinematics are off.
TEST(CurvedTyre, EnginesAgreeOnACarWithArms) {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  MakeProgressive(vehicle, 5, 0.8);
  ExpectEnginesAgree(vehicle, {{9.5}, {0.002}, {1, 1}}, {{9.5}, {0.015}, {1, 1}}, false);
}

// As the rest of a fit that begins at a constant rate: the same answer as that of the linear tyre, on and off the
// ground.
TEST(CurvedTyre, WithoutProgressionIsTheTyreOfAConstantRate) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.tyres[0].damping = {300};
  const Excitation excitation{{1.3, 12}, {0.01, 0.015}, {1}};
  const FrequencyResponse linear = Prepared(vehicle).Linearised(excitation).response;
  MakeProgressive(vehicle, 0);
  const Prepared curved(vehicle);
  ASSERT_EQ(curved.model.curved_tyres.size(), 1U);
  ASSERT_TRUE(curved.model.liftoffs.empty());
  // Both converge to HarmonicBalanceOptions::error, a tenth of what is accepted.
  ExpectAccepted(curved.Linearised(excitation).response, linear);
}

/// Both coefficients of a tyre by Gauss and Newton's method on responses with noise, from a stiffer start of little
/// progression; with their standard deviations.
struct Twin {
  Eigen::Vector2d value;
  Eigen::Vector2d sd;
};

Twin FitTwin(const FrequencyResponse& measured, const Excitation& excitation, double noise) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  MakeProgressive(vehicle, 1);
  const CondensedVehicle condensed(vehicle);
  const std::vector<std::size_t> free = {vehicle.IndexOf("kt").value(), vehicle.IndexOf("q_tyre").value()};
  std::vector<double> values = vehicle.ParameterValues();
  Eigen::Matrix2d normal;
  for (int step = 0; step < 15; ++step) {
    const ResponseSensitivity now = SolveBalanceSensitivity(condensed, values, free, excitation);
    EXPECT_THAT(now.periodic.unconverged_Hz, IsEmpty());
    normal.setZero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t c = 0; c < measured.channels.size(); ++c)
      for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
        const std::complex<double> seen = measured.channels[c].response[i];
        const double weight = 1 / std::norm(noise * std::abs(seen));
        Eigen::Vector2cd slope;
        for (std::size_t p = 0; p < 2; ++p)
          slope[static_cast<Eigen::Index>(p)] = now.by_change[p].channels[c].response[i];
        normal += weight * (slope.conjugate() * slope.transpose()).real();
        right += weight * (slope.conjugate() * (seen - now.periodic.response.channels[c].response[i])).real();
      }
    const Eigen::Vector2d change = normal.llt().solve(right);
    // The first steps from afar are too long.
    const double share = step < 6 ? 0.5 : 1;
    values[free[0]] = std::clamp(values[free[0]] + share * change[0], 100e3, 400e3);
    values[free[1]] = std::clamp(values[free[1]] + share * change[1], 0.0, 30.0);
  }
  const Eigen::Matrix2d covariance = normal.inverse();
  return {{values[free[0]], values[free[1]]}, covariance.diagonal().cwiseSqrt()};
}

// At one load: what tells them apart are motions in which the wheel leaves the post.
TEST(CurvedTyre, TwinFindsBothCoefficients) {
  constexpr double kNoise = 0.01;
  Vehicle truth = ShippedVehicle("quarter_car");
  Set(truth, "kt", 180e3);
  MakeProgressive(truth, 6);
  Excitation excitation{.shape = {1}};
  for (double f = 0.8; f < 20; f *= 1.2) {
    const double w = 2 * std::numbers::pi * f;
    excitation.frequency_Hz.push_back(f);
    excitation.amplitude_m.push_back(std::min({0.04, 1.2 / w, 90 / (w * w)}));
  }
  const FrequencyResponse clean = Prepared(truth).Linearised(excitation).response;
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<> draw(0, kNoise);
    FrequencyResponse measured = clean;
    for (ChannelResponse& channel : measured.channels)
      for (std::complex<double>& response : channel.response)
        response *= 1.0 + std::complex<double>(draw(engine), draw(engine));
    const Twin twin = FitTwin(measured, excitation, kNoise);
    EXPECT_NEAR(twin.value[0], 180e3, 4 * twin.sd[0]);
    EXPECT_NEAR(twin.value[1], 6, 4 * twin.sd[1]);
    EXPECT_LT(twin.sd[0], 0.02 * 180e3);
    EXPECT_LT(twin.sd[1], 0.2 * 6);
    RecordProperty("q_" + std::to_string(seed), std::to_string(twin.value[1]) + " +- " + std::to_string(twin.sd[1]));
  }
}

}  // namespace
}  // namespace fourpost::curved_tyre_test
