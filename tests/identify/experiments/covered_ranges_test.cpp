#include "identify/experiments/covered_ranges.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "identify/experiments/findings.h"
#include "identify/experiments/probed_vehicle.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::covered_ranges_test {
namespace {

using testing::IsEmpty;

CoveredRanges Fit() {
  CoveredRanges fit;
  fit.Add(CoveredQuantity::kBumpSpeed, "front", 0, 0.3);
  fit.Add(CoveredQuantity::kReboundSpeed, "front", 0, 0.4);
  fit.Add(CoveredQuantity::kSpringTravel, "coil", -0.02, 0.03);
  fit.Add(CoveredQuantity::kTyreLoad, "tyre", 3000, 5000);
  fit.Add(CoveredQuantity::kPostFrequency, "posts", 1, 20);
  fit.Add(CoveredQuantity::kPostAmplitude, "posts", 0.002, 0.01);
  return fit;
}

Diagnostics LeavingBy(CoveredQuantity quantity, const char* element, double lower, double upper) {
  CoveredRanges prediction;
  prediction.Add(quantity, element, lower, upper);
  Diagnostics findings;
  WarnOfLeaving(Fit(), prediction, {"other.csv"}, findings);
  return findings;
}

TEST(CoveredRanges, AreNotLeftWithinATenthOrAThirdOfAnOctave) {
  EXPECT_THAT(LeavingBy(CoveredQuantity::kBumpSpeed, "front", 0, 0.329).items(), IsEmpty());
  EXPECT_THAT(LeavingBy(CoveredQuantity::kSpringTravel, "coil", -0.0249, 0.0349).items(), IsEmpty());
  EXPECT_THAT(LeavingBy(CoveredQuantity::kTyreLoad, "tyre", 2801, 5199).items(), IsEmpty());
  EXPECT_THAT(LeavingBy(CoveredQuantity::kPostFrequency, "posts", 0.81, 23.9).items(), IsEmpty());
  EXPECT_THAT(LeavingBy(CoveredQuantity::kPostAmplitude, "posts", 0.0019, 0.0109).items(), IsEmpty());
  EXPECT_THAT(LeavingBy(CoveredQuantity::kPostAmplitude, "posts", 0, 0.0109).items(), IsEmpty());
}

TEST(CoveredRanges, AreLeftBeyond) {
  EXPECT_THAT(LeavingBy(CoveredQuantity::kBumpSpeed, "front", 0, 0.331),
              Reports(kSpeedsNotCovered, 0, {"front bump", "0.331 m/s", "0.300 m/s"}));
  EXPECT_THAT(LeavingBy(CoveredQuantity::kReboundSpeed, "front", 0, 0.45),
              Reports(kSpeedsNotCovered, 0, {"front rebound", "0.450 m/s", "0.400 m/s"}));
  EXPECT_THAT(LeavingBy(CoveredQuantity::kSpringTravel, "coil", -0.0251, 0),
              Reports(kTravelsNotCovered, 0, {"coil", "-25.1", "30.0 mm"}));
  EXPECT_THAT(LeavingBy(CoveredQuantity::kTyreLoad, "tyre", 4000, 5201),
              Reports(kLoadsNotCovered, 0, {"tyre", "5201 N", "5000 N"}));
  EXPECT_THAT(LeavingBy(CoveredQuantity::kPostFrequency, "posts", 0.79, 10),
              Reports(kFrequenciesNotCovered, 0, {"0.790", "20.0 Hz"}));
  EXPECT_THAT(LeavingBy(CoveredQuantity::kPostAmplitude, "posts", 0.001, 0.01),
              Reports(kAmplitudesNotCovered, 0, {"1.00", "10.0 mm"}));
}

TEST(CoveredRanges, SayNothingOfWhatTheFitDidNotSee) {
  EXPECT_THAT(LeavingBy(CoveredQuantity::kBumpSpeed, "rear", 0, 9).items(), IsEmpty());
  CoveredRanges prediction;
  prediction.Add(CoveredQuantity::kTyreLoad, "tyre", std::nan(""), 9);
  EXPECT_THAT(prediction.all(), IsEmpty());
}

TEST(CoveredRanges, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  folder.Write("result.json", nlohmann::ordered_json{{"covered", CoveredJson(Fit())}}.dump());
  const CoveredRanges read = ReadCovered(folder.path() / "result.json");
  const CoveredRanges written = Fit();
  ASSERT_EQ(read.all().size(), written.all().size());
  for (const CoveredRange& range : written.all()) {
    ASSERT_NE(read.Find(range.quantity, range.element), nullptr);
    EXPECT_EQ(read.Find(range.quantity, range.element)->lower, range.lower);
    EXPECT_EQ(read.Find(range.quantity, range.element)->upper, range.upper);
  }
}

// x = 10 mm sin(w t) of the strut, 5 Hz: 0.314 m/s in both directions; the tyre's load changes by 200 N.
TEST(ProbedVehicle, HasTheSpeedsTravelsAndLoadsOfASine) {
  const ProbedVehicle probed(ShippedVehicle("single_wheel_station"));
  const CondensedModel model = CondensedVehicle(probed.vehicle()).At(probed.vehicle().ParameterValues());
  const auto sensors = static_cast<Eigen::Index>(probed.vehicle().sensors.size());
  constexpr double kRate = 2000;
  Eigen::MatrixXd readings(4000, sensors);
  FrequencyResponse steady{.frequency_Hz = {5}, .amplitude_m = {0.005}, .channels = {}};
  for (Eigen::Index c = 0; c < sensors; ++c) {
    const Sensor& sensor = probed.vehicle().sensors[static_cast<std::size_t>(c)];
    const double amplitude = sensor.type == Sensor::Type::kLoadCell ? 200 : 0.01;
    for (Eigen::Index k = 0; k < readings.rows(); ++k)
      readings(k, c) = amplitude * std::sin(2 * std::numbers::pi * 5 * static_cast<double>(k) / kRate);
    steady.channels.push_back({.name = sensor.name, .unit = "", .response = {amplitude / 0.005}});
  }
  CoveredRanges in_time;
  probed.AddMotion(readings, kRate, model, in_time);
  CoveredRanges over_frequency;
  probed.AddSteady(steady, model, over_frequency);
  const double speed = 2 * std::numbers::pi * 5 * 0.01;
  const std::string damper = probed.vehicle().dampers.front().name;
  const std::string spring = probed.vehicle().springs.front().name;
  const std::string tyre = probed.vehicle().tyres.front().name;
  for (const CoveredRanges* ranges : {&in_time, &over_frequency}) {
    EXPECT_NEAR(ranges->Find(CoveredQuantity::kBumpSpeed, damper)->upper, speed, 1e-3 * speed);
    EXPECT_NEAR(ranges->Find(CoveredQuantity::kReboundSpeed, damper)->upper, speed, 1e-3 * speed);
    EXPECT_NEAR(ranges->Find(CoveredQuantity::kSpringTravel, spring)->lower, -0.01, 1e-5);
    EXPECT_NEAR(ranges->Find(CoveredQuantity::kSpringTravel, spring)->upper, 0.01, 1e-5);
    EXPECT_NEAR(ranges->Find(CoveredQuantity::kTyreLoad, tyre)->upper, model.preloads.tyre[0] + 200, 0.1);
    EXPECT_NEAR(ranges->Find(CoveredQuantity::kTyreLoad, tyre)->lower, model.preloads.tyre[0] - 200, 0.1);
  }
}

}  // namespace
}  // namespace fourpost::covered_ranges_test
