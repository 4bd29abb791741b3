// Over a cycle of steady motion the posts put in what dampers, friction and tyres take out; springs, stops, mounts,
// weights and tyres that leave the ground keep nothing.
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/damper_laws.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/linearised_cycle.h"

namespace fourpost::power_balance_test {
namespace {

using Complex = std::complex<double>;

/// Of the load cell under this post.
std::size_t LoadCellOf(const Vehicle& vehicle, std::size_t post) {
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i)
    if (vehicle.sensors[i].type == Sensor::Type::kLoadCell && vehicle.sensors[i].tyre == vehicle.posts[post].tyre)
      return i;
  ADD_FAILURE() << "no load cell under post " << vehicle.posts[post].name;
  return 0;
}

/// Power over a cycle [W].
struct Power {
  double in = 0;
  /// Half of amplitude times amplitude: what `in` would be if all forces had the phase of their posts' velocity.
  double apparent = 0;
};

/// What posts do that move as Re(shape a exp(i w t)) under tyre forces with these first harmonics per amplitude: only
/// these work.
Power PowerOfPosts(const Vehicle& vehicle, const FrequencyResponse& response, const std::vector<double>& shape,
                   std::size_t i) {
  const double omega = 2 * std::numbers::pi * response.frequency_Hz[i];
  const double amplitude = response.amplitude_m[i];
  Power power;
  for (std::size_t p = 0; p < shape.size(); ++p) {
    const Complex force = amplitude * response.channels[LoadCellOf(vehicle, p)].response[i];
    const Complex velocity = Complex(0, omega) * shape[p] * amplitude;
    power.in += 0.5 * (force * std::conj(velocity)).real();
    power.apparent += 0.5 * std::abs(force * velocity);
  }
  return power;
}

/// Harmonics of the rates of signals, in rows.
Eigen::MatrixXcd RatesOf(const Eigen::MatrixXcd& harmonics, double omega) {
  return (Complex(0, omega) *
          Eigen::VectorXd::LinSpaced(harmonics.rows(), 0, static_cast<double>(harmonics.rows() - 1)))
             .asDiagonal() *
         harmonics;
}

/// Mean of law(v) v over a cycle of the rate with these harmonics.
double Dissipated(const DashpotLaw& law, const Eigen::VectorXcd& rate) {
  constexpr int kSamples = 8192;  // Kinks and steps err by some 1e-7 of it.
  double sum = 0;
  for (int k = 0; k < kSamples; ++k) {
    double v = 0;
    for (Eigen::Index h = 0; h < rate.size(); ++h)
      v += (rate[h] * std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(h * k) / kSamples)).real();
    sum += law.Force(v) * v;
  }
  return sum / kSamples;
}

/// Half the sum of conj(a) b over harmonics: the mean of a b, of signals without means.
double MeanProduct(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) { return 0.5 * a.dot(b).real(); }

/// What bushings and tyres' own damping take:  s'' C s' - 2 s' C_post z' + sum c_tyre z'^2.
double LinearDissipation(const Vehicle& vehicle, const CondensedModel& model, const Eigen::MatrixXcd& rates,
                         const Eigen::MatrixXcd& post_rates) {
  double power = 0;
  for (Eigen::Index h = 1; h < rates.rows(); ++h) {
    const Eigen::VectorXcd rate = rates.row(h).transpose();
    power += MeanProduct(rate, model.damping * rate);
  }
  const Eigen::VectorXcd first = rates.row(1).transpose();
  const Eigen::VectorXcd posts = post_rates.row(1).transpose();
  power -= 2 * MeanProduct(first, model.post_damping * posts);
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p) {
    const auto post = static_cast<Eigen::Index>(p);
    const double damping = model.on_post_velocity(static_cast<Eigen::Index>(LoadCellOf(vehicle, p)), post);
    power += 0.5 * damping * std::norm(posts[post]);
  }
  return power;
}

/// By all dampers, from the harmonics of the linearised balance.
double Dissipation(const Prepared& prepared, const std::vector<double>& shape, double frequency_Hz,
                   double amplitude_m) {
  const CondensedModel& model = prepared.model;
  const HarmonicBalanceOptions options;
  LinearisedCycle cycle(model, shape, options, PortsOf(model));
  EXPECT_TRUE(cycle.Solve(frequency_Hz, amplitude_m));
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const Eigen::MatrixXcd rates = RatesOf(cycle.Coordinates(cycle.harmonics()), omega);
  const Eigen::Index n = model.mass.rows();
  Eigen::MatrixXcd posts = Eigen::MatrixXcd::Zero(2, static_cast<Eigen::Index>(shape.size()));
  for (std::size_t p = 0; p < shape.size(); ++p)
    posts(1, static_cast<Eigen::Index>(p)) = Complex(0, omega) * shape[p] * amplitude_m;
  double power = LinearDissipation(prepared.vehicle, model, rates.leftCols(n), posts);
  Eigen::Index series = n;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots) {
    Eigen::VectorXcd rate = rates.leftCols(n) * dashpot.direction;
    if (dashpot.HasSeries()) rate -= rates.col(series++);
    power += Dissipated(dashpot.law, rate);
  }
  return power;
}

