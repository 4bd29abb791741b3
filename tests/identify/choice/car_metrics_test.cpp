// Metrics of a car against its own transfer functions, and its three engines against each other.
#include "identify/choice/car_metrics.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/comfort/weighting.h"
#include "identify/choice/findings.h"
#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/linear_response.h"
#include "vehicles/description/gravity.h"
#include "vehicles/posts/road.h"

namespace fourpost::car_metrics_test {
namespace {

using Eigen::Index;

SettingsFile OneRoad(double upper_Hz = 30) {
  SettingsFile settings;
  settings.roads = {{.name = "B", .road_class = "B", .speed = 20, .weight = 1}};
  settings.upper_Hz = upper_Hz;
  return settings;
}

// The quarter car of the thesis on one post, by the trapezoidal rule over 20000 frequencies of its own response.
TEST(CarMetrics, AreIntegralsOfTheCarsResponse) {
  const Vehicle vehicle = WithLinearTyres(ShippedVehicle("quarter_car"));
  const CarMetrics car(vehicle);
  const SettingsFile settings = OneRoad();
  const Eigen::MatrixXd metrics = car.Spectra(settings)(vehicle.ParameterValues());
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const WeightingFilter weighting(Weighting::kWk);
  std::size_t body = 0;
  std::size_t load = 0;
  for (std::size_t i = 0; i < vehicle.sensors.size(); ++i) {
    if (vehicle.sensors[i].type == Sensor::Type::kLoadCell) load = i;
    if (vehicle.sensors[i].type == Sensor::Type::kAccelerometer &&
        vehicle.links[static_cast<std::size_t>(vehicle.sensors[i].point.link)].name == "sprung")
      body = i;
  }
  double comfort = 0;
  double grip = 0;
  constexpr int kSteps = 20000;
  const double step = (settings.upper_Hz - settings.lower_Hz) / kSteps;
  for (int k = 0; k <= kSteps; ++k) {
    const double f = settings.lower_Hz + k * step;
    const Eigen::MatrixXcd response = LinearResponse(model, f);
    const double share = (k == 0 || k == kSteps ? 0.5 : 1) * step * RoadDensity(*RoadRoughness("B"), 20, f);
    comfort += share * std::norm(response(static_cast<Index>(body), 0) * weighting.Response(f));
    grip += share * std::norm(response(static_cast<Index>(load), 0));
  }
  // The grid integrates to a thousandth at worst.
  EXPECT_NEAR(metrics(0, 0), std::sqrt(comfort), 1e-3 * std::sqrt(comfort));
  const double variation = std::sqrt(grip) / (222 * kGravity);
  EXPECT_NEAR(metrics(0, 1), variation, 1e-3 * variation);
}

// The thesis's poles, -3.439 +- 7.855i and -34.402 +- 97.371i.
TEST(CarMetrics, HaveTheDampingOfTheModes) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const CarMetrics car(vehicle);
  std::vector<double> ratios;
  SettingsFile settings = OneRoad();
  for (std::size_t i = 0; i < car.metrics().size(); ++i)
    if (car.metrics()[i].name.ends_with(".damping")) {
      settings.limits.push_back({.metric = i, .least = 0.1});
      EXPECT_FALSE(car.metrics()[i].is_cost);
    }
  ASSERT_EQ(settings.limits.size(), 2U);
  const Eigen::MatrixXd metrics = car.Spectra(settings)(vehicle.ParameterValues());
  for (const MetricLimit& limit : settings.limits) ratios.push_back(metrics(0, static_cast<Index>(limit.metric)));
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[0], 34.402 / std::hypot(34.402, 97.371), 1e-5);
  EXPECT_NEAR(ratios[1], 3.439 / std::hypot(3.439, 7.855), 1e-4);
}

// Change of a softer damper by spectra, by the reduced model over time and by the multibody system. A minute of a
// random road differs from its spectrum by some per cent, which the change against the same minute does not.
TEST(CarMetrics, ChangeAlikeByThreeEngines) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_rebound", 2500);
  const CarMetrics car(vehicle);
  SettingsFile settings = OneRoad();
  settings.duration_s = 20;
  std::vector<double> softer = vehicle.ParameterValues();
  for (std::size_t i = 0; i < softer.size(); ++i)
    if (vehicle.parameters[i].name.starts_with("c_")) softer[i] *= 0.8;
  const auto change = [&](const MetricsOf& metrics_of) -> Eigen::RowVectorXd {
    const Eigen::MatrixXd now = metrics_of(vehicle.ParameterValues());
    return (metrics_of(softer).row(0).array() / now.row(0).array()).head(2) - 1;
  };
  const Eigen::RowVectorXd spectra = change(car.Spectra(settings));
  const Eigen::RowVectorXd reduced = change(car.Histories(settings, CarMetrics::TimeEngine::kReduced));
  const Eigen::RowVectorXd full = change(car.Histories(settings, CarMetrics::TimeEngine::kMultibody));
  for (Index i = 0; i < 2; ++i) {
    EXPECT_GT(std::abs(spectra[i]), 0.005);
    EXPECT_NEAR(reduced[i], spectra[i], 0.002) << i;
    // All moves in a line: the reduced model is exact but for the integration's thousandth.
    EXPECT_NEAR(full[i], reduced[i], 5e-4) << i;
  }
}

TEST(CarMetrics, RefuseACarWithoutPostsAndAnUnstableSetting) {
  Vehicle without = ShippedVehicle("quarter_car");
  without.posts.clear();
  try {
    const CarMetrics car(without);
    ADD_FAILURE();
  } catch (const FaultyInput& fault) {
    EXPECT_THAT(fault.diagnostics(), Reports(kCarWithoutPosts));
  }
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const CarMetrics car(vehicle);
  std::vector<double> unstable = vehicle.ParameterValues();
  for (std::size_t i = 0; i < unstable.size(); ++i)
    if (vehicle.parameters[i].name == "k") unstable[i] = -1000;
  EXPECT_THROW(car.Spectra(OneRoad())(unstable), std::runtime_error);
}

}  // namespace
}  // namespace fourpost::car_metrics_test
