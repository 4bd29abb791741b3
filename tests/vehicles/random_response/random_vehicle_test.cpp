#include "vehicles/random_response/random_vehicle.h"

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/state_space.h"
#include "vehicles/posts/band_noise.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost::random_vehicle_test {
namespace {

using std::numbers::pi;

CondensedModel ModelOf(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

/// Mean square of each row of amplitudes.
Eigen::VectorXd Variances(const Eigen::MatrixXcd& amplitudes, const SpectralGrid& grid, Eigen::Index sources) {
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(amplitudes.rows());
  for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(grid.size()); ++k)
    variances += grid.share_Hz[static_cast<std::size_t>(k)] *
                 amplitudes.middleCols(k * sources, sources).cwiseAbs2().rowwise().sum();
  return variances;
}

RandomResponse OnRoad(const Vehicle& vehicle, double roughness, double speed, const SpectralGrid& grid) {
  return RandomVehicle(ModelOf(vehicle), grid).Solve(RoadSpectra(RoadTracksOf(vehicle), roughness, speed, grid));
}

// A road of white velocity without limits of its band: the covariance P of a linear system x' = A x + B z' solves
// A P + P A' + B B' W = 0 with the two-sided intensity W = (2 pi)^2 G n0^2 v / 2 of z'. Here by one linear system.
TEST(RandomVehicle, HasTheVariancesOfLyapunovsEquation) {
  const Vehicle car = Describe(ThesisCar());
  const QuarterCar numbers = ThesisCar();
  // Strut's extension, body's velocity, tyre's deflection z_wheel - z, wheel's velocity.
  const double ms = numbers.sprung_mass;
  const double mu = numbers.unsprung_mass;
  const double k = numbers.stiffness;
  const double kt = numbers.tyre_stiffness;
  const double c = 1500;
  Eigen::Matrix4d a;
  a << 0, 1, 0, -1, -k / ms, -c / ms, 0, c / ms, 0, 0, 0, 1, k / mu, c / mu, -kt / mu, -c / mu;
  const Eigen::Vector4d b(0, 0, -1, 0);
  const double roughness = 64e-6;
  const double speed = 20;
  const double intensity = std::pow(2 * pi, 2) * roughness * 0.01 * speed / 2;
  Eigen::MatrixXd kronecker = Eigen::MatrixXd::Zero(16, 16);
  for (Eigen::Index i = 0; i < 4; ++i) {
    kronecker.block(4 * i, 4 * i, 4, 4) += a;
    for (Eigen::Index j = 0; j < 4; ++j) kronecker.block(4 * i, 4 * j, 4, 4) += a(i, j) * Eigen::Matrix4d::Identity();
  }
  const Eigen::Matrix4d source = -intensity * b * b.transpose();
  const Eigen::VectorXd solution = kronecker.fullPivLu().solve(source.reshaped());
  const Eigen::Matrix4d covariance = solution.reshaped(4, 4);
  const Eigen::RowVector4d body_acceleration = a.row(1);
  const double acceleration = std::sqrt(body_acceleration * covariance * body_acceleration.transpose());
  const double load = kt * std::sqrt(covariance(2, 2));
  const double travel = std::sqrt(covariance(0, 0));

  // The load's density falls as 1/f^2 without tyre damping: 1e-4 lies above 20 kHz.
  const SpectralGrid grid = SpectralGrid::For(1e-3, 2e4, 0);
  const RandomResponse response = OnRoad(car, roughness, speed, grid);
  const Eigen::VectorXd variances = Variances(response.readings, grid, 1);
  std::map<std::string, double> deviations;
  for (std::size_t i = 0; i < car.sensors.size(); ++i)
    deviations[car.sensors[i].name] = std::sqrt(variances[static_cast<Eigen::Index>(i)]);
  EXPECT_NEAR(deviations.at("a_sprung"), acceleration, 1e-4 * acceleration);
  EXPECT_NEAR(deviations.at("s_strut"), travel, 1e-4 * travel);
  EXPECT_NEAR(deviations.at("F_tyre"), load, 2e-4 * load);
}

/// A fixed point is the linear vehicle of its own gains.
TEST(RandomVehicle, SolvesTheVehicleOfItsGains) {
  const Vehicle car = WithLinearTyres(ShippedVehicle("landrover110_linkage"));
  CondensedModel model = ModelOf(car);
  const DashpotLaw law = DashpotLaw::Digressive(2000, 6000, {0.1, 600}, {0.1, 1000}).WithFriction(80, 2e-3);
  for (CondensedModel::Dashpot& dashpot : model.dashpots) dashpot.law = law;
  const SpectralGrid grid = SpectralGrid::For(0.5, 30, 2.794 / 16.7, 0.05);
  const PostSpectra road = RoadSpectra(RoadTracksOf(car), 256e-6, 16.7, grid);
  const RandomResponse response = RandomVehicle(model, grid).Solve(road, {.tolerance = 1e-8});
  ASSERT_TRUE(response.converged);
  CondensedModel linear = model;
  for (std::size_t j = 0; j < model.dashpots.size(); ++j) {
    const double rate = model.dashpots[j].CentreRate() + response.gains[j].by_rate;
    // A friction's transition makes the centre rate huge; the equivalent is that of a damper.
    EXPECT_GT(rate, 500);
    EXPECT_LT(rate, 6000);
    linear.dashpots[j].law = DashpotLaw(rate, rate);
  }
  const RandomResponse same = RandomVehicle(linear, grid).Solve(road);
  const Eigen::VectorXd expected = Variances(same.readings, grid, 1);
  const Eigen::VectorXd variances = Variances(response.readings, grid, 1);
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(std::sqrt(variances[i] / expected[i]), 1, 1e-7) << car.sensors[static_cast<std::size_t>(i)].name;
  }
}

TEST(RandomVehicle, RefusesOtherPostsAndFrequencies) {
  const Vehicle car = ShippedVehicle("landrover110_linkage");
  const SpectralGrid grid = SpectralGrid::For(0.5, 30, 0.1);
  const RandomVehicle vehicle(ModelOf(car), grid);
  const RoadTracks four = RoadTracksOf(ShippedVehicle("landrover110_model3"));
  EXPECT_THROW(vehicle.Solve(RoadSpectra(four, 1e-5, 20, grid)), std::invalid_argument);
  const SpectralGrid other = SpectralGrid::For(0.5, 20, 0.1);
  EXPECT_THROW(vehicle.Solve(RoadSpectra(RoadTracksOf(car), 1e-5, 20, other)), std::invalid_argument);
  EXPECT_THROW(RoadSpectra(RoadTracksOf(car), 1e-5, 0, grid), std::invalid_argument);
  EXPECT_THROW(SpectralGrid::For(2, 1, 0), std::invalid_argument);
  EXPECT_THROW(SpectralGrid::For(0, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::random_vehicle_test
