#include "vehicles/response/harmonic_balance.h"

#include <algorithm>
#include <complex>
#include <utility>

#include <gmock/gmock.h>

#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/linearised_cycle.h"

namespace fourpost::harmonic_balance_test {
namespace {

using Complex = std::complex<double>;

/// About the values that fit the recordings.
Vehicle IdentifiedCar() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const std::vector<std::pair<std::string, double>> values = {
      {"m_sprung", 1803},     {"I_pitch", 2485},         {"m_front", 154},      {"m_rear", 178},
      {"k_front", 61.3e3},    {"k_rear", 76.5e3},        {"kt_front", 372e3},   {"kt_rear", 396e3},
      {"c_front_bump", 1822}, {"c_front_rebound", 4101}, {"c_rear_bump", 2123}, {"c_rear_rebound", 4646}};
  for (const auto& [name, value] : values) Set(vehicle, name, value);
  return vehicle;
}

Excitation Bounce() { return RecordedExcitation("bounce_frf.csv", {1, 1}); }
Excitation Pitch() { return RecordedExcitation("pitch_frf.csv", {1, -1}); }

FrequencyResponse Balanced(const Prepared& prepared, const Excitation& excitation) {
  const PeriodicResponse balanced = prepared.Linearised(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, testing::IsEmpty());
  return balanced.response;
}

// The identified car keeps what is promised, with 0.022 dB and 0.16 degrees; linear kinematics leave most of that.
TEST(HarmonicBalance, KeepsItsPromiseAtAllFrequenciesOfTheRecordings) {
  Prepared prepared(IdentifiedCar());
  for (const Excitation& excitation : {Bounce(), Pitch()})
    ExpectAgreement(Balanced(prepared, excitation), prepared.Reference(excitation));
}

// At the shipped file's values a_cg has a node at 8.2 to 10.6 Hz in pitch. There the reference has next to nothing, of
// which linear kinematics leave 0.071 dB and 0.35 degrees. The full balance keeps the promise.
TEST(HarmonicBalance, LeavesMoreThanPromisedOnlyNearANodeWhereTheFullBalanceDoesNot) {
  Prepared prepared(ShippedVehicle("landrover110_linkage"));
  ExpectAgreement(Balanced(prepared, Bounce()), prepared.Reference(Bounce()));
  const FrequencyResponse reference = prepared.Reference(Pitch());
  const FrequencyResponse balanced = Balanced(prepared, Pitch());
  ExpectAgreement(balanced, reference, 0.075, 0.36);
  for (std::size_t c = 0; c < balanced.channels.size(); ++c) {
    if (balanced.channels[c].name == "a_cg") continue;
    EXPECT_LT(LargestDeviation(balanced.channels[c], reference.channels[c]).gain_dB, kPromised_dB);
    EXPECT_LT(LargestDeviation(balanced.channels[c], reference.channels[c]).phase_deg, kPromised_deg);
  }
  ExpectAgreement(prepared.Full(Pitch()).response, reference);
}

/// The quarter car at 1.2 Hz with these damper rates.
FrequencyResponse QuarterCarResponse(double bump, double rebound, double amplitude_m,
                                     const HarmonicBalanceOptions& options = {}) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", bump);
  Set(vehicle, "c_rebound", rebound);
  return SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()), vehicle.sensors,
                              {{1.2}, {amplitude_m}, {1}}, options)
      .response;
}

// A bilinear dashpot is homogeneous: specification 5.1.
TEST(HarmonicBalance, ResponseOfABilinearDamperDoesNotDependOnAmplitude) {
  const Complex small = QuarterCarResponse(800, 2600, 0.001).Find("a_sprung")->response[0];
  const Complex large = QuarterCarResponse(800, 2600, 0.020).Find("a_sprung")->response[0];
  EXPECT_LT(std::abs(small / large - 1.0), 1e-12);  // rounding
}

// Only even harmonics and the mean change sign when bump and rebound change places.
TEST(HarmonicBalance, SwappingBumpAndReboundTurnsTheMeanRound) {
  const FrequencyResponse a = QuarterCarResponse(800, 2600, 0.01);
  const FrequencyResponse b = QuarterCarResponse(2600, 800, 0.01);
  EXPECT_LT(std::abs(a.Find("a_sprung")->response[0] / b.Find("a_sprung")->response[0] - 1.0), 1e-10);
  EXPECT_NEAR(a.Find("s_strut")->mean[0], -b.Find("s_strut")->mean[0], 1e-12);
}

// More rebound than bump damping jacks the body down: specification 5.1.
TEST(HarmonicBalance, ReboundDampingJacksTheBodyDown) {
  EXPECT_LT(QuarterCarResponse(800, 2600, 0.01).Find("s_strut")->mean[0], -1e-4);
}

