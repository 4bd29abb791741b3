#include "vehicles/lint/symmetry_lint.h"

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::symmetry_lint_test {
namespace {

TEST_F(VehicleLintTest, TellsOfPointsThatAreNearlyMirrored) {
  const std::string text = Replaced(kAxle, R"(<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>)",
                                    R"(<fp:frame name="top_right" link="body" xyz="0.012 -0.7 0"/>)");
  Look(text);
  ExpectWarning(text, R"(<fp:spring name="coil_right")", kMirrorPoint,
                {"parent's end", "fp:spring 'coil_right'", "12 mm", "fp:spring 'coil_left'",
                 "line " + std::to_string(LineOf(text, "<fp:spring name=\"coil_left\""))});
}

TEST_F(VehicleLintTest, LetsSidesDifferThatAreNotMeantToBeMirrored) {
  Look(Replaced(kAxle, R"(<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>)",
                R"(<fp:frame name="top_right" link="body" xyz="0.2 -0.7 0"/>)"));
  EXPECT_EQ(diagnostics_.Format(), "");
  // Printed to a tenth of a millimetre.
  Look(Replaced(kAxle, R"(<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>)",
                R"(<fp:frame name="top_right" link="body" xyz="0 -0.70005 0"/>)"));
}

TEST_F(VehicleLintTest, TellsOfNumbersThatDifferByATypingSlip) {
  const std::string text = Replaced(kAxle, "999 N*s/m", "99.9 N*s/m");
  Look(text);
  ExpectWarning(text, R"(<fp:damper name="damper_right")", kMirrorNumber,
                {"bump rate", "fp:damper 'damper_right'", "fp:damper 'damper_left'", "99.9 N*s/m"});
}

TEST_F(VehicleLintTest, TellsOfACoilAtHalfTheOthersRate) {
  const std::string at = R"(<fp:spring name="coil_right" parent="top_right" child="wheel_right">)";
  const std::string text =
      Replaced(kAxle, at + R"(<linear stiffness="30 kN/m"/>)", at + R"(<linear stiffness="15 kN/m"/>)");
  Look(text);
  ExpectWarning(text, at, kMirrorNumber, {"stiffness", "fp:spring 'coil_right'", "fp:spring 'coil_left'", "15 kN/m"});
}

TEST_F(VehicleLintTest, LetsTypedNumbersOfBothSidesDifferByRounding) {
  Look(Replaced(kAxle, "999 N*s/m", "991 N*s/m"));
  const std::string text = Replaced(kAxle, "999 N*s/m", "989 N*s/m");
  Look(text);
  ExpectWarning(text, R"(<fp:damper name="damper_right")", kMirrorNumber, {"parameters"});
}

TEST_F(VehicleLintTest, LetsParametersOfBothSidesDifferByHalf) {
  const auto text = [](const std::string& value) {
    return Replaced(Replaced(kAxle, "999 N*s/m", "$c"), "</robot>",
                    "<fp:parameter name=\"c\" value=\"" + value + "\" source=\"fit\"/></robot>");
  };
  Look(text("670 N*s/m"));
  Look(text("660 N*s/m"));
  ExpectWarning(text("660 N*s/m"), R"(<fp:damper name="damper_right")", kMirrorNumber,
                {"bump rate", "fp:damper 'damper_right'"});
}

/// The axle with a table for each damper.
std::string WithTables(const std::string& left, const std::string& right) {
  const std::string text =
      Replaced(kAxle, R"(<bilinear bump="1000 N*s/m" rebound="2000 N*s/m"/>)", "<table>" + left + "</table>");
  return Replaced(text, R"(<bilinear bump="999 N*s/m" rebound="2000 N*s/m"/>)", "<table>" + right + "</table>");
}

/// From -0.4 to 0.4 m/s.
std::string Points(double rebound_factor) {
  std::string points;
  for (int i = -8; i <= 8; ++i)
    points += "<point speed=\"" + std::to_string(0.05 * i) + " m/s\" force=\"" +
              std::to_string(i * (i > 0 ? rebound_factor : 1) * 60) + " N\"/>";
  return points;
}

// Each point is compared with its own partner, not with every other one.
TEST_F(VehicleLintTest, LetsTablesOfBothSidesBeTheSame) { Look(WithTables(Points(2), Points(2))); }

TEST_F(VehicleLintTest, TellsOnceOfTablesThatDiffer) {
  const std::string text = WithTables(Points(2), Points(2.5));
  Look(text);
  ExpectWarning(text, R"(<fp:damper name="damper_right")", kMirrorNumber,
                {"force in the table", "fp:damper 'damper_right'", "fp:damper 'damper_left'", "150 N"});
}

TEST_F(VehicleLintTest, TellsOfABarWithBothLinesOnOneSide) {
  const std::string text = Replaced(kAxle, R"(<right parent="body" child="wheel_right"/>)",
                                    R"(<right parent="top_left" child="wheel_left"/>)");
  Look(text);
  ExpectWarning(text, "<fp:antiroll", kBarSide, {"fp:antiroll 'bar'"});
}

}  // namespace
}  // namespace fourpost::symmetry_lint_test
