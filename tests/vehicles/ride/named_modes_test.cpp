#include "vehicles/ride/named_modes.h"

#include <gmock/gmock.h>
#include <Eigen/Eigenvalues>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/stability.h"

namespace fourpost::named_modes_test {
namespace {

using testing::HasSubstr;

struct Shaped {
  std::vector<Mode> modes;
  std::vector<BodyMotion> bodies;
};

Shaped ShapedModes(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  const Kinematics pose = DesignKinematics(vehicle);
  const Suspension suspension = SuspensionOf(vehicle, pose, values);
  return {NamedModes(vehicle, pose, suspension, CondensedVehicle(vehicle).At(values), values), suspension.bodies};
}

TEST(NamedModes, ShapesMoveTheLargestBodyByOne) {
  const Shaped shaped = ShapedModes(ShippedVehicle("quarter_car"));
  ASSERT_EQ(shaped.modes.size(), 2u);
  const std::vector<BodyShape> heave = BodyShapes(shaped.bodies, shaped.modes[0]);
  ASSERT_EQ(heave.size(), 2u);
  EXPECT_EQ(heave[1].body, "sprung");
  EXPECT_NEAR(std::abs(heave[1].translation.z() - 1.0), 0, 1e-12);  // rounding
  // The body on its coil over a tyre: the wheel moves by about k / (k + kt) = 0.061 and by more through the damper.
  EXPECT_GT(std::abs(heave[0].translation.z()), 0.06);
  EXPECT_LT(std::abs(heave[0].translation.z()), 0.12);
  EXPECT_EQ(std::abs(heave[0].rotation.x()), 0);
  const std::vector<BodyShape> hop = BodyShapes(shaped.bodies, shaped.modes[1]);
  EXPECT_NEAR(std::abs(hop[0].translation.z() - 1.0), 0, 1e-12);
}

TEST(NamedModes, AnOverdampedModeHasTwoPoles) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 4000);
  Set(vehicle, "c_rebound", 6000);
  const Shaped shaped = ShapedModes(vehicle);
  const Eigen::VectorXcd all = StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues())).eigenvalues();
  std::size_t poles = 0;
  for (const Mode& mode : shaped.modes)
    for (const std::complex<double>& pole : PolesOf(mode)) {
      ++poles;
      // Rounding of eigenvalues.
      EXPECT_LT((all.array() - pole).abs().minCoeff(), 1e-9 * std::abs(pole));
    }
  EXPECT_EQ(poles, 3u);
}

TEST(Stability, NamesTheModeThatGrows) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  EXPECT_FALSE(GrowthOf(vehicle, CondensedVehicle(vehicle).At(vehicle.ParameterValues())));
  // More than the damper's 1500 N s/m.
  vehicle.tyres[0].damping = {-2000};
  const auto growth = GrowthOf(vehicle, CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  ASSERT_TRUE(growth);
  EXPECT_GT(growth->rate_per_s, 0);
  EXPECT_THAT(growth->modes, HasSubstr("'wheel hop'"));
}

}  // namespace
}  // namespace fourpost::named_modes_test