TEST(HarmonicBalance, EndsAtItsDeadline) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 800);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const auto many = static_cast<std::size_t>(1e6);
  const Excitation endless = {std::vector<double>(many, 1.2), std::vector<double>(many, 0.01), {1}};
  EXPECT_THROW(SolveHarmonicBalance(model, vehicle.sensors, endless, {.deadline = Deadline::In(0.01)}), TimedOut);
  EXPECT_NO_THROW(SolveHarmonicBalance(model, vehicle.sensors, {{1.2}, {0.01}, {1}}, {.deadline = Deadline::In(60)}));
  // Within one frequency, too.
  LinearisedCycle cycle(model, {1}, {.deadline = Deadline::In(1e-9)}, PortsOf(model));
  EXPECT_THROW(cycle.Solve(1.2, 0.01), TimedOut);
}

TEST(HarmonicBalance, TellsWhereItsHarmonicsDoNotSuffice) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 800);
  const HarmonicBalanceOptions options{.error = 1e-9, .most_harmonics = 9};
  const PeriodicResponse response = SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()),
                                                         vehicle.sensors, {{1.2}, {0.01}, {1}}, options);
  EXPECT_THAT(response.unconverged_Hz, testing::ElementsAre(1.2));
}

/// A damper of the quarter car.
struct LawCase {
  const char* name;
  DashpotDescription law;
  bool in_series = false;
};

// The march ends when its windows repeat within 1e-4; harmonic balance promises 2e-4.
constexpr double kMarched = 3e-4;

std::ostream& operator<<(std::ostream& out, const LawCase& law) { return out << law.name; }

class HarmonicBalanceOfALaw : public testing::TestWithParam<LawCase> {};

/// Harmonic balance, which is within kMarched of the march in every channel.
FrequencyResponse ExpectMarched(const Vehicle& vehicle, const Excitation& excitation) {
  Prepared prepared(vehicle);
  const FrequencyResponse balanced = Balanced(prepared, excitation);
  const FrequencyResponse marched = prepared.Marched(excitation, 1024);
  for (std::size_t c = 0; c < marched.channels.size(); ++c)
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
      const Complex ratio = balanced.channels[c].response[i] / marched.channels[c].response[i];
      EXPECT_LT(std::abs(ratio - 1.0), kMarched)
          << marched.channels[c].name << " at " << excitation.frequency_Hz[i] << " Hz";
    }
  return balanced;
}

TEST_P(HarmonicBalanceOfALaw, ConvergesToTheMarch) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].law = GetParam().law;
  if (GetParam().in_series) vehicle.dampers[0].series = SpringDescription{.stiffness = {150e3}};
  ExpectMarched(vehicle, {{1.2, 12}, {0.01, 0.002}, {1}});
}

const DashpotDescription kSmooth = {
    .kind = DashpotDescription::Kind::kSmooth, .compression = {800}, .rebound = {2600}, .transition = {0.05}};
const DashpotDescription kDigressive = {.kind = DashpotDescription::Kind::kDigressive,
                                        .compression = {2000},
                                        .rebound = {4000},
                                        .compression_knee = {{0.05}, {500}},
                                        .rebound_knee = {{0.08}, {800}}};
const DashpotDescription kSaturating = {.kind = DashpotDescription::Kind::kSaturating,
                                        .compression = {2000},
                                        .rebound = {4000},
                                        .compression_knee = {{0.2}, {}},
                                        .rebound_knee = {{0.1}, {}}};
const DashpotDescription kTable = {.kind = DashpotDescription::Kind::kTable,
                                   .table = {{{-0.5}, {-500}}, {{-0.1}, {-200}}, {{0.1}, {300}}, {{0.5}, {900}}}};

DashpotDescription WithFriction(double force) {
  return {.compression = {800}, .rebound = {2600}, .friction = DashpotDescription::Friction{{force}, {0.002}}};
}

INSTANTIATE_TEST_SUITE_P(Laws, HarmonicBalanceOfALaw,
                         testing::Values(LawCase{"Smooth", kSmooth, false}, LawCase{"SmoothInSeries", kSmooth, true},
                                         LawCase{"Digressive", kDigressive, false},
                                         LawCase{"DigressiveInSeries", kDigressive, true},
                                         LawCase{"Saturating", kSaturating, false}, LawCase{"Table", kTable, false},
                                         LawCase{"Friction", WithFriction(50), false},
                                         LawCase{"FrictionInSeries", WithFriction(50), true}),
                         testing::PrintToStringParamName());

// The strut passes a point of the table, and in bump its end, 10 mm from the design pose.
TEST(HarmonicBalance, ConvergesToTheMarchOnAMeasuredSpring) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.springs[0].law = {.stiffness = {},
                            .cubic = {},
                            .knees = {},
                            .table = {{{-0.07}, {-1500}}, {{-0.05}, {-900}}, {{0}, {0}}},
                            .place = {-0.06}};
  const double strut = std::abs(ExpectMarched(vehicle, {{1.2}, {0.03}, {1}}).Find("s_strut")->response[0]) * 0.03;
  EXPECT_GT(strut, 0.012);
}

