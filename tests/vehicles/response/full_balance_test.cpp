#include "vehicles/response/full_balance.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/recorded_rig.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost::full_balance_test {
namespace {

using Complex = std::complex<double>;
using testing::HasSubstr;
using testing::IsEmpty;

Excitation QuarterCarSine() { return {{0.7, 1.2, 2.5, 6, 15, 30}, {0.012, 0.012, 0.010, 0.005, 0.001, 3e-4}, {1}}; }

TEST(FullBalance, EqualsTheClosedResponseOfALinearQuarterCar) {
  const QuarterCar car = ThesisCar();
  const Vehicle vehicle = Describe(car);
  Prepared prepared(vehicle);
  const Excitation excitation = QuarterCarSine();
  const PeriodicResponse balanced = prepared.Full(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, IsEmpty());
  const FrequencyResponse& response = balanced.response;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const auto closed = car.Response(excitation.frequency_Hz[i]);
    // Rounding: weights of 2 kN on 22 kg in 64-bit numbers, 1e-14 N of 1e3, over a motion of 0.3 mm.
    constexpr double kRounding = 1e-10;
    EXPECT_LT(std::abs(response.Find("a_sprung")->response[i] - closed[0]), kRounding);
    EXPECT_LT(std::abs(response.Find("a_unsprung")->response[i] - closed[1]), kRounding);
    EXPECT_LT(std::abs(response.Find("z_sprung")->response[i] - closed[0]), kRounding);
    EXPECT_LT(std::abs(response.Find("s_strut")->response[i] - (closed[0] - closed[1])), kRounding);
    const Complex force = car.tyre_stiffness * (1.0 - closed[1]);
    EXPECT_LT(std::abs(response.Find("F_tyre")->response[i] - force), kRounding * car.tyre_stiffness);
  }
}

/// The quarter car's kinematics are exactly linear: both engines solve the same equations, however few harmonics.
void ExpectLinearisedEqualsFull(const Vehicle& vehicle) {
  constexpr double kConverged = 1e-10;
  Prepared prepared(vehicle);
  const Excitation excitation = QuarterCarSine();
  const PeriodicResponse full = prepared.Full(excitation, {.tolerance = kConverged});
  const PeriodicResponse linearised = prepared.Linearised(excitation, {.tolerance = kConverged});
  EXPECT_THAT(full.unconverged_Hz, IsEmpty());
  // A step of the tolerance leaves about twice that at contraction 0.5, a channel may be a tenth of the largest motion.
  constexpr double kTolerance = 30 * kConverged;
  for (std::size_t c = 0; c < vehicle.sensors.size(); ++c) {
    const ChannelResponse& f = full.response.channels[c];
    const ChannelResponse& l = linearised.response.channels[c];
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
      const std::string where = vehicle.sensors[c].name + " at " + std::to_string(excitation.frequency_Hz[i]) + " Hz";
      EXPECT_LT(std::abs(f.response[i] / l.response[i] - 1.0), kTolerance) << where;
      const bool acceleration = vehicle.sensors[c].type == Sensor::Type::kAccelerometer;
      const double omega = 2 * std::numbers::pi * excitation.frequency_Hz[i];
      const double first = std::abs(l.response[i]) * excitation.amplitude_m[i] * (acceleration ? omega * omega : 1.0);
      EXPECT_NEAR(f.second_harmonic[i], l.second_harmonic[i], kTolerance * first) << where;
      // A load cell's mean is a difference of weights.
      const double weight = vehicle.sensors[c].type == Sensor::Type::kLoadCell ? 1e-9 : 0;
      EXPECT_NEAR(f.mean[i], l.mean[i], kTolerance * std::max(first, std::abs(l.mean[i])) + weight) << where;
    }
  }
}

TEST(FullBalance, EqualsTheLinearisedBalanceOfABilinearQuarterCar) {
  ExpectLinearisedEqualsFull(Describe(BilinearCar()));
}

TEST(FullBalance, EqualsTheLinearisedBalanceOfASeriesQuarterCar) { ExpectLinearisedEqualsFull(Describe(SeriesCar())); }

/// Both the balance with a dozen samples and the reference of other tests. The march's sampling and settling leave
/// 0.004 dB and 0.05 degrees.
void ExpectTheMarch(const Excitation& excitation, int samples_per_cycle) {
  Prepared prepared(ShippedVehicle("landrover110_linkage"));
  const PeriodicResponse balanced = prepared.Full(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, IsEmpty());
  const FrequencyResponse marched = prepared.Marched(excitation, samples_per_cycle);
  ExpectAgreement(balanced.response, marched);
  ExpectAgreement(prepared.Reference(excitation), marched);
}

