#include "vehicles/lint/vehicle_lint.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::vehicle_lint_test {
namespace {

TEST(VehicleLint, FindsNothingInTheShippedVehicles) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf"))
    if (entry.path().extension() == ".urdf") {
      EXPECT_EQ(Lint(ShippedVehicle(entry.path().stem())).Format(), "");
      ++count;
    }
  EXPECT_GE(count, 5);
}

TEST_F(VehicleLintTest, FindsNothingInASoundDescription) { Look(kAxle); }

// A preload that nothing balances keeps the car from being assembled, but not from being looked at.
TEST_F(VehicleLintTest, LooksAtDescriptionsThatDoNotStand) {
  const std::optional<Vehicle> vehicle = Read(
      Replaced(kAxle, R"(name="tyre_right" link="wheel_right" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m")",
               R"(name="tyre_right" link="wheel_right" xyz="0 0 0" radius="0.3 m" stiffness="200 N/m" preload="9 N")"));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_THROW(LintAssembled(*vehicle), FaultyInput);
  EXPECT_THAT(LintDescription(*vehicle), Reports(kNumberUnusual, {"200 kN/m"}));
}

TEST_F(VehicleLintTest, TellsOfAParameterThatChangesNothing) {
  const std::string parameter = R"(<fp:parameter name="I_wheel" value="1 kg*m^2" source="estimate">)"
                                R"(<fp:bind to="link[wheel_left]/inertia/izz"/></fp:parameter>)";
  const std::string text = Replaced(kAxle, "</robot>", parameter + "\n</robot>");
  Look(text);
  ExpectWarning(text, parameter, kParameterIdle, {"fp:parameter 'I_wheel'"});
}

// What the condensed model does not know of may matter to the march.
TEST_F(VehicleLintTest, LeavesParametersOfCurvedLawsAlone) {
  Look(Replaced(kAxle, "</robot>", R"(<fp:parameter name="gap" value="60 mm" source="estimate"/>
<fp:stop name="stop" parent="top_left" child="wheel_left"><bump gap="$gap" stiffness="200 kN/m"/></fp:stop></robot>)"));
}

}  // namespace
}  // namespace fourpost::vehicle_lint_test
