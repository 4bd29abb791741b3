#include "vehicles/response/needed_force.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/response/contact_cycle.h"

namespace fourpost {
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

}  // namespace
}  // namespace fourpost