TEST(FullBalance, AgreesWithTheMarchInBounce) {
  ExpectTheMarch(Sparse(RecordedExcitation("bounce_frf.csv", {1, 1})), 128);
}

// Near 8.7 Hz the centre of gravity is almost a node, with a second harmonic of a hundred times the first: at 64
// samples per cycle the march's own Fourier coefficients err there by 0.12 dB and 0.6 degrees.
TEST(FullBalance, AgreesWithTheMarchInPitch) {
  ExpectTheMarch(Sparse(RecordedExcitation("pitch_frf.csv", {1, -1})), 128);
}

TEST(FullBalance, AgreesWithTheMarchAtThreeTimesTheAmplitudeWhereLinearKinematicsDoNot) {
  Prepared prepared(ShippedVehicle("landrover110_linkage"));
  const Excitation excitation = Only(RecordedExcitation("pitch_frf.csv", {1, -1}, 3), {20, 44});  // 1.8 and 8.7 Hz
  const PeriodicResponse balanced = prepared.Full(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, IsEmpty());
  const FrequencyResponse marched = prepared.Marched(excitation, 256);
  ExpectAgreement(balanced.response, marched);
  const FrequencyResponse linearised = prepared.Linearised(excitation).response;
  const Deviation deviation = LargestDeviation(*linearised.Find("a_cg"), *marched.Find("a_cg"));
  EXPECT_GT(deviation.gain_dB, 2 * kPromised_dB);
  EXPECT_GT(deviation.phase_deg, kPromised_deg);
}

TEST(FullBalance, TellsWhereItDidNotConverge) {
  Prepared prepared(ShippedVehicle("landrover110_linkage"));
  const Excitation excitation = {{1.2}, {0.01}, {1, 1}};
  const PeriodicResponse balanced = prepared.Full(excitation, {.tolerance = 1e-9, .max_iterations = 1});
  EXPECT_THAT(balanced.unconverged_Hz, testing::ElementsAre(1.2));
  const FrequencyResponse linearised = prepared.Linearised(excitation, {.tolerance = 1e-9}).response;
  EXPECT_EQ(balanced.response.Find("a_cg")->response, linearised.Find("a_cg")->response);
}

// Ten metres at 30 Hz turn the links over many times.
TEST(FullBalance, SurvivesAMotionThatNoVehicleFollows) {
  Prepared prepared(ShippedVehicle("landrover110_linkage"));
  // 10 km.
  const PeriodicResponse balanced = prepared.Full({{1.2, 30}, {1e4, 10}, {1, -1}});
  EXPECT_THAT(balanced.unconverged_Hz, testing::Contains(1.2));
  for (const ChannelResponse& channel : balanced.response.channels)
    for (const Complex value : channel.response) EXPECT_TRUE(std::isfinite(std::abs(value))) << channel.name;
}

// Laws, friction too, vary steeply; what the full system adds to them does not.
TEST(FullBalance, NeedsADozenSamples) {
  for (const char* name : {"landrover110_linkage", "landrover110", "landrover110_rigid"}) {
    Prepared prepared(ShippedVehicle(name));
    Excitation excitation{{0.8, 1.6, 4, 9.5, 20}, {0.01, 0.008, 0.003, 0.001, 4e-4}, {}};
    excitation.shape.assign(prepared.vehicle.posts.size(), 1);
    const PeriodicResponse few = prepared.Full(excitation);
    const PeriodicResponse many = prepared.Full(excitation, {.harmonics = 15, .samples = 64, .tolerance = 1e-7});
    EXPECT_THAT(few.unconverged_Hz, IsEmpty());
    // The tolerance of some channels a tenth of the largest motion.
    for (std::size_t c = 0; c < few.response.channels.size(); ++c) {
      const ChannelResponse& a = few.response.channels[c];
      const ChannelResponse& b = many.response.channels[c];
      for (std::size_t i = 0; i < a.response.size(); ++i)
        if (std::abs(b.response[i]) > 0.03 * std::abs(b.response[0])) {
          EXPECT_LT(std::abs(a.response[i] / b.response[i] - 1.0), 5e-4) << name << ' ' << a.name;
        }
    }
  }
}

Excitation RollOfTheCar(double frequency_Hz, double amplitude_m) {
  return {{frequency_Hz}, {amplitude_m}, PostPattern(ShippedVehicle("landrover110"), "roll")};
}

