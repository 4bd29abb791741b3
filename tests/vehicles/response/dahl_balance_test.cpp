// Friction that sticks, in the harmonic balance and in time.
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/reduced_march.h"

namespace fourpost::dahl_balance_test {
namespace {

/// What the march's windows repeat within, and what harmonics and steps leave.
constexpr double kGain_dB = 0.02;
constexpr double kPhase_deg = 0.1;

/// Slides from some 0.3 mm on.
Vehicle RubbingQuarterCar() {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{.force = {60}, .speed = {}, .stiffness = Scalar{2e5}};
  return vehicle;
}

/// Sticks, begins to slide, and slides.
const Excitation kSines{{1.2, 1.2, 3, 12, 12}, {1e-3, 0.02, 2e-3, 2e-4, 4e-3}, {1}};

TEST(DahlBalance, AgreesWithBothMarches) {
  Prepared prepared(RubbingQuarterCar());
  const PeriodicResponse balanced = prepared.Linearised(kSines);
  EXPECT_THAT(balanced.unconverged_Hz, testing::IsEmpty());
  ExpectAgreement(balanced.response, prepared.Marched(kSines, 512), kGain_dB, kPhase_deg);
  const MarchedResponse reduced =
      MarchReduced(prepared.model, RigViewOf(prepared.vehicle), kSines, {.tolerance = 1e-4});
  EXPECT_TRUE(reduced.unsteady.empty());
  ExpectAgreement(balanced.response, reduced.response, kGain_dB, kPhase_deg);
}

TEST(DahlBalance, IsThatOfASpringForSmallMotionAndOfNothingForLarge) {
  Prepared prepared(RubbingQuarterCar());
  const Excitation small{{1.2, 6}, {1e-7, 1e-7}, {1}};
  const Excitation large{{1.2, 6}, {1e3, 1e3}, {1}};
  const auto balance = [&](const CondensedModel& model, const Excitation& excitation) {
    return SolveHarmonicBalance(model, prepared.vehicle.sensors, excitation).response;
  };
  CondensedModel linear = prepared.model;
  linear.liftoffs.clear();
  CondensedModel sliding = linear;
  sliding.rubbings.clear();
  // Of what is lost per stroke, some motion over the length of 0.3 mm in which friction begins to slide.
  ExpectAgreement(balance(linear, small), balance(linear.Stuck(), small), 0.01, 0.1);
  // 60 N of 100 kN.
  ExpectAgreement(balance(linear, large), balance(sliding, large), 0.01, 0.1);
}

// Its kinematics are linear: both balances solve the same equations.
TEST(DahlBalance, OfTheFullSystemIsTheLinearisedOneOfAQuarterCar) {
  Prepared prepared(RubbingQuarterCar());
  const PeriodicResponse full = prepared.Full(kSines);
  EXPECT_THAT(full.unconverged_Hz, testing::IsEmpty());
  ExpectAgreement(full.response, prepared.Linearised(kSines).response, 0.01, 0.06);
}

TEST(DahlBalance, OfTheFullSystemAgreesWithTheMarchOfALinkageCar) {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (Damper& damper : vehicle.dampers)
    damper.law.friction = DashpotDescription::Friction{.force = {300}, .speed = {}, .stiffness = Scalar{1e6}};
  Prepared prepared(vehicle);
  const Excitation excitation{{1.2, 9.45}, {0.03, 0.003}, {1, -1}};
  const PeriodicResponse full = prepared.Full(excitation);
  EXPECT_THAT(full.unconverged_Hz, testing::IsEmpty());
  ExpectAgreement(full.response, prepared.Marched(excitation, 256), kGain_dB, kPhase_deg);
}

// Against central differences of balances with as many harmonics.
TEST(DahlBalance, HasTheDerivativesOfItsDifferences) {
  Vehicle vehicle = RubbingQuarterCar();
  const auto add = [&](const char* name, double value, Scalar& number) {
    Parameter parameter;
    parameter.name = name;
    parameter.value = value;
    parameter.lower = 0.1 * value;
    parameter.upper = 10 * value;
    number = {.value = value, .parameter = static_cast<int>(vehicle.parameters.size()), .factor = 1};
    vehicle.parameters.push_back(parameter);
  };
  add("f_seal", 60, vehicle.dampers[0].law.friction->force);
  add("k_seal", 2e5, *vehicle.dampers[0].law.friction->stiffness);
  const CondensedVehicle condensed(vehicle);
  const std::size_t count = vehicle.parameters.size();
  const std::vector<double> values = vehicle.ParameterValues();
  const Excitation sines{{1.2, 3, 12}, {1e-3, 3e-3, 1e-3}, {1}};
  const std::vector<std::size_t> seals = {count - 2, count - 1};
  const HarmonicBalanceOptions options{.few_harmonics = true, .tolerance = 1e-10, .max_iterations = 200};
  const ResponseSensitivity found = SolveBalanceSensitivity(condensed, values, seals, sines, options);
  for (std::size_t p = 0; p < seals.size(); ++p) {
    const auto at = [&](double share) {
      std::vector<double> moved = values;
      moved[seals[p]] *= 1 + share;
      return SolveHarmonicBalance(condensed.At(moved), vehicle.sensors, sines, options).response;
    };
    constexpr double kShare = 1e-3;
    const FrequencyResponse above = at(kShare);
    const FrequencyResponse below = at(-kShare);
    for (std::size_t c = 0; c < above.channels.size(); ++c)
      for (std::size_t i = 0; i < sines.frequency_Hz.size(); ++i) {
        const std::complex<double> difference =
            (above.channels[c].response[i] - below.channels[c].response[i]) / (2 * kShare * values[seals[p]]);
        const std::complex<double> change = found.by_change[p].channels[c].response[i];
        // Of the differences, the square of their share.
        EXPECT_LT(std::abs(change - difference), 1e-4 * std::abs(difference))
            << vehicle.parameters[seals[p]].name << ", " << above.channels[c].name << ", " << sines.frequency_Hz[i];
      }
  }
}

}  // namespace
}  // namespace fourpost::dahl_balance_test
