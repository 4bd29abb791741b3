#include "vehicles/response/response_recorder.h"

#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::response_recorder_test {
namespace {

using Complex = std::complex<double>;

constexpr double kAmplitude_m = 0.01;

/// What is recorded of a sensor with harmonics 1, 2 + 3i and 4 - 4i at 2 Hz.
FrequencyResponse Recorded(Sensor::Type type) {
  Sensor sensor;
  sensor.name = "y";
  sensor.type = type;
  ResponseRecorder recorder({sensor}, {{1, 2}, {0.5, kAmplitude_m}, {1}});
  SensorHarmonics harmonics(1, 3);
  harmonics << 1, Complex(2, 3), Complex(4, -4);
  recorder.Record(1, harmonics);
  return recorder.Take();
}

TEST(ResponseRecorder, RelatesADisplacementToThePosts) {
  const FrequencyResponse response = Recorded(Sensor::Type::kDisplacement);
  EXPECT_EQ(response.Find("y")->unit, "m");
  EXPECT_EQ(response.Find("y")->response[1], Complex(2, 3) / kAmplitude_m);
  EXPECT_EQ(response.Find("y")->response[0], Complex());
}

// The reference post's acceleration is -w^2 a: a body that moves with it has gain 1, phase 0.
TEST(ResponseRecorder, RelatesAnAccelerationToThePostsAcceleration) {
  const FrequencyResponse response = Recorded(Sensor::Type::kAccelerometer);
  const double omega = 4 * std::numbers::pi;
  EXPECT_EQ(response.Find("y")->unit, "m/s^2");
  EXPECT_LT(std::abs(response.Find("y")->response[1] / (Complex(2, 3) / (-omega * omega * kAmplitude_m)) - 1.0),
            1e-15);  // rounding
}

TEST(ResponseRecorder, RelatesAnAngularVelocityToThePostsDisplacement) {
  const FrequencyResponse response = Recorded(Sensor::Type::kGyro);
  EXPECT_EQ(response.Find("y")->unit, "rad/s");
  EXPECT_EQ(response.Find("y")->response[1], Complex(2, 3) / kAmplitude_m);
}

TEST(ResponseRecorder, KeepsMeanAndSecondHarmonicAsTheyAre) {
  const FrequencyResponse response = Recorded(Sensor::Type::kLoadCell);
  EXPECT_EQ(response.Find("y")->unit, "N");
  EXPECT_EQ(response.Find("y")->mean[1], 1);
  EXPECT_DOUBLE_EQ(response.Find("y")->second_harmonic[1], 4 * std::numbers::sqrt2);
}

}  // namespace
}  // namespace fourpost::response_recorder_test