// Of the apparent power: HarmonicBalanceOptions::error, 2e-4, of which one and a half may be left, where friction steps
// between samples; the march, whose windows repeat within 1e-4, is no worse.
constexpr double kBalanced = 4e-4;

class PowerOfALaw : public testing::TestWithParam<DamperLaw> {};

TEST_P(PowerOfALaw, IsWhatThePostPutsInByAllEngines) {
  Prepared prepared(QuarterCarWith(GetParam()));
  const Excitation excitation{{1.2, 12}, {0.01, 0.002}, {1}};
  const FrequencyResponse linearised = prepared.Linearised(excitation).response;
  const FrequencyResponse full = prepared.Full(excitation).response;
  const FrequencyResponse marched = prepared.Marched(excitation, 256);
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const double taken = Dissipation(prepared, {1}, excitation.frequency_Hz[i], excitation.amplitude_m[i]);
    EXPECT_GT(taken, 0);
    for (const FrequencyResponse* response : {&linearised, &full, &marched}) {
      const Power power = PowerOfPosts(prepared.vehicle, *response, excitation.shape, i);
      EXPECT_NEAR(power.in, taken, kBalanced * power.apparent) << excitation.frequency_Hz[i] << " Hz";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, PowerOfALaw, testing::ValuesIn(DamperLaws()), testing::PrintToStringParamName());

TEST(Power, OfATyreThatDampsAndLeavesTheGround) {
  Vehicle vehicle = QuarterCarWith({"Bilinear", Rates(800, 2600)});
  vehicle.tyres[0].lifts_off = true;
  const Excitation excitation{{12}, {0.015}, {1}};
  Prepared lifting(vehicle);
  const Power power = PowerOfPosts(vehicle, lifting.Linearised(excitation).response, {1}, 0);
  EXPECT_NEAR(power.in, Dissipation(lifting, {1}, 12, 0.015), kBalanced * power.apparent);
  // Damped, and on the ground.
  vehicle.tyres[0].lifts_off = false;
  vehicle.tyres[0].damping = {800};
  Prepared damped(vehicle);
  const Power of_damped = PowerOfPosts(vehicle, damped.Linearised(excitation).response, {1}, 0);
  EXPECT_NEAR(of_damped.in, Dissipation(damped, {1}, 12, 0.015), kBalanced * of_damped.apparent);
}

// On its curve a tyre keeps nothing either, on the ground or off it.
TEST(Power, OfATyreOnItsCurve) {
  Vehicle vehicle = QuarterCarWith({"Bilinear", Rates(800, 2600)});
  MakeProgressive(vehicle, 20, 0.6);
  const Excitation excitation{{5, 12}, {0.006, 0.015}, {1}};
  const Prepared prepared(vehicle);
  const FrequencyResponse response = prepared.Linearised(excitation).response;
  for (std::size_t i = 0; i < 2; ++i) {
    const Power power = PowerOfPosts(vehicle, response, {1}, i);
    const double taken = Dissipation(prepared, {1}, excitation.frequency_Hz[i], excitation.amplitude_m[i]);
    EXPECT_NEAR(power.in, taken, kBalanced * power.apparent) << excitation.frequency_Hz[i] << " Hz";
  }
}

// Bilinear dampers behind mounts, with friction; bushings; tyres.
TEST(Power, OfShippedVehicles) {
  for (const char* name :
       {"landrover110_linkage", "landrover110_model3", "landrover110_rigid", "landrover110", "independent_roadster"}) {
    const Prepared prepared(ShippedVehicle(name));
    Excitation excitation{{1.3, 3.1, 11}, {0.01, 0.006, 0.001}, PostPattern(prepared.vehicle, "pitch")};
    const FrequencyResponse response = prepared.Linearised(excitation).response;
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
      const double taken =
          Dissipation(prepared, excitation.shape, excitation.frequency_Hz[i], excitation.amplitude_m[i]);
      const Power power = PowerOfPosts(prepared.vehicle, response, excitation.shape, i);
      EXPECT_NEAR(power.in, taken, kBalanced * power.apparent) << name << " at " << excitation.frequency_Hz[i] << " Hz";
    }
  }
}

}  // namespace
}  // namespace fourpost::power_balance_test
