#include "vehicles/response/balance_sensitivity.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::balance_sensitivity_test {
namespace {

using Complex = std::complex<double>;

std::vector<std::size_t> AllOf(const Vehicle& vehicle) {
  std::vector<std::size_t> all(vehicle.parameters.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::size_t IndexOf(const Vehicle& vehicle, const std::string& parameter) {
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
    if (vehicle.parameters[i].name == parameter) return i;
  ADD_FAILURE() << "no parameter " << parameter;
  return 0;
}

ResponseSensitivity Sensitivity(const Vehicle& vehicle, const Excitation& excitation,
                                const HarmonicBalanceOptions& options = {}) {
  return SolveBalanceSensitivity(CondensedVehicle(vehicle), vehicle.ParameterValues(), AllOf(vehicle), excitation,
                                 options);
}

/// From 0.8 Hz on, at 50 mm/s.
Excitation Heave(const Vehicle& vehicle) {
  Excitation excitation{.shape = std::vector<double>(vehicle.posts.size(), 1.0)};
  for (double f = 0.8; f < 25; f *= 1.3) {
    excitation.frequency_Hz.push_back(f);
    excitation.amplitude_m.push_back(std::min(0.01, 0.008 / f));
  }
  return excitation;
}

/// Central differences of balances with so many harmonics that what they leave is below the differences' own error.
FrequencyResponse Difference(const Vehicle& vehicle, std::size_t parameter, const Excitation& excitation) {
  const CondensedVehicle condensed(vehicle);
  const HarmonicBalanceOptions fine{.error = 1e-7, .most_harmonics = 600, .tolerance = 1e-10, .max_iterations = 200};
  const auto at = [&](double offset) {
    std::vector<double> values = vehicle.ParameterValues();
    values[parameter] += offset;
    return SolveHarmonicBalance(condensed.At(values), vehicle.sensors, excitation, fine).response;
  };
  const double step = 1e-4 * vehicle.parameters[parameter].value;
  FrequencyResponse change = at(step);
  const FrequencyResponse below = at(-step);
  for (std::size_t c = 0; c < change.channels.size(); ++c)
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
      const auto slope = [&](auto& to, const auto& from) { to = (to - from) / (2 * step); };
      slope(change.channels[c].response[i], below.channels[c].response[i]);
      slope(change.channels[c].mean[i], below.channels[c].mean[i]);
      slope(change.channels[c].second_harmonic[i], below.channels[c].second_harmonic[i]);
    }
  return change;
}

template <typename Value>
double Largest(const std::vector<Value>& values) {
  double largest = 0;
  for (const Value& value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Largest deviation over frequencies of derivatives by a parameter of this value, relative to the largest of them or,
/// where that is next to nothing, to a twentieth of what the channel's own largest value has per parameter: where more
/// than that cancels, the differences know little, too.
template <typename Value>
double DeviationBetween(const std::vector<Value>& derivatives, const std::vector<Value>& expected,
                        const std::vector<Value>& channel, double parameter) {
  double deviation = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    deviation = std::max(deviation, std::abs(derivatives[i] - expected[i]));
  // Of means that are zero: tensions of kilonewtons, over steps of 1e-4.
  constexpr double kRounding = 1e-7;
  if (deviation * parameter < kRounding) return 0;
  return deviation / std::max(Largest(expected), 0.05 * Largest(channel) / parameter);
}

struct Tolerances {
  double response = 0;
  double mean = 0;
  double second_harmonic = 0;
};

/// By all parameters, relative to the largest derivative of each channel.
void ExpectDifferences(const Vehicle& vehicle, const Excitation& excitation, const Tolerances& tolerances,
                       const HarmonicBalanceOptions& options = {}) {
  const ResponseSensitivity sensitivity = Sensitivity(vehicle, excitation, options);
  EXPECT_THAT(sensitivity.periodic.unconverged_Hz, testing::IsEmpty());
  for (std::size_t p = 0; p < vehicle.parameters.size(); ++p) {
    const FrequencyResponse expected = Difference(vehicle, p, excitation);
    for (std::size_t c = 0; c < expected.channels.size(); ++c) {
      SCOPED_TRACE(vehicle.parameters[p].name + " " + expected.channels[c].name);
      const ChannelResponse& given = sensitivity.by_change[p].channels[c];
      const ChannelResponse& difference = expected.channels[c];
      const ChannelResponse& channel = sensitivity.periodic.response.channels[c];
      const double value = vehicle.parameters[p].value;
      EXPECT_LT(DeviationBetween(given.response, difference.response, channel.response, value), tolerances.response);
      EXPECT_LT(DeviationBetween(given.mean, difference.mean, channel.mean, value), tolerances.mean);
      EXPECT_LT(DeviationBetween(given.second_harmonic, difference.second_harmonic, channel.second_harmonic, value),
                tolerances.second_harmonic);
    }
  }
}

/// What the default options reach; second harmonics and means are smaller than what the error is told of.
constexpr Tolerances kDefault{.response = 5e-3, .mean = 2e-2, .second_harmonic = 5e-2};

Vehicle QuarterCar(double bump, double rebound) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", bump);
  Set(vehicle, "c_rebound", rebound);
  return vehicle;
}

/// A damper of equal rates, which one parameter sets.
Vehicle LinearCar() {
  Vehicle vehicle = QuarterCar(1700, 1700);
  vehicle.dampers[0].law = {.compression = {1700, static_cast<int>(IndexOf(vehicle, "c_rebound"))},
                            .rebound = {1700, static_cast<int>(IndexOf(vehicle, "c_rebound"))}};
  return vehicle;
}

// A linear response is analytic: what is left is the differences' own error, the step 1e-4 to the square.
TEST(BalanceSensitivity, OfALinearVehicleHasTheDifferencesOfItsResponse) {
  const Vehicle vehicle = LinearCar();
  ExpectDifferences(vehicle, Heave(vehicle), {.response = 1e-6, .mean = 1e-6, .second_harmonic = 1e-6});
}

TEST(BalanceSensitivity, AParameterThatNothingUsesChangesNothing) {
  const Vehicle vehicle = LinearCar();
  const ResponseSensitivity sensitivity = Sensitivity(vehicle, Heave(vehicle));
  for (const ChannelResponse& channel : sensitivity.by_change[IndexOf(vehicle, "c_bump")].channels) {
    EXPECT_THAT(channel.response, testing::Each(Complex(0, 0)));
    EXPECT_THAT(channel.mean, testing::Each(0.0));
    EXPECT_THAT(channel.second_harmonic, testing::Each(0.0));
  }
}

// A damper of equal rates is no port; with one of them changed it is.
TEST(BalanceSensitivity, TellsBumpFromReboundWhereBothAreEqual) {
  const Vehicle vehicle = QuarterCar(1700, 1700);
  const Excitation excitation = Heave(vehicle);
  const ResponseSensitivity sensitivity = Sensitivity(vehicle, excitation);
  for (const char* name : {"c_bump", "c_rebound"}) {
    const std::size_t p = IndexOf(vehicle, name);
    const FrequencyResponse expected = Difference(vehicle, p, excitation);
    for (std::size_t c = 0; c < expected.channels.size(); ++c) {
      const ChannelResponse& given = sensitivity.by_change[p].channels[c];
      const ChannelResponse& channel = sensitivity.periodic.response.channels[c];
      const double value = vehicle.parameters[p].value;
      EXPECT_LT(DeviationBetween(given.response, expected.channels[c].response, channel.response, value),
                kDefault.response);
      EXPECT_LT(DeviationBetween(given.mean, expected.channels[c].mean, channel.mean, value), kDefault.mean);
    }
  }
}

TEST(BalanceSensitivity, GivesTheResponseOfTheBalance) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const Excitation excitation = Heave(vehicle);
  const PeriodicResponse alone =
      SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()), vehicle.sensors, excitation);
  const FrequencyResponse with = Sensitivity(vehicle, excitation).periodic.response;
  for (std::size_t c = 0; c < with.channels.size(); ++c) {
    EXPECT_EQ(with.channels[c].response, alone.response.channels[c].response);
    EXPECT_EQ(with.channels[c].mean, alone.response.channels[c].mean);
    EXPECT_EQ(with.channels[c].second_harmonic, alone.response.channels[c].second_harmonic);
  }
}

