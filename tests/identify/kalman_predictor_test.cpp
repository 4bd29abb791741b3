#include "identify/kalman_predictor.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/random_stream.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

/// The station's recording with white noise of some per cent on each channel.
class KalmanPredictorTest : public testing::Test {
 protected:
  void Record(double noise) {
    TimeHistory recorded = RecordStation(vehicle_, std::nullopt);
    for (Eigen::Index i = 0; i < recorded.readings.cols(); ++i) {
      auto channel = recorded.readings.col(i);
      const double sd = noise * std::sqrt((channel.array() - channel.mean()).square().mean());
      sd_.push_back(sd);
      RandomStream draws(1, "sensor noise", static_cast<std::uint64_t>(i));
      for (double& value : channel) value += sd * draws.Normal();
    }
    StudyHistory study{.name = "sweep", .posts = {{"ground", {.channels = {"z_ground"}}}}};
    for (const Sensor& sensor : vehicle_.sensors) study.channels.push_back({sensor.name, {.channels = {sensor.name}}});
    study.file = folder_.Write("sweep.csv", StationCsv(recorded, vehicle_));
    Diagnostics diagnostics;
    histories_ = LoadHistories({study}, "study.yaml", vehicle_, diagnostics).value();
  }

  KalmanNoise Noise(double process) const {
    return {.process_sd = Eigen::VectorXd::Constant(2, process),
            .sensor_sd = Eigen::Map<const Eigen::VectorXd>(sd_.data(), static_cast<Eigen::Index>(sd_.size()))};
  }

  CondensedModel Model() const { return CondensedVehicle(vehicle_).At(vehicle_.ParameterValues()); }

  Vehicle vehicle_ = ShippedVehicle("single_wheel_station");
  std::vector<double> sd_;
  TemporaryFolder folder_;
  std::vector<MeasuredHistory> histories_;
};

TEST_F(KalmanPredictorTest, HasWhiteInnovationsOfTheirStatedSizeForTheTrueModel) {
  Record(0.03);
  const KalmanPrediction prediction = KalmanPredictor(histories_[0]).Run(Model(), Noise(1e-3));
  const auto samples = static_cast<double>(histories_[0].count);
  for (Eigen::Index i = 0; i < prediction.whitened.cols(); ++i) {
    // Three deviations of a sample variance.
    EXPECT_NEAR(prediction.whitened.col(i).squaredNorm() / samples, 1, 3 * std::sqrt(2 / samples)) << i;
    const Whiteness whiteness = WhitenessOf(prediction.innovations.col(i));
    EXPECT_LT(std::abs(whiteness.next), 3 / std::sqrt(samples)) << i;
    // Five of 25 come once in a hundred series.
    EXPECT_LE(whiteness.beyond, 0.2) << i;
  }
}

TEST_F(KalmanPredictorTest, EstimatesTheNoiseOfSensors) {
  Record(0.03);
  const KalmanNoise noise = KalmanPredictor(histories_[0]).Estimate(Model());
  // To the last factor of the search.
  for (Eigen::Index i = 0; i < noise.sensor_sd.size(); ++i)
    EXPECT_NEAR(std::log(noise.sensor_sd[i] / sd_[static_cast<std::size_t>(i)]), 0, std::log(1.5)) << i;
}

TEST_F(KalmanPredictorTest, RefusesWhatCannotBe) {
  Record(0.03);
  EXPECT_THROW(KalmanPredictor(histories_[0]).Run(Model(), {}), std::invalid_argument);
  histories_[0].filter = LowPassDesign{.order = 4, .cutoff_Hz = 30};
  EXPECT_THROW(KalmanPredictor{histories_[0]}, std::invalid_argument);
}

TEST(Whiteness, TellsNoiseFromItsSum) {
  RandomStream draws(1, "series", 0);
  Eigen::VectorXd noise(5000);
  Eigen::VectorXd sum(5000);
  double total = 0;
  for (Eigen::Index k = 0; k < noise.size(); ++k) {
    noise[k] = draws.Normal();
    sum[k] = total = 0.9 * total + noise[k];
  }
  EXPECT_LT(std::abs(WhitenessOf(noise).next), 3 / std::sqrt(5000.0));
  EXPECT_LE(WhitenessOf(noise).beyond, 0.2);
  EXPECT_NEAR(WhitenessOf(sum).next, 0.9, 0.02);
  EXPECT_GT(WhitenessOf(sum).beyond, 0.8);
}

}  // namespace
}  // namespace fourpost
