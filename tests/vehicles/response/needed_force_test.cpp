#include "vehicles/response/needed_force.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/response/contact_cycle.h"

namespace fourpost::needed_force_test {
namespace {

CondensedModel ModelOf(const Vehicle& vehicle) { return CondensedVehicle(vehicle).At(vehicle.ParameterValues()); }

/// Largest force that a model needs in its own motion, as a share of the largest of its inertia.
double NeededInOwnMotion(const CondensedModel& model, double frequency_Hz, double amplitude_m) {
  const std::vector<double> shape(static_cast<std::size_t>(model.post_stiffness.cols()), 1);
  ContactCycle cycle(model, shape, {});
  EXPECT_TRUE(cycle.Solve(frequency_Hz, amplitude_m));
  const Eigen::Index n = model.mass.rows();
  const Eigen::MatrixXcd motion = cycle.cycle().Coordinates(NeededForce::kHarmonics).leftCols(n);
  NeededForce needed(model, shape);
  const auto force = needed.At(frequency_Hz, amplitude_m, motion);
  EXPECT_TRUE(force.has_value());
  const double w = cycle.cycle().omega();
  const Eigen::VectorXcd inertia = w * w * model.mass.cast<std::complex<double>>() * motion.row(1).transpose();
  return force->cwiseAbs().maxCoeff() / inertia.cwiseAbs().maxCoeff();
}

// The balance errs by 2e-4 of a response where harmonics end; friction's step is sampled otherwise here.
constexpr double kBalance = 2e-3;

TEST(NeededForce, AVehicleNeedsNoneInItsOwnMotion) {
  for (const QuarterCar& car : {ThesisCar(), BilinearCar(), SeriesCar()})
    for (const double frequency : {0.7, 1.5, 6.0, 14.0})
      EXPECT_LT(NeededInOwnMotion(ModelOf(Describe(car)), frequency, 5e-3), kBalance) << frequency;
  for (const char* name : {"landrover110_model1", "landrover110_model3", "quarter_car"})
    for (const double frequency : {0.7, 3.0, 12.0})
      EXPECT_LT(NeededInOwnMotion(ModelOf(ShippedVehicle(name)), frequency, 5e-3), kBalance) << name << frequency;
}

TEST(NeededForce, FrictionIsNeededWhereItIsLeftOut) {
  Vehicle rubbing = Describe(BilinearCar());
  const CondensedModel plain = ModelOf(rubbing);
  rubbing.dampers[0].law.friction = DashpotDescription::Friction{.force = {30}, .speed = {2e-3}};
  const CondensedModel model = ModelOf(rubbing);
  ContactCycle cycle(model, {1}, {});
  ASSERT_TRUE(cycle.Solve(2, 0.01));
  const Eigen::MatrixXcd motion = cycle.cycle().Coordinates(NeededForce::kHarmonics).leftCols(2);
  NeededForce needed(plain, {1});
  const Eigen::VectorXcd force = needed.At(2, 0.01, motion).value();
  // Minus the tension along the damper's line, 4 / pi times 30 N against its speed.
  const Eigen::VectorXd& direction = plain.dashpots[0].direction;
  const std::complex<double> rate =
      std::complex<double>(0, cycle.cycle().omega()) * (motion.row(1) * direction.cast<std::complex<double>>())(0);
  const Eigen::VectorXcd expected = -direction.cast<std::complex<double>>() * (38.197 * rate / std::abs(rate));
  // Overtones of the motion shift the reversals a little, and its transition is not a step.
  EXPECT_LT((force - expected).norm(), 0.03 * expected.norm());
}

/// Largest difference of the slope from differences of the whole force, over the slope's size.
double SlopeError(const CondensedModel& model, double frequency_Hz) {
  const std::vector<double> shape(static_cast<std::size_t>(model.post_stiffness.cols()), 1);
  constexpr double kAmplitude = 5e-3;
  constexpr double kStep = 1e-6;
  ContactCycle cycle(model, shape, {});
  EXPECT_TRUE(cycle.Solve(frequency_Hz, kAmplitude));
  const Eigen::Index n = model.mass.rows();
  const Eigen::MatrixXcd motion = cycle.cycle().Coordinates(NeededForce::kHarmonics).leftCols(n);
  NeededForce needed(model, shape);
  const int samples = needed.SamplesFor(frequency_Hz, kAmplitude, motion);
  const Eigen::MatrixXd slope = needed.Slope(frequency_Hz, kAmplitude, motion, samples, kStep).value();
  const auto force = [&](Eigen::Index j, double step) {
    Eigen::MatrixXcd moved = motion;
    moved(1, j % n) += j < n ? std::complex<double>(step, 0) : std::complex<double>(0, step);
    const Eigen::VectorXcd complex = needed.At(frequency_Hz, kAmplitude, moved, samples).value();
    Eigen::VectorXd all(2 * n);
    all << complex.real(), complex.imag();
    return all;
  };
  double largest = 0;
  for (Eigen::Index j = 0; j < 2 * n; ++j) {
    const Eigen::VectorXd found = (force(j, kStep) - force(j, -kStep)) / (2 * kStep);
    largest = std::max(largest, (slope.col(j) - found).norm() / found.norm());
  }
  return largest;
}

// Forward and central differences of 1e-6 in some 5e-3 m differ by 2e-4 of a law's curvature; the iteration leaves 1e-6
// of the extension, which is 5e-3 of the step where a series spring takes part.
TEST(NeededForce, SlopeIsThatOfTheWholeForce) {
  for (const QuarterCar& car : {ThesisCar(), BilinearCar()})
    for (const double frequency : {0.7, 6.0}) EXPECT_LT(SlopeError(ModelOf(Describe(car)), frequency), 1e-3);
  for (const double frequency : {0.7, 6.0}) EXPECT_LT(SlopeError(ModelOf(Describe(SeriesCar())), frequency), 1e-2);
  for (const char* name : {"landrover110_model1", "landrover110_model3"})
    for (const double frequency : {0.7, 3.0, 12.0})
      EXPECT_LT(SlopeError(ModelOf(ShippedVehicle(name)), frequency), 1e-2) << name << frequency;
}

// A knee of the mount and the dashpot behind it share a coordinate, so that one's force changes the other's.
TEST(NeededForce, SlopeOfAHardeningMountToo) {
  Vehicle car = Describe(SeriesCar());
  ASSERT_TRUE(car.dampers.at(0).series.has_value());
  car.dampers[0].series->cubic = {1e12};
  EXPECT_LT(SlopeError(ModelOf(car), 6), 1e-2);
}

// The answer does not depend on where the iteration starts.
TEST(NeededForce, StartsWhereAnotherOneEnded) {
  const CondensedModel model = ModelOf(ShippedVehicle("landrover110_model3"));
  const std::vector<double> shape(static_cast<std::size_t>(model.post_stiffness.cols()), 1);
  ContactCycle cycle(model, shape, {});
  ASSERT_TRUE(cycle.Solve(3, 5e-3));
  const Eigen::MatrixXcd motion = cycle.cycle().Coordinates(NeededForce::kHarmonics).leftCols(model.mass.rows());
  NeededForce needed(model, shape);
  const int samples = needed.SamplesFor(3, 5e-3, motion);
  const Eigen::VectorXcd plain = needed.At(3, 5e-3, motion, samples).value();
  const Eigen::VectorXcd started = needed.At(3, 5e-3, motion, samples, 1.1 * needed.Yielded()).value();
  // The iteration's tolerance is 1e-6 of the extensions, whose elements' forces are several times inertia.
  EXPECT_LT((started - plain).norm(), 1e-4 * model.mass.norm() * motion.row(1).norm() * 19 * 19);
}

// A damper that is alike in bump and rebound is linear, and no port; one next to it is.
TEST(NeededForce, TakesNoStartOfOtherPorts) {
  const auto model_with = [](double rebound) {
    Vehicle car = Describe(BilinearCar());
    car.dampers[0].law.compression = {1000};
    car.dampers[0].law.rebound = {rebound};
    return ModelOf(car);
  };
  const CondensedModel alike = model_with(1000);
  const CondensedModel bilinear = model_with(1500);
  ContactCycle cycle(bilinear, {1}, {});
  ASSERT_TRUE(cycle.Solve(2, 0.01));
  const Eigen::MatrixXcd motion = cycle.cycle().Coordinates(NeededForce::kHarmonics).leftCols(2);
  NeededForce first(alike, {1});
  NeededForce second(bilinear, {1});
  const int samples = second.SamplesFor(2, 0.01, motion);
  const Eigen::VectorXcd linear = first.At(2, 0.01, motion, samples).value();
  const Eigen::VectorXcd plain = second.At(2, 0.01, motion, samples, first.Yielded()).value();
  // Nothing is iterated here, so that the answers are the same.
  EXPECT_EQ(first.At(2, 0.01, motion, samples, second.Yielded()).value(), linear);
  EXPECT_EQ(second.At(2, 0.01, motion, samples).value(), plain);
}

}  // namespace
}  // namespace fourpost::needed_force_test
