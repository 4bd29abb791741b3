#include "vehicles/templates/axle_points.h"

#include <gtest/gtest.h>

#include "tests/findings.h"
#include "tests/vehicles/templates/suspension_cars.h"
#include "vehicles/templates/findings.h"

namespace fourpost::axle_points_test {
namespace {

using suspension_cars::KindsOf;

TEST(AxlePoints, NamesEveryFaultOfTheChoice) {
  const auto faults = [](const std::vector<std::string>& choices) {
    Diagnostics findings;
    EXPECT_FALSE(ChosenSuspensions(choices, findings));
    return findings;
  };
  EXPECT_THAT(faults({"macpherson"}), ReportsOption(kSuspensionMalformed, "--suspension", {"macpherson"}));
  EXPECT_THAT(faults({"middle=macpherson"}), ReportsOption(kSuspensionAxle, "--suspension", {"middle"}));
  EXPECT_THAT(faults({"front=macferson", "rear=a_frame"}),
              ReportsOption(kSuspensionKindUnknown, "--suspension", {"macferson", "macpherson"}));
  EXPECT_THAT(faults({"front=macpherson", "front=a_frame"}),
              ReportsOption(kSuspensionTwice, "--suspension", {"front"}));
  EXPECT_THAT(faults({"front=macpherson"}), ReportsOption(kSuspensionMissing, "--suspension", {"rear"}));
  Diagnostics none;
  const auto kinds = ChosenSuspensions({"rear=a_frame", "front=macpherson"}, none);
  ASSERT_TRUE(kinds);
  EXPECT_EQ((*kinds)[0]->name, "macpherson");
  EXPECT_EQ((*kinds)[1]->name, "a_frame");
}

TEST(AxlePoints, TakesUsualSpellingsOfAKind) {
  for (const char* name : {"McPherson", "macpherson_strut", "Mac Pherson", "MCPHERSON-STRUT", "macpherson struts"}) {
    ASSERT_NE(FindSuspensionKind(name), nullptr) << name;
    EXPECT_EQ(FindSuspensionKind(name)->name, "macpherson") << name;
  }
  EXPECT_EQ(FindSuspensionKind("leafspring"), FindSuspensionKind("leaf_spring"));
  EXPECT_EQ(FindSuspensionKind("strut"), nullptr);
  EXPECT_EQ(FindSuspensionKind(""), nullptr);
}

/// The table of a car with double wishbones and a twist beam, lines as in the file, and one change.
class ChangedPoints {
 public:
  ChangedPoints() : points_(UsualPoints(kinds_)) {
    for (std::size_t i = 0; i < points_.size(); ++i) points_[i].line = static_cast<int>(i) + 2;
  }
  HardPoint& At(const std::string& axle, const std::string& name) {
    for (HardPoint& point : points_)
      if (point.axle == axle && point.name == name) return point;
    throw std::out_of_range(name);
  }
  int LineOf(const std::string& axle, const std::string& name) { return At(axle, name).line; }
  void Remove(const std::string& axle, const std::string& name) {
    std::erase_if(points_, [&](const HardPoint& p) { return p.axle == axle && p.name == name; });
  }
  void Add(const HardPoint& point) { points_.push_back(point); }
  Diagnostics Findings() {
    Diagnostics findings;
    SortedPoints(kinds_, points_, "points.csv", findings);
    return findings;
  }

