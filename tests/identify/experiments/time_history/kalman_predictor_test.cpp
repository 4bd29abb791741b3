#include "identify/experiments/time_history/kalman_predictor.h"

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/QR>

#include "analysis/signals/autocorrelation.h"
#include "analysis/signals/random_stream.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "tests/identify/recorded_station.h"
#include "tests/temporary_folder.h"

namespace fourpost::kalman_predictor_test {
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

TEST_F(KalmanPredictorTest, EstimatesNothingThatIsStated) {
  Record(0.03);
  histories_[0].process_sd = 0.2;
  for (std::size_t i = 0; i < sd_.size(); ++i) histories_[0].signals[i].noise_sd = sd_[i];
  int runs = 0;
  const KalmanNoise noise = KalmanPredictor(histories_[0]).Estimate(Model(), {.progress = [&](int) { ++runs; }});
  EXPECT_EQ(runs, 0);
  EXPECT_EQ(noise.process_sd, Eigen::Vector2d(0.2, 0.2));
  for (std::size_t i = 0; i < sd_.size(); ++i) EXPECT_EQ(noise.sensor_sd[static_cast<Eigen::Index>(i)], sd_[i]);
}

TEST_F(KalmanPredictorTest, AsksItsDeadlineAsItEstimates) {
  Record(0.03);
  EXPECT_THROW(KalmanPredictor(histories_[0]).Estimate(Model(), {.deadline_s = 1e-9}), TimedOut);
}

/// Parameters at which residuals are least, by Gauss and Newton, and their deviations.
struct LeastSquares {
  Eigen::VectorXd values;
  Eigen::VectorXd sd;
};

LeastSquares Least(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals, Eigen::VectorXd values) {
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd here;
  for (int iteration = 0; iteration < 6; ++iteration) {
    here = residuals(values);
    jacobian.resize(here.size(), values.size());
    for (Eigen::Index j = 0; j < values.size(); ++j) {
      const double step = 1e-3 * values[j];
      Eigen::VectorXd moved = values;
      moved[j] += step;
      const Eigen::VectorXd above = residuals(moved);
      moved[j] -= 2 * step;
      jacobian.col(j) = (above - residuals(moved)) / (2 * step);
    }
    const Eigen::VectorXd change = -jacobian.colPivHouseholderQr().solve(here);
    values.array() += change.array().min(0.1 * values.array()).max(-0.1 * values.array());
  }
  const double scale = here.squaredNorm() / static_cast<double>(here.size());
  return {values, (scale * (jacobian.transpose() * jacobian).inverse().diagonal()).cwiseSqrt()};
}

// The twin's parameters come back from a file that has others, whose own noise the estimate takes for the process's.
TEST_F(KalmanPredictorTest, ParametersAreLikeliestWhereTheyAreTrue) {
  Record(0.03);
  const std::vector<std::string> names{"m_sprung", "c_rebound", "kt"};
  Eigen::Vector3d truth = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < names.size(); ++j) truth[static_cast<Eigen::Index>(j)] = ValueOf(vehicle_, names[j]);
  const Eigen::Vector3d start = truth.cwiseProduct(Eigen::Vector3d(1.1, 0.85, 0.93));
  for (std::size_t j = 0; j < names.size(); ++j) Set(vehicle_, names[j], start[static_cast<Eigen::Index>(j)]);
  const HistoryResiduals residuals(std::make_shared<const CondensedVehicle>(vehicle_), histories_,
                                   {.cost = HistoryCost::kPrediction});
  const auto all = [&](const Eigen::VectorXd& values) {
    for (std::size_t j = 0; j < names.size(); ++j) Set(vehicle_, names[j], values[static_cast<Eigen::Index>(j)]);
    return vehicle_.ParameterValues();
  };
  const LeastSquares least = Least([&](const Eigen::VectorXd& values) { return residuals.At(all(values)); }, start);
  for (Eigen::Index j = 0; j < 3; ++j) {
    EXPECT_NEAR(least.values[j], truth[j], 4 * least.sd[j]) << names[static_cast<std::size_t>(j)];
    // So that the interval says something.
    EXPECT_LT(least.sd[j], 0.02 * truth[j]);
  }
}

// At the true noise the sum of squares alone is least elsewhere: where the covariance is larger.
TEST_F(KalmanPredictorTest, ResidualsHaveTheDeterminantInThem) {
  Record(0.03);
  histories_[0].process_sd = 1e-2;
  for (std::size_t i = 0; i < sd_.size(); ++i) histories_[0].signals[i].noise_sd = sd_[i];
  const auto condensed = std::make_shared<const CondensedVehicle>(vehicle_);
  const HistoryResiduals residuals(condensed, histories_, {.cost = HistoryCost::kPrediction});
  const KalmanPrediction here = residuals.Predicted(vehicle_.ParameterValues())[0];
  EXPECT_NEAR(residuals.At(vehicle_.ParameterValues()).squaredNorm(), here.whitened.squaredNorm(),
              1e-9 * here.whitened.squaredNorm());
  Set(vehicle_, "m_sprung", 0.97 * ValueOf(vehicle_, "m_sprung"));
  const KalmanPrediction there = residuals.Predicted(vehicle_.ParameterValues())[0];
  const auto count = static_cast<double>(residuals.count());
  // Minus twice the log likelihood, its common scale of noise at the likeliest, from both forms.
  const double change =
      count * std::log(residuals.At(vehicle_.ParameterValues()).squaredNorm() / here.whitened.squaredNorm());
  EXPECT_NEAR(change,
              count * std::log(there.whitened.squaredNorm() / here.whitened.squaredNorm()) + there.log_determinant -
                  here.log_determinant,
              1e-6 * std::abs(change));
  EXPECT_NE(there.log_determinant, here.log_determinant);
}

TEST_F(KalmanPredictorTest, RefusesWhatCannotBe) {
  Record(0.03);
  EXPECT_THROW(KalmanPredictor(histories_[0]).Run(Model(), {}), std::invalid_argument);
  CondensedModel hydraulic = Model();
  hydraulic.hydraulics.emplace_back();
  EXPECT_THROW(KalmanPredictor(histories_[0]).Run(hydraulic, Noise(1e-3)), std::invalid_argument);
  histories_[0].filter = LowPassDesign{.order = 4, .cutoff_Hz = 30};
  EXPECT_THROW(KalmanPredictor{histories_[0]}, std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::kalman_predictor_test
