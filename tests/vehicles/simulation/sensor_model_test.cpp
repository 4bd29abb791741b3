#include "vehicles/simulation/sensor_model.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/signals/low_pass.h"

namespace fourpost::sensor_model_test {
namespace {

/// Two posts and three sensors, all at 5 Hz, of sizes 1 to 5.
TimeHistory Sines() {
  TimeHistory history{.rate_Hz = 500};
  history.posts.resize(5000, 2);
  history.readings.resize(5000, 3);
  for (Eigen::Index k = 0; k < 5000; ++k) {
    const double sine = std::sin(2 * std::numbers::pi * 5 * history.TimeAt(k));
    history.posts.row(k) << sine, 2 * sine;
    history.readings.row(k) << 3 * sine, 4 * sine, 5 * sine + 100;
  }
  return history;
}

TEST(SensorModel, LeavesAllAsItIsByDefault) {
  TimeHistory history = Sines();
  SensorModel().Apply(history);
  EXPECT_EQ(history.posts, Sines().posts);
  EXPECT_EQ(history.readings, Sines().readings);
}

TEST(SensorModel, FiltersPostsAndSensorsAlike) {
  TimeHistory history = Sines();
  SensorModel{.filter = SensorModel::Filter{.order = 4, .cutoff_Hz = 30}}.Apply(history);
  Eigen::VectorXd expected = Sines().posts.col(0);
  LowPass(4, 30, 500).Apply({expected.data(), 5000});
  // A filter is linear; rounding.
  EXPECT_LT((history.posts.col(0) - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT((history.readings.col(1) - 4 * expected).norm(), 1e-12 * 4 * expected.norm());
  EXPECT_GT((expected - Sines().posts.col(0)).norm(), 0.1 * expected.norm());
}

TEST(SensorModel, AddsNoiseOfTheShareAskedForWithoutTheMean) {
  TimeHistory history = Sines();
  SensorModel{.noise = 0.01, .seed = 7}.Apply(history);
  const Eigen::VectorXd noise = history.readings.col(2) - Sines().readings.col(2);
  const double deviation = std::sqrt((noise.array() - noise.mean()).square().mean());
  // 5 sin has a deviation of 5 / sqrt(2); an estimate from 5000 values errs by 1 %.
  EXPECT_NEAR(deviation, 0.01 * 5 / std::numbers::sqrt2, 0.03 * 0.01 * 5);
}

TEST(SensorModel, DrawsTheSameNoiseForTheSameSeedAndNoneTwice) {
  TimeHistory first = Sines();
  TimeHistory again = Sines();
  TimeHistory other = Sines();
  SensorModel{.noise = 0.01, .seed = 7}.Apply(first);
  SensorModel{.noise = 0.01, .seed = 7}.Apply(again);
  SensorModel{.noise = 0.01, .seed = 8}.Apply(other);
  EXPECT_EQ(first.readings, again.readings);
  EXPECT_NE(first.readings, other.readings);
  const Eigen::VectorXd a = (first.readings.col(0) - Sines().readings.col(0)) / 3;
  const Eigen::VectorXd b = (first.readings.col(1) - Sines().readings.col(1)) / 4;
  // Not alike: two independent series of 5000 correlate by 1/sqrt(5000) = 0.014.
  EXPECT_LT(std::abs(a.dot(b)) / (a.norm() * b.norm()), 0.06);
}

TEST(SensorModel, RefusesWhatCannotBe) {
  TimeHistory history = Sines();
  EXPECT_THROW((SensorModel{.filter = SensorModel::Filter{.cutoff_Hz = 250}}.Apply(history)), std::invalid_argument);
  EXPECT_THROW((SensorModel{.filter = SensorModel::Filter{.order = 0, .cutoff_Hz = 30}}.Apply(history)),
               std::invalid_argument);
  EXPECT_THROW((SensorModel{.noise = -0.1}.Apply(history)), std::invalid_argument);
  EXPECT_THROW((SensorModel{.noise = NAN}.Apply(history)), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::sensor_model_test