 private:
  std::array<const SuspensionKind*, 2> kinds_ = KindsOf("double_wishbone", "twist_beam");
  std::vector<HardPoint> points_;
};

TEST(AxlePoints, AcceptsTheUsualOnes) { EXPECT_TRUE(ChangedPoints().Findings().items().empty()); }

TEST(AxlePoints, ReportsAllFaultsAtOnce) {
  ChangedPoints points;
  const int side = points.LineOf("front", "tie_outer");
  points.At("front", "tie_outer").xyz.y() *= -1;
  points.Remove("rear", "pivot");
  points.Add({.axle = "rear", .name = "pivt", .xyz = {-2.2, 0.5, 0.3}, .line = 90});
  points.Add({.axle = "middle", .name = "contact", .xyz = {-2.2, 0.5, 0.3}, .line = 91});
  points.Add({.axle = "front", .name = "contact", .xyz = {0, 0.75, 0}, .line = 92});
  const Diagnostics findings = points.Findings();
  EXPECT_THAT(findings, Reports(kPointSide, side, {"tie_outer", "-690 mm"}));
  EXPECT_THAT(findings, Reports(kPointMissing, 0, {"pivot", "rear,pivot,X,Y,Z"}));
  EXPECT_THAT(findings, Reports(kPointUnknown, 90, {"pivt", "did you mean 'pivot'"}));
  EXPECT_THAT(findings, Reports(kSuspensionAxle, 91, {"middle"}));
  EXPECT_THAT(findings, Reports(kPointTwice, 92, {"contact", std::to_string(points.LineOf("front", "contact"))}));
  EXPECT_EQ(findings.items().size(), 5u);
}

TEST(AxlePoints, ReportsLinksAndArmsWithoutLength) {
  ChangedPoints points;
  points.At("front", "tie_outer").xyz = points.At("front", "tie_inner").xyz;
  points.At("front", "upper_ball").xyz =
      0.5 * (points.At("front", "upper_front").xyz + points.At("front", "upper_rear").xyz);
  const Diagnostics findings = points.Findings();
  EXPECT_THAT(findings, Reports(kLinkWithoutLength, points.LineOf("front", "tie_inner"), {"tie_outer", "0 mm"}));
  EXPECT_THAT(findings, Reports(kArmWithoutLength, points.LineOf("front", "upper_ball"), {"upper_front"}));
  EXPECT_EQ(findings.items().size(), 2u);
}

TEST(AxlePoints, ReportsAPointBesideThePlaneOfSymmetry) {
  ChangedPoints points;
  points.At("rear", "shear_centre").xyz.y() = 0.1;
  EXPECT_THAT(points.Findings(), ReportsOnly(kPointSide, points.LineOf("rear", "shear_centre"), {"100 mm"}));
}

TEST(AxlePoints, ReportsHalfOfAPair) {
  ChangedPoints points;
  points.Remove("front", "drop_link");
  EXPECT_THAT(points.Findings(), ReportsOnly(kPointPartnerMissing, points.LineOf("front", "bar_end"), {"drop_link"}));
}

TEST(AxlePoints, ReportsACarrierThatIsNone) {
  ChangedPoints points;
  points.At("front", "spring_bottom").on = "upper_am";
  points.At("front", "lower_ball").on = "knuckle";
  const Diagnostics findings = points.Findings();
  EXPECT_THAT(findings, Reports(kPointCarrier, points.LineOf("front", "spring_bottom"), {"did you mean 'upper_arm'"}));
  EXPECT_THAT(findings, Reports(kPointCarrier, points.LineOf("front", "lower_ball"), {"knuckle"}));
}

TEST(AxlePoints, ReportsANumberThatIsFarOff) {
  ChangedPoints points;
  points.At("rear", "pivot").xyz.x() = -2.2e300;
  EXPECT_THAT(points.Findings(), ReportsOnly(kPointFar, points.LineOf("rear", "pivot"), {"pivot"}));
}

TEST(AxlePoints, ReportsAWheelAxisThatPointsInward) {
  ChangedPoints points;
  points.Add({.axle = "front", .name = "wheel_axis", .xyz = {0, 0.65, 0.31}, .line = 90});
  EXPECT_THAT(points.Findings(), ReportsOnly(kWheelAxisInboard, 90, {"100 mm"}));
  ChangedPoints same;
  same.Add({.axle = "front", .name = "wheel_axis", .xyz = same.At("front", "wheel_centre").xyz, .line = 90});
  EXPECT_THAT(same.Findings(), ReportsOnly(kLinkWithoutLength, 90, {"wheel_axis", "wheel_centre"}));
}

// 8 mm over 310 mm are 1.5 degrees of camber, which the axis has to state.
TEST(AxlePoints, WarnsOfAContactBesideTheWheel) {
  ChangedPoints points;
  const Eigen::Vector3d contact = points.At("front", "contact").xyz;
  points.At("front", "contact").xyz.y() += 0.008;
  EXPECT_THAT(points.Findings(), ReportsOnly(kContactBeside, points.At("front", "contact").line, {"front", "8 mm"}));
  const Eigen::Vector3d centre = points.At("front", "wheel_centre").xyz;
  const double slope = 0.008 / (centre.z() - contact.z());
  points.Add({.axle = "front", .name = "wheel_axis", .xyz = centre + Eigen::Vector3d(0, 0.1, 0.1 * slope), .line = 90});
  EXPECT_EQ(points.Findings().Format(), "");
}

// Such an axle moves sideways until its tyres stop it.
TEST(AxlePoints, ReportsFourLinksThatAreParallel) {
  const auto kinds = KindsOf("macpherson", "four_link");
  std::vector<HardPoint> points = UsualPoints(kinds);
  for (HardPoint& point : points)
    if (point.axle == "rear" && point.name.starts_with("upper")) point.xyz.y() = 0.42;
  Diagnostics findings;
  SortedPoints(kinds, points, "points.csv", findings);
  EXPECT_THAT(findings, ReportsOnly(kLinksParallel, 0, {"rear", "4.8 deg"}));
}

// Millimetres that were said to be metres, and the other way round.
TEST(AxlePoints, ReportsAWrongUnitByTheSizeOfTheTyre) {
  for (const double scale : {1e3, 1e-3}) {
    ChangedPoints points;
    for (const char* name : {"wheel_centre", "contact"}) points.At("front", name).xyz *= scale;
    EXPECT_THAT(points.Findings(), Reports(kTyreSize, points.LineOf("front", "contact"), {"front"}));
  }
}

TEST(AxlePoints, ReportsAnAxisThatPointsBack) {
  ChangedPoints points;
  points.At("rear", "wheel_centre").xyz.x() *= -1;
  EXPECT_THAT(points.Findings(), Reports(kAxleOrder, points.LineOf("rear", "wheel_centre"), {"2600 mm"}));
}

}  // namespace
}  // namespace fourpost::axle_points_test