// Friction of 150 N holds the strut for most of the cycle, at 0.2 mm for all but creep.
TEST(HarmonicBalance, ConvergesToTheMarchWhereFrictionSticks) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].law = WithFriction(150);
  vehicle.dampers[0].series = SpringDescription{.stiffness = {150e3}};
  ExpectMarched(vehicle, {{2.0, 2.0}, {0.0002, 0.001}, {1}});
}

/// The Land Rover on its links and bushes, with about the friction that fits the recordings.
Vehicle RubbingCar() {
  Vehicle vehicle = ShippedVehicle("landrover110_engine");
  Set(vehicle, "f_front", 80);
  Set(vehicle, "f_rear", 80);
  Set(vehicle, "v_friction", 3.2e-3);
  return vehicle;
}

const Excitation kRubbing{{0.6, 0.9, 1.3, 1.8, 2.5, 4, 8, 14}, std::vector<double>(8, 8e-3), {1, 1, 1, 1}};

// Friction's slope is far above those of the dampers: without the mean slopes five of these frequencies take 40 to 51
// iterations.
TEST(HarmonicBalance, TakesFewIterationsWhereFrictionSlides) {
  const CondensedModel model = Prepared(RubbingCar()).model;
  LinearisedCycle cycle(model, kRubbing.shape, {.few_harmonics = true, .tolerance = 1e-6}, PortsOf(model));
  for (std::size_t i = 0; i < kRubbing.frequency_Hz.size(); ++i) {
    EXPECT_TRUE(cycle.Solve(kRubbing.frequency_Hz[i], kRubbing.amplitude_m[i])) << kRubbing.frequency_Hz[i];
    EXPECT_LT(cycle.iterations(), 40) << kRubbing.frequency_Hz[i];
    EXPECT_EQ(cycle.harmonics(), 17);
  }
}

// 17 harmonics with all the samples that friction needs leave little: of the largest of a channel at any frequency.
TEST(HarmonicBalance, FewHarmonicsSufficeWithFriction) {
  constexpr double kFew = 2e-3;
  const Prepared prepared(RubbingCar());
  const PeriodicResponse few = SolveHarmonicBalance(prepared.model, prepared.vehicle.sensors, kRubbing,
                                                    {.few_harmonics = true, .tolerance = 1e-6});
  const PeriodicResponse all =
      SolveHarmonicBalance(prepared.model, prepared.vehicle.sensors, kRubbing, {.error = 2e-5});
  EXPECT_THAT(few.unconverged_Hz, testing::IsEmpty());
  EXPECT_THAT(all.unconverged_Hz, testing::IsEmpty());
  for (std::size_t c = 0; c < all.response.channels.size(); ++c) {
    const ChannelResponse& expected = all.response.channels[c];
    double largest = 0;
    for (const Complex& one : expected.response) largest = std::max(largest, std::abs(one));
    for (std::size_t i = 0; i < expected.response.size(); ++i)
      EXPECT_LT(std::abs(few.response.channels[c].response[i] - expected.response[i]), kFew * largest)
          << expected.name << " at " << kRubbing.frequency_Hz[i];
  }
}

/// The quarter car with a stop, a knee or a cubic term of its spring, or a tyre that lifts off.
struct StiffeningCase {
  const char* name;
  SpringLaw::Knee knee;
  double cubic = 0;
  bool lifts_off = false;
  double frequency_Hz = 1.2;
  double amplitude_m = 0.02;
};

std::ostream& operator<<(std::ostream& out, const StiffeningCase& stiffening) { return out << stiffening.name; }

class HarmonicBalanceOfAStiffening : public testing::TestWithParam<StiffeningCase> {};

