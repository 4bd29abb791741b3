#include "vehicles/response/excitation.h"

#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/rounding.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/march.h"

namespace fourpost::excitation_test {
namespace {

using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

auto Refuses(const std::string& message) { return ThrowsMessage<std::invalid_argument>(StrEq(message)); }

TEST(Excitation, OfOneShapePerPostIsGood) {
  EXPECT_NO_THROW((Excitation{{1, 2}, {0.01, 0.02}, {1, -1}}.Validate(2)));
  EXPECT_NO_THROW((Excitation{{}, {}, {1, 0}}.Validate(2)));
}

TEST(Excitation, NeedsAnAmplitudePerFrequency) {
  EXPECT_THAT(([] {
                Excitation{{1, 2}, {0.01}, {1}}.Validate(1);
              }),
              Refuses("Excitation: amplitude_m: needs a value for each of 2 frequencies, has 1"));
}

TEST(Excitation, NeedsAShapePerPost) {
  EXPECT_THAT(([] {
                Excitation{{1}, {0.01}, {1}}.Validate(2);
              }),
              Refuses("Excitation: shape: needs a value for each of 2 posts, has 1"));
}

TEST(Excitation, NeedsPositiveFiniteFrequencies) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity})
    EXPECT_THAT(([&] {
                  Excitation{{1, bad}, {0.01, 0.01}, {1}}.Validate(1);
                }),
                ThrowsMessage<std::invalid_argument>(HasSubstr("Excitation: frequency_Hz[1] = ")));
}

TEST(Excitation, NeedsPositiveFiniteAmplitudes) {
  EXPECT_THAT(([] {
                Excitation{{1}, {0}, {1}}.Validate(1);
              }),
              Refuses("Excitation: amplitude_m[0] = 0, must be positive and finite"));
  for (const double bad : {-0.01, kNan, kInfinity})
    EXPECT_THAT(([&] {
                  Excitation{{1}, {bad}, {1}}.Validate(1);
                }),
                ThrowsMessage<std::invalid_argument>(HasSubstr("Excitation: amplitude_m[0] = ")));
}

TEST(Excitation, NeedsAFiniteShape) {
  EXPECT_THAT(([] {
                Excitation{{1}, {0.01}, {1, kNan}}.Validate(2);
              }),
              ThrowsMessage<std::invalid_argument>(HasSubstr("Excitation: shape[1] = ")));
}

TEST(Excitation, IsCheckedByEveryEngine) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  Multibody multibody(vehicle);
  multibody.SetParameters(vehicle.ParameterValues(), model.preloads);
  const Excitation bad{{1}, {0.01}, {1, 1}};
  const auto refuses = ThrowsMessage<std::invalid_argument>(HasSubstr("Excitation: shape"));
  EXPECT_THAT([&] { SolveHarmonicBalance(model, vehicle.sensors, bad); }, refuses);
  EXPECT_THAT([&] { SolveFullBalance(multibody, model, bad); }, refuses);
  EXPECT_THAT([&] { March(multibody, bad); }, refuses);
}

TEST(Excitation, BalanceNeedsTheModelsSensors) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  vehicle.sensors.push_back(vehicle.sensors.front());
  EXPECT_THAT(([&] {
                SolveHarmonicBalance(model, vehicle.sensors, {{1}, {0.01}, {1}});
              }),
              Refuses("SolveHarmonicBalance: needs a value for each of 6 sensors of the model, has 7"));
}

}  // namespace
}  // namespace fourpost::excitation_test
