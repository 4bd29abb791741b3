#include "identify/experiments/four_post/modelled_response.h"

#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/hysteresis.h"
#include "vehicles/response/march.h"
#include "vehicles/simulation/condensed_system.h"

namespace fourpost::modelled_response_test {
namespace {

Vehicle Station(const std::string& model) {
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicle(
      std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/single_wheel_station" / (model + ".urdf"), diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return *std::move(vehicle);
}

CondensedModel Model(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

TEST(ModelledResponse, TakesFrictionAloneInLineWithASpringForHysteresis) {
  EXPECT_TRUE(HasHysteresis(Model(Station("model4"))));
  EXPECT_FALSE(HasHysteresis(Model(Station("model4_frequency"))));
  EXPECT_FALSE(HasHysteresis(Model(Station("model3"))));
  // Dampers with friction behind mounts.
  EXPECT_FALSE(HasHysteresis(Model(ShippedVehicle("landrover110"))));
  EXPECT_FALSE(HasHysteresis(Model(ShippedVehicle("independent_roadster"))));
}

// Against a march of a fifth of the step to a hundredth of the tolerance.
TEST(ModelledResponse, MarchesHysteresis) {
  const Vehicle vehicle = Station("model4");
  const CondensedModel model = Model(vehicle);
  const Excitation excitation{.frequency_Hz = {3, 12}, .amplitude_m = {0.008, 0.002}, .shape = {1}};
  const PeriodicResponse marched = ModelledResponse(model, vehicle.sensors, excitation);
  EXPECT_TRUE(marched.unconverged_Hz.empty());
  CondensedSystem finer(model, RigViewOf(vehicle), 5e-5);
  const MarchedResponse reference = March(finer, excitation, {.tolerance = 1e-6, .samples_per_cycle = 256});
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const std::complex<double> expected = reference.response.channels[i].response[k];
      EXPECT_LT(std::abs(marched.response.channels[i].response[k] - expected), 1e-3 * std::abs(expected))
          << vehicle.sensors[i].name;
    }
}

}  // namespace
}  // namespace fourpost::modelled_response_test