TEST_P(HarmonicBalanceOfAStiffening, ConvergesToTheMarch) {
  const StiffeningCase& stiffening = GetParam();
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 800);
  Set(vehicle, "c_rebound", 2600);
  SpringDescription& law = vehicle.springs[0].law;
  law.cubic = {stiffening.cubic};
  if (stiffening.knee.stiffness != 0)
    law.knees.push_back({.side = stiffening.knee.side,
                         .at = {stiffening.knee.at},
                         .rate = {stiffening.knee.stiffness},
                         .cubic = {stiffening.knee.cubic}});
  vehicle.tyres[0].lifts_off = stiffening.lifts_off;
  const Excitation excitation{{stiffening.frequency_Hz}, {stiffening.amplitude_m}, {1}};
  // It must matter.
  const FrequencyResponse with = ExpectMarched(vehicle, excitation);
  vehicle.springs[0].law = ShippedVehicle("quarter_car").springs[0].law;
  vehicle.tyres[0].lifts_off = false;
  const FrequencyResponse without = Balanced(Prepared(vehicle), excitation);
  EXPECT_GT(std::abs(with.channels[0].response[0] / without.channels[0].response[0] - 1.0), 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Stiffenings, HarmonicBalanceOfAStiffening,
    testing::Values(
        StiffeningCase{.name = "BumpStop", .knee = {.at = 0.015, .side = -1, .stiffness = 150e3}},
        StiffeningCase{.name = "ReboundKnee", .knee = {.at = 0.005, .side = 1, .stiffness = 20e3}},
        StiffeningCase{.name = "ProgressiveStop", .knee = {.at = 0.01, .side = -1, .stiffness = 20e3, .cubic = 1e8}},
        StiffeningCase{.name = "Cubic", .knee = {}, .cubic = 3e7},
        StiffeningCase{.name = "Liftoff", .knee = {}, .lifts_off = true, .frequency_Hz = 12, .amplitude_m = 0.015}),
    testing::PrintToStringParamName());

// Behind a stop a range of frequencies has two motions. A rising sweep stays on the one that it came from, a falling
// one on the other; far from the range both agree.
TEST(HarmonicBalance, TakesTheMotionThatTheSweepCameFrom) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 250);
  Set(vehicle, "c_rebound", 250);
  vehicle.springs[0].law.knees.push_back({.side = -1, .at = {0.02}, .rate = {200e3}, .cubic = {}});
  vehicle.springs[0].law.knees.push_back({.side = 1, .at = {0.02}, .rate = {200e3}, .cubic = {}});
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  std::vector<double> rising;
  for (double f = 0.8; f < 4.01; f += 0.1) rising.push_back(f);
  const std::vector<double> falling(rising.rbegin(), rising.rend());
  const std::vector<double> amplitude(rising.size(), 0.01);
  const auto gains = [&](const std::vector<double>& frequencies) {
    const PeriodicResponse response = SolveHarmonicBalance(model, vehicle.sensors, {frequencies, amplitude, {1}});
    EXPECT_THAT(response.unconverged_Hz, testing::IsEmpty());
    std::vector<double> gain;
    for (const Complex& value : response.response.Find("s_strut")->response) gain.push_back(std::abs(value));
    return gain;
  };
  const std::vector<double> up = gains(rising);
  std::vector<double> down = gains(falling);
  std::reverse(down.begin(), down.end());
  double largest = 1;
  for (std::size_t i = 0; i < up.size(); ++i) largest = std::max(largest, up[i] / down[i]);
  EXPECT_GT(largest, 1.5);
  EXPECT_NEAR(up.front() / down.front(), 1, 1e-3);
  EXPECT_NEAR(up.back() / down.back(), 1, 1e-3);
}

// The error that is asked for, 2e-4, against a hundredth of it; sensors near a node apart. What is left is estimated by
// the last change, and may exceed it by half where a kink fell on samples of both.
TEST(HarmonicBalance, KeepsItsErrorInTheShippedVehicles) {
  for (const char* name : {"landrover110_model1", "landrover110_linkage", "landrover110_model3", "landrover110_rigid",
                           "landrover110", "single_wheel_station"}) {
    const Vehicle vehicle = ShippedVehicle(name);
    const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
    Excitation excitation{.shape = std::vector<double>(vehicle.posts.size(), 1.0)};
    for (double f = 0.5; f < 30; f *= 1.3) {
      excitation.frequency_Hz.push_back(f);
      excitation.amplitude_m.push_back(std::min(0.01, 0.01 / f));
    }
    const FrequencyResponse response = SolveHarmonicBalance(model, vehicle.sensors, excitation).response;
    const FrequencyResponse exact =
        SolveHarmonicBalance(model, vehicle.sensors, excitation, {.error = 2e-6, .tolerance = 1e-8}).response;
    for (std::size_t c = 0; c < exact.channels.size(); ++c) {
      double largest = 0;
      for (const Complex& value : exact.channels[c].response) largest = std::max(largest, std::abs(value));
      for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
        const Complex value = exact.channels[c].response[i];
        if (std::abs(value) < 0.03 * largest) continue;
        EXPECT_LT(std::abs(response.channels[c].response[i] / value - 1.0), 3e-4)
            << name << ", " << exact.channels[c].name << " at " << excitation.frequency_Hz[i] << " Hz";
      }
    }
  }
}

TEST(HarmonicBalance, RefusesTooFewHarmonics) {
  try {
    HarmonicBalanceOptions{.most_harmonics = 5}.Validate();
    FAIL() << "an error needs two numbers of harmonics";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("most_harmonics = 5, must be at least 9"));
  }
}

}  // namespace
}  // namespace fourpost::harmonic_balance_test
