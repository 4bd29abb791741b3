#include "vehicles/condensed/linear_response.h"

#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/quarter_cars.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::linear_response_test {
namespace {

TEST(LinearResponse, OfTheQuarterCarIsTheClosedForm) {
  const Vehicle vehicle = Describe(BilinearCar());
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  for (const double frequency : {0.5, 1.3, 4.0, 14.0, 30.0}) {
    const Eigen::MatrixXcd response = LinearResponse(model, frequency);
    const auto expected = BilinearCar().Response(frequency);
    for (Eigen::Index i = 0; i < response.rows(); ++i) {
      const std::string& name = vehicle.sensors[static_cast<std::size_t>(i)].name;
      if (name != "z_sprung" && name != "z_unsprung") continue;
      // Rounding of a difference.
      EXPECT_LT(std::abs(response(i, 0) - expected[name == "z_sprung" ? 0 : 1]), 1e-9) << name;
    }
  }
}

// With linear elements harmonic balance is exact; this car has series springs and all kinds of sensors.
TEST(LinearResponse, IsTheHarmonicBalanceOfLinearElements) {
  Vehicle vehicle = ElementCar();
  const CondensedModel bent = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  CondensedModel model = bent;
  for (CondensedModel::Dashpot& dashpot : model.dashpots) {
    dashpot.law = DashpotLaw(dashpot.law.MeanRate(), dashpot.law.MeanRate());
    dashpot.series.cubic = 0;
  }
  model.stiffenings.clear();
  model.liftoffs.clear();
  model.hydraulics.clear();
  Excitation excitation{.frequency_Hz = {0.7, 3, 11, 25}, .amplitude_m = {1, 1, 1, 1}, .shape = {}};
  for (std::size_t post = 0; post < vehicle.posts.size(); ++post) {
    excitation.shape.assign(vehicle.posts.size(), 0.0);
    excitation.shape[post] = 1;
    const FrequencyResponse balance = SolveHarmonicBalance(model, vehicle.sensors, excitation).response;
    for (std::size_t f = 0; f < excitation.frequency_Hz.size(); ++f) {
      const Eigen::MatrixXcd response = LinearResponse(bent, excitation.frequency_Hz[f]);
      for (std::size_t i = 0; i < vehicle.sensors.size(); ++i) {
        const double omega = 2 * std::numbers::pi * excitation.frequency_Hz[f];
        const bool accelerates = vehicle.sensors[i].type == Sensor::Type::kAccelerometer;
        const std::complex<double> expected = balance.channels[i].response[f] * (accelerates ? -omega * omega : 1);
        const std::complex<double> value = response(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(post));
        EXPECT_LT(std::abs(value - expected), 1e-9 * std::abs(expected)) << vehicle.sensors[i].name;  // rounding
      }
    }
  }
}

}  // namespace
}  // namespace fourpost::linear_response_test