TEST(BalanceSensitivity, HasTheDifferencesOfTheLandRover) {
  for (const char* name : {"landrover110_model1", "landrover110_linkage"}) {
    SCOPED_TRACE(name);
    const Vehicle vehicle = ShippedVehicle(name);
    ExpectDifferences(vehicle, Heave(vehicle), kDefault);
  }
}

/// A quarter car with an element of its own kind.
struct ElementCase {
  const char* name;
  std::function<void(Vehicle&)> alter;
  Excitation excitation = {{1.2, 5}, {0.01, 0.004}, {1}};
};

std::ostream& operator<<(std::ostream& out, const ElementCase& element) { return out << element.name; }

class BalanceSensitivityOfAnElement : public testing::TestWithParam<ElementCase> {};

TEST_P(BalanceSensitivityOfAnElement, HasTheDifferences) {
  Vehicle vehicle = QuarterCar(800, 2600);
  GetParam().alter(vehicle);
  // By a twentieth of the default error. Of second harmonics in series with a spring, whose own harmonics fall slowly,
  // the differences know no more: with steps of 1e-3 they change by as much.
  ExpectDifferences(vehicle, GetParam().excitation, {.response = 2e-3, .mean = 6e-3, .second_harmonic = 4e-2},
                    {.error = 1e-5, .tolerance = 1e-6});
}

