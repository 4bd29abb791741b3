#include "vehicles/lint/table_lint.h"

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::table_lint_test {
namespace {

const std::string kLinear =
    R"(<fp:spring name="coil_left" parent="top_left" child="wheel_left"><linear stiffness="30 kN/m"/></fp:spring>)";
const std::string kRates = R"(<bilinear bump="1000 N*s/m" rebound="2000 N*s/m"/>)";

std::string WithSpring(const std::string& table) {
  std::string spring = Replaced(kLinear, R"(<linear stiffness="30 kN/m"/>)", table);
  return Replaced(kAxle, kLinear, spring);
}

// Half of 500 kg x 9.80665 m/s^2 is carried by each coil: 2.45 kN.
TEST_F(VehicleLintTest, AsksForThePlaceOnASpringsTable) {
  const std::string points = R"(<point extension="-150 mm" force="-4.5 kN"/><point extension="0 mm" force="0 N"/>)";
  const std::string text = WithSpring("<table>" + points + "</table>");
  Look(text);
  ExpectWarning(text, R"(<fp:spring name="coil_left")", kTableNotPlaced,
                {"fp:spring 'coil_left'", "2.45 kN", "-81.7 mm"});
  Look(WithSpring("<table at=\"-81.7 mm\">" + points + "</table>"));
  Look(WithSpring("<table at=\"0 mm\">" + points + "</table>"));
}

TEST_F(VehicleLintTest, AsksForNoPlaceWhereTheTableHasTheLoadAtItsZero) {
  Look(WithSpring(
      R"(<table><point extension="-50 mm" force="-4 kN"/><point extension="50 mm" force="-900 N"/></table>)"));
}

// (250 + 40) kg x 9.80665 m/s^2 on each tyre: 2.84 kN.
TEST_F(VehicleLintTest, TellsOfTyresWhoseCurveDoesNotReachTheirLoad) {
  const auto on_table = [](const std::string& end) {
    return Replaced(kAxle,
                    R"(<fp:tyre name="tyre_left" link="wheel_left" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m"/>)",
                    R"(<fp:tyre name="tyre_left" link="wheel_left" xyz="0 0 0" radius="0.3 m"><table>
<point deflection="0 mm" force="0 N"/><point deflection="14 mm" force=")" +
                        end + R"("/></table></fp:tyre>)");
  };
  const std::string text = on_table("2.8 kN");
  Look(text);
  ExpectWarning(text, R"(<fp:tyre name="tyre_left")", kTyreTableEnd, {"fp:tyre 'tyre_left'", "2.84 kN", "2.8 kN"});
  Look(on_table("2.9 kN"));
}

TEST_F(VehicleLintTest, TellsOfDampersWithAForceAtRest) {
  const std::string text = Replaced(
      kAxle, kRates, R"(<table><point speed="-0.1 m/s" force="-50 N"/><point speed="0.1 m/s" force="150 N"/></table>)");
  Look(text);
  ExpectWarning(text, R"(<fp:damper name="damper_left")", kTableAtRest, {"fp:damper 'damper_left'", "50 N"});
  // As bump and rebound of a damper differ, stated so.
  Look(Replaced(kAxle, kRates,
                R"(<table><point speed="-0.1 m/s" force="-50 N"/><point speed="0 m/s" force="0 N"/>
                   <point speed="0.1 m/s" force="150 N"/></table>)"));
}

}  // namespace
}  // namespace fourpost::table_lint_test
