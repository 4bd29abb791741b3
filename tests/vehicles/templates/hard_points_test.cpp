#include "vehicles/templates/hard_points.h"

#include <gtest/gtest.h>

#include "tests/findings.h"
#include "tests/vehicles/templates/suspension_cars.h"
#include "vehicles/templates/findings.h"

namespace fourpost::hard_points_test {
namespace {

std::vector<HardPoint> Read(const std::string& text, Diagnostics& findings) {
  return HardPointsOf(text, "points.csv", findings);
}

HardPoint OnlyPoint(const std::string& text) {
  Diagnostics findings;
  const std::vector<HardPoint> points = Read(text, findings);
  EXPECT_TRUE(findings.items().empty()) << findings.Format();
  return points.at(0);
}

TEST(HardPoints, AreReadAsTablesHaveThem) {
  const Eigen::Vector3d expected(0.0011, 0.75, -0.31);
  for (const char* text : {"axle,point,x [mm],y [mm],z [mm]\nfront,contact,1.1,750,-310\n",
                           "# of a drawing\n\naxle,point,x_m,y_m,z_m\nfront,contact,0.0011,0.75,-0.31",
                           "\xef\xbb\xbf"
                           "Axle;Point;X (mm);Y (mm);Z (mm);note\r\nfront;contact;1,1;750,0;-310;a, b\r\n",
                           "axle\tpoint\t-x [mm]\t-y [mm]\tz [cm]\nfront\tcontact\t-1.1\t-750\t-31\n",
                           "point,axle,z m,y m,x mm,on,note\ncontact,front,-.31,.75,1.1,,\"a, b\"\n"}) {
    SCOPED_TRACE(text);
    const HardPoint point = OnlyPoint(text);
    EXPECT_EQ(point.axle, "front");
    EXPECT_EQ(point.name, "contact");
    EXPECT_EQ(point.xyz, expected);
  }
  EXPECT_EQ(OnlyPoint("axle,point,x [m],y [m],z [m],on\nrear,drop_link,1,2,3,knuckle\n").on, "knuckle");
}

TEST(HardPoints, ReportsEveryFaultOfAHeader) {
  Diagnostics findings;
  Read("axle,point,x [mm],y,z [kg],z [mm],colour\nfront,contact,1,2,3,4,5\n", findings);
  EXPECT_THAT(findings, Reports(kPointsUnit, 1, {"'y'"}));
  EXPECT_THAT(findings, Reports(kPointsUnit, 1, {"z [kg]"}));
  EXPECT_THAT(findings, Reports(kPointsColumnTwice, 1, {"'z'"}));
  EXPECT_THAT(findings, Reports(kPointsColumnUnknown, 1, {"colour"}));
  Diagnostics missing;
  Read("axle,point,x [mm],y [mm]\n", missing);
  EXPECT_THAT(missing, Reports(kPointsColumnMissing, 1, {"'z'"}));
}

TEST(HardPoints, ReportsEveryFaultyRow) {
  Diagnostics findings;
  Read("axle,point,x [mm],y [mm],z [mm]\nfront,contact,1,2\nfront,contact,one,2,3\nfront,contact,1,2,3,4\n", findings);
  EXPECT_THAT(findings, Reports(kPointsCells, 2, {"4", "5"}));
  EXPECT_THAT(findings, Reports(kPointsNumber, 3, {"'one'", "x [mm]"}));
  EXPECT_THAT(findings, Reports(kPointsCells, 4, {"6", "5"}));
}

TEST(HardPoints, ReportsWhatIsNoTable) {
  Diagnostics empty;
  Read("\n# nothing\n", empty);
  EXPECT_THAT(empty, Reports(kPointsWithoutHeader));
  Diagnostics headless;
  Read("front,contact,1,2,3\n", headless);
  EXPECT_THAT(headless, ReportsOnly(kPointsWithoutHeader, 1));
  Diagnostics rowless;
  Read("axle,point,x [mm],y [mm],z [mm]\n", rowless);
  EXPECT_THAT(rowless, ReportsOnly(kPointsEmpty, 1));
}

// What a template writes is what it reads.
TEST(HardPoints, ComeBackFromTheTemplate) {
  for (const SuspensionKind& kind : SuspensionKinds()) {
    SCOPED_TRACE(kind.name);
    const std::array<const SuspensionKind*, 2> kinds = {&kind, &kind};
    Diagnostics findings;
    const std::vector<HardPoint> usual = UsualPoints(kinds);
    const std::string text = PointsText(SortedPoints(kinds, usual, "", findings));
    const std::vector<HardPoint> read = Read(text, findings);
    EXPECT_TRUE(findings.items().empty()) << findings.Format();
    ASSERT_EQ(read.size(), usual.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(read[i].name, usual[i].name);
      // Rounding of sums.
      EXPECT_LT((read[i].xyz - usual[i].xyz).norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace fourpost::hard_points_test