Scalar By(const Vehicle& vehicle, const std::string& parameter, double factor) {
  return {.parameter = static_cast<int>(IndexOf(vehicle, parameter)), .factor = factor};
}

/// Rates and speeds of the knees go with the parameters, too.
void MakeDigressive(Vehicle& vehicle) {
  vehicle.dampers[0].law = {.kind = DashpotDescription::Kind::kDigressive,
                            .compression = By(vehicle, "c_bump", 1),
                            .rebound = By(vehicle, "c_rebound", 1),
                            .compression_knee = {By(vehicle, "c_bump", 1e-4), By(vehicle, "c_bump", 0.3)},
                            .rebound_knee = {By(vehicle, "c_rebound", 3e-5), By(vehicle, "c_rebound", 0.3)}};
}

void PutInSeries(Vehicle& vehicle) {
  vehicle.dampers[0].series = SpringDescription{.stiffness = By(vehicle, "c_rebound", 60)};
}

void AddBumpStop(Vehicle& vehicle) {
  vehicle.springs[0].law.knees.push_back(
      {.side = -1, .at = By(vehicle, "c_bump", 0.01 / 800), .rate = By(vehicle, "c_rebound", 50), .cubic = {}});
}

void MeasureSpring(Vehicle& vehicle) {
  vehicle.springs[0].law = {.stiffness = {},
                            .cubic = {},
                            .knees = {},
                            .table = {{{-0.05}, By(vehicle, "k", -0.06)},
                                      {{-0.01}, By(vehicle, "k", -0.008)},
                                      {{0.02}, By(vehicle, "k", 0.014)},
                                      {{0.06}, By(vehicle, "k", 0.09)}},
                            .place = By(vehicle, "c_bump", 0.005 / 800)};
}

/// Rates at rest and speeds go with the parameters.
void MakeSaturating(Vehicle& vehicle) {
  vehicle.dampers[0].law = {.kind = DashpotDescription::Kind::kSaturating,
                            .compression = By(vehicle, "c_bump", 2),
                            .rebound = By(vehicle, "c_rebound", 1.5),
                            .compression_knee = {By(vehicle, "c_bump", 2e-4), {}},
                            .rebound_knee = {By(vehicle, "c_rebound", 1e-4), {}}};
}

void LetTyreLift(Vehicle& vehicle) { vehicle.tyres[0].lifts_off = true; }

INSTANTIATE_TEST_SUITE_P(Elements, BalanceSensitivityOfAnElement,
                         testing::Values(ElementCase{"Bilinear", [](Vehicle&) {}},
                                         ElementCase{"Digressive", MakeDigressive}, ElementCase{"Series", PutInSeries},
                                         ElementCase{"DigressiveInSeries",
                                                     [](Vehicle& vehicle) {
                                                       MakeDigressive(vehicle);
                                                       PutInSeries(vehicle);
                                                     }},
                                         ElementCase{"Saturating", MakeSaturating},
                                         ElementCase{"MeasuredSpring", MeasureSpring, {{1.2}, {0.02}, {1}}},
                                         ElementCase{"BumpStop", AddBumpStop, {{1.2}, {0.02}, {1}}},
                                         ElementCase{"Liftoff", LetTyreLift, {{12}, {0.015}, {1}}},
                                         ElementCase{"ProgressiveTyre",
                                                     [](Vehicle& vehicle) { MakeProgressive(vehicle, 20, 0.6); },
                                                     {{1.2, 5, 14}, {0.01, 0.004, 0.003}, {1}}},
                                         ElementCase{"MeasuredTyre", MeasureTyres, {{1.2, 12}, {0.01, 0.004}, {1}}},
                                         ElementCase{"ProgressiveTyreThatLiftsOff",
                                                     [](Vehicle& vehicle) {
                                                       MakeProgressive(vehicle, 20, 0.6);
                                                       vehicle.tyres[0].damping = By(vehicle, "q_tyre", 15);
                                                     },
                                                     {{12}, {0.015}, {1}}}),
                         testing::PrintToStringParamName());

TEST(BalanceSensitivity, TellsWhereTheBalanceDidNotConverge) {
  const Vehicle vehicle = QuarterCar(800, 2600);
  const ResponseSensitivity sensitivity =
      Sensitivity(vehicle, {{1.2}, {0.01}, {1}}, {.error = 1e-9, .most_harmonics = 9});
  EXPECT_THAT(sensitivity.periodic.unconverged_Hz, testing::ElementsAre(1.2));
}

TEST(BalanceSensitivity, RefusesAParameterThatIsNone) {
  const Vehicle vehicle = QuarterCar(800, 2600);
  EXPECT_THROW(SolveBalanceSensitivity(CondensedVehicle(vehicle), vehicle.ParameterValues(),
                                       {vehicle.parameters.size()}, {{1.2}, {0.01}, {1}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::balance_sensitivity_test
