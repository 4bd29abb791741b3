#include "vehicles/response/contact_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::contact_cycle_test {
namespace {

Vehicle WithTyres(Vehicle vehicle, bool lift_off) {
  for (Tyre& tyre : vehicle.tyres) tyre.lifts_off = lift_off;
  return vehicle;
}

CondensedModel ModelOf(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

/// In heave.
Excitation Stepped(const Vehicle& vehicle, double amplitude_m) {
  const std::vector<double> frequency_Hz = {1, 1.6, 3, 6, 10, 14, 20};
  return {frequency_Hz, std::vector<double>(frequency_Hz.size(), amplitude_m),
          std::vector<double>(vehicle.posts.size(), 1)};
}

class TyresThatPress : public testing::TestWithParam<const char*> {};

// To the last bit: what lift-off adds is left out, not added up to zero.
TEST_P(TyresThatPress, AnswerAsLinearOnes) {
  const Vehicle lifting = WithTyres(ShippedVehicle(GetParam()), true);
  const Vehicle linear = WithTyres(lifting, false);
  const Excitation excitation = Stepped(lifting, 0.0005);
  std::vector<std::size_t> parameters(lifting.parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i] = i;
  const auto solve = [&](const Vehicle& vehicle) {
    return SolveBalanceSensitivity(CondensedVehicle(vehicle), vehicle.ParameterValues(), parameters, excitation);
  };
  const ResponseSensitivity a = solve(lifting);
  const ResponseSensitivity b = solve(linear);
  for (std::size_t c = 0; c < a.periodic.response.channels.size(); ++c) {
    EXPECT_EQ(a.periodic.response.channels[c].response, b.periodic.response.channels[c].response);
    EXPECT_EQ(a.periodic.response.channels[c].mean, b.periodic.response.channels[c].mean);
    for (std::size_t p = 0; p < parameters.size(); ++p)
      EXPECT_EQ(a.by_change[p].channels[c].response, b.by_change[p].channels[c].response);
  }
}

INSTANTIATE_TEST_SUITE_P(Vehicles, TyresThatPress,
                         testing::Values("quarter_car", "landrover110_model1", "landrover110_model3",
                                         "landrover110_linkage", "single_wheel_station"));

TEST(ContactCycle, IsThatOfAllPortsWhereATyreWouldPull) {
  const Vehicle vehicle = WithTyres(Describe(BilinearCar()), true);
  const CondensedModel model = ModelOf(vehicle);
  const HarmonicBalanceOptions options;
  ContactCycle contact(model, {1}, options);
  LinearisedCycle all(model, {1}, options, PortsOf(model));
  for (const double frequency_Hz : {3.0, 12.0, 12.5, 3.0}) {
    ASSERT_TRUE(contact.Solve(frequency_Hz, 0.015));
    ASSERT_TRUE(all.Solve(frequency_Hz, 0.015));
    EXPECT_EQ(contact.lifts(), frequency_Hz > 10) << frequency_Hz;
    const SensorHarmonics expected = all.Sensors();
    // The iteration's tolerance, from another start.
    EXPECT_LT((contact.cycle().Sensors() - expected).norm(), 1e-4 * expected.norm()) << frequency_Hz;
  }
}

/// Least force of the tyre over a cycle, from its force's harmonics.
double LeastForce(const CondensedModel::Liftoff& tyre, const Eigen::VectorXcd& squeeze, double omega) {
  constexpr int kSamples = 4096;
  double least = tyre.preload;
  for (int k = 0; k < kSamples; ++k) {
    std::complex<double> force = tyre.preload;
    for (Eigen::Index h = 0; h < squeeze.size(); ++h) {
      const double order = static_cast<double>(h);
      force += std::complex<double>(tyre.stiffness, order * omega * tyre.damping) * squeeze[h] *
               std::polar(1.0, 2 * std::numbers::pi * order * k / kSamples);
    }
    least = std::min(least, force.real());
  }
  return least;
}

class ContactOfTyres : public testing::TestWithParam<const char*> {};

// It may doubt a force that nearly vanishes, and must not take a pull for a push.
TEST_P(ContactOfTyres, IsSureOnlyWhereNoTyrePulls) {
  const Vehicle vehicle = WithTyres(ShippedVehicle(GetParam()), true);
  const CondensedModel model = ModelOf(vehicle);
  const std::vector<double> shape(vehicle.posts.size(), 1);
  LinearisedCycle cycle(model, shape, {}, HeldPortsOf(model));
  const TyreContact contact(model.liftoffs, cycle);
  int pressing = 0;
  int pulling = 0;
  for (const double frequency_Hz : {1.2, 2.0, 5.0, 12.0, 16.0})
    for (double amplitude = 0.0005; amplitude < 0.1; amplitude *= 1.1) {
      ASSERT_TRUE(cycle.Solve(frequency_Hz, amplitude));
      const Eigen::MatrixXcd squeezes = contact.Squeezes();
      double share = 1;
      for (std::size_t i = 0; i < model.liftoffs.size(); ++i)
        share =
            std::min(share, LeastForce(model.liftoffs[i], squeezes.col(static_cast<Eigen::Index>(i)), cycle.omega()) /
                                model.liftoffs[i].preload);
      const bool presses = contact.Presses();
      EXPECT_FALSE(share < 0 && presses) << frequency_Hz << " Hz, " << amplitude << " m";
      EXPECT_FALSE(share > 0.1 && !presses) << frequency_Hz << " Hz, " << amplitude << " m";
      ++(share < 0 ? pulling : pressing);
    }
  EXPECT_GT(pressing, 50);
  EXPECT_GT(pulling, 50);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, ContactOfTyres, testing::Values("quarter_car", "landrover110_linkage"));

}  // namespace
}  // namespace fourpost::contact_cycle_test