// Rolling by some degrees, the full geometry moves sensors amidships by a tenth.
TEST(FullBalance, TakesMoreSamplesWhereTheyCount) {
  Prepared prepared(ShippedVehicle("landrover110"));
  const Excitation excitation = RollOfTheCar(1.76, 0.012);
  const auto reading = [&](const FullBalanceOptions& options) {
    return prepared.Full(excitation, options).response.Find("a_cross_member")->response[0];
  };
  const Complex exact = reading({.fine_harmonics = 63, .fine_samples = 512});
  EXPECT_LT(std::abs(reading({}) / exact - 1.0), 5e-4);
  EXPECT_GT(std::abs(reading({.fine_harmonics = 5, .fine_samples = 16}) / exact - 1.0), 2e-3);
}

// Next to the resonance of roll its acceleration leads nowhere from rest.
TEST(FullBalance, ComesFromSmallerAmplitudesToLargeOnes) {
  Prepared prepared(WithLinearTyres(ShippedVehicle("landrover110")));
  const Excitation excitation = RollOfTheCar(1.57, 0.0117);
  const PeriodicResponse with_short_memory = prepared.Full(excitation, {.history = 8});
  const PeriodicResponse with_long_memory = prepared.Full(excitation);
  EXPECT_THAT(with_short_memory.unconverged_Hz, IsEmpty());
  EXPECT_THAT(with_long_memory.unconverged_Hz, IsEmpty());
  // Next to the resonance what is left is some twenty times the tolerance.
  EXPECT_LT(std::abs(with_short_memory.response.Find("a_body_FL")->response[0] /
                         with_long_memory.response.Find("a_body_FL")->response[0] -
                     1.0),
            5e-4);
}

TEST(FullBalance, AgreesWithTheMarchThroughLoops) {
  Prepared prepared(ShippedVehicle("landrover110_rigid"));
  const Excitation excitation = {{2.68, 9}, {0.015, 0.002}, {1, 1, 1, 1}};
  const PeriodicResponse balanced = prepared.Full(excitation);
  EXPECT_THAT(balanced.unconverged_Hz, IsEmpty());
  const FrequencyResponse marched = prepared.Marched(excitation, 128);
  ExpectAgreement(balanced.response, marched, 0.02, 0.1);
  // Enough motion to tell the two apart.
  double apart_dB = 0;
  const FrequencyResponse linearised = prepared.Linearised(excitation).response;
  for (std::size_t c = 0; c < marched.channels.size(); ++c)
    apart_dB = std::max(apart_dB, LargestDeviation(linearised.channels[c], marched.channels[c]).gain_dB);
  EXPECT_GT(apart_dB, 0.05);
}

/// The linkage car whose arms turn by some degrees: linear kinematics keep 0.02 dB at 5 mm, and not at 50 mm.
TEST(FullBalance, HoldsForLargeMotionWhereLinearKinematicsDoNot) {
  Prepared prepared(ShippedVehicle("landrover110_linkage"));
  const auto deviation_dB = [](const FrequencyResponse& a, const FrequencyResponse& b) {
    double largest = 0;
    for (std::size_t c = 0; c < a.channels.size(); ++c)
      largest = std::max(largest, LargestDeviation(a.channels[c], b.channels[c]).gain_dB);
    return largest;
  };
  for (const double amplitude : {0.005, 0.05}) {
    const Excitation excitation = {{1.2, 9.45}, {amplitude, amplitude / 9.45}, {1, 1}};
    const PeriodicResponse balanced = prepared.Full(excitation);
    EXPECT_THAT(balanced.unconverged_Hz, IsEmpty());
    const FrequencyResponse marched = prepared.Marched(excitation, 256);
    ExpectAgreement(balanced.response, marched, 0.02, 0.1);
    const double linear_dB = deviation_dB(prepared.Linearised(excitation).response, marched);
    EXPECT_LT(linear_dB, amplitude < 0.01 ? 0.02 : 0.1) << amplitude;
    if (amplitude > 0.01) {
      EXPECT_GT(linear_dB, 0.02);
    }
  }
}

std::string Complaint(const FullBalanceOptions& options) {
  try {
    options.Validate();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FullBalance, NamesTheOptionThatIsOutOfBounds) {
  EXPECT_EQ(Complaint({}), "");
  EXPECT_THAT(Complaint({.harmonics = 1}), HasSubstr("harmonics = 1, must be at least 2"));
  EXPECT_THAT(Complaint({.samples = 18}),
              HasSubstr("samples = 18, must be a multiple of 4 and more than twice the harmonics"));
  EXPECT_THAT(Complaint({.tolerance = std::numeric_limits<double>::quiet_NaN()}), HasSubstr("tolerance = "));
  EXPECT_THAT(Complaint({.max_iterations = 0}), HasSubstr("max_iterations = 0"));
  EXPECT_THAT(Complaint({.history = -1}), HasSubstr("history = -1"));
}

}  // namespace
}  // namespace fourpost::full_balance_test
