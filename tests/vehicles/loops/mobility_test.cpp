#include "vehicles/loops/mobility.h"

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/loops/findings.h"

namespace fourpost::mobility_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string Body(const std::string& name, double mass) {
  const std::string moment = std::to_string(0.1 * mass);
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + std::to_string(mass) + "\"/><inertia ixx=\"" +
         moment + "\" iyy=\"" + moment + "\" izz=\"" + moment +
         "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n";
}

std::string Joined(const std::string& parent, const std::string& child, const std::string& type, const std::string& xyz,
                   const std::string& axis = "0 1 0") {
  return "<joint name=\"" + child + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/><origin xyz=\"" + xyz + "\"/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-1\" upper=\"1\" effort=\"0\" velocity=\"0\"/></joint>\n";
}

/// A closure between two points, each given as "link x y z".
std::string Closed(const std::string& tag, const std::string& name, const std::string& parent, const std::string& child,
                   const std::string& more = "") {
  const auto frame = [](const std::string& end, const std::string& point) {
    const std::size_t blank = point.find(' ');
    return "<fp:frame name=\"" + end + "\" link=\"" + point.substr(0, blank) + "\" xyz=\"" + point.substr(blank + 1) +
           "\"/>";
  };
  return frame(name + "_a", parent) + frame(name + "_b", child) + "\n<fp:" + tag + " name=\"" + name + "\" parent=\"" +
         name + "_a\" child=\"" + name + "_b\" " + more + "/>\n";
}

std::string Tyre(const std::string& name, const std::string& link, const std::string& xyz) {
  return "<fp:tyre name=\"" + name + "\" link=\"" + link + "\" xyz=\"" + xyz + "\" stiffness=\"200 kN/m\"/>\n";
}

std::string Robot(const std::string& tags) {
  return "<robot name=\"test\" xmlns:fp=\"urn:fourpost:vehicle:1\">\n<link name=\"ground\"/>\n" + tags + "</robot>\n";
}

/// A body above a beam axle, which nothing locates yet. Heights: chassis 0.8 m, axle 0.35 m.
std::string BeamAxle(const std::string& closures) {
  return Robot(Body("chassis", 1500) + Body("axle", 200) + Joined("ground", "chassis", "floating", "0 0 0.8") +
               Joined("ground", "axle", "floating", "0 0 0.35") + Tyre("left", "axle", "0 0.7 0") +
               Tyre("right", "axle", "0 -0.7 0") + closures);
}

/// Two rigid radius arms: a ball joint each on the chassis, 0.9 m behind the axle.
const std::string kRadiusArms = Closed("ball", "arm_left", "chassis -0.9 0.4 -0.4", "axle -0.9 0.4 0.05") +
                                Closed("ball", "arm_right", "chassis -0.9 -0.4 -0.4", "axle -0.9 -0.4 0.05");

/// The same arms as triangles of two rods each.
const std::string kBracedArms = Closed("rod", "upper_left", "chassis -0.9 0.4 -0.4", "axle 0 0.4 0.1") +
                                Closed("rod", "lower_left", "chassis -0.9 0.4 -0.4", "axle 0 0.4 -0.1") +
                                Closed("rod", "upper_right", "chassis -0.9 -0.4 -0.4", "axle 0 -0.4 0.1") +
                                Closed("rod", "lower_right", "chassis -0.9 -0.4 -0.4", "axle 0 -0.4 -0.1");

std::string Panhard(const std::string& end_on_chassis) {
  return Closed("rod", "panhard", "chassis " + end_on_chassis, "axle 0 -0.4 0.1");
}
const std::string kLevelPanhard = Panhard("0 0.4 -0.35");

/// A bar from the ground to a bar to another one on the ground, in the plane y = 0; the last closure is open.
std::string ThreeBars(const std::string& axis = "0 1 0") {
  return Robot(Body("crank", 1) + Body("coupler", 1) + Body("rocker", 1) +
               Joined("ground", "crank", "continuous", "0 0 0", axis) +
               Joined("crank", "coupler", "continuous", "0 0 0.3", axis) +
               Joined("ground", "rocker", "continuous", "0.8 0 0", axis));
}

/// A plate that moves in the plane y = 0, on upright rods from the ground at x = 0, 0.5, 1.
std::string PlateOnRods(const std::string& middle_foot) {
  return Robot(Body("plate", 1) + Joined("ground", "plate", "planar", "0 0 0.5") +
               Closed("rod", "first", "ground 0 0 0", "plate 0 0 0") +
               Closed("rod", "middle", "ground " + middle_foot, "plate 0.5 0 0") +
               Closed("rod", "last", "ground 1 0 0", "plate 1 0 0"));
}

class MobilityTest : public VehicleFileTest {
 protected:
  Mobility Of(const std::string& text) { return MobilityOf(Read(text).value()); }

  /// What locks a vehicle; empty when nothing does.
  Diagnostics LockOf(const std::string& text) {
    const Vehicle vehicle = Read(text).value();
    try {
      MobilityOf(vehicle);
    } catch (const FaultyInput& fault) {
      return fault.diagnostics();
    }
    return {};
  }

  static std::string With(std::string text, const std::string& tags) {
    return Replaced(std::move(text), "</robot>", tags + "</robot>");
  }
};

void ExpectCounts(const Mobility& mobility, int coordinates, int equations, int independent, int dof) {
  EXPECT_EQ(mobility.joint_coordinates, coordinates);
  EXPECT_EQ(mobility.loop_equations, equations);
  EXPECT_EQ(mobility.independent_equations, independent);
  EXPECT_EQ(mobility.dof, dof);
}

TEST_F(MobilityTest, OfAFreeBodyIsSix) {
  const Mobility mobility = Of(Robot(Body("body", 1) + Joined("ground", "body", "floating", "0 0 1")));
  ExpectCounts(mobility, 6, 0, 0, 6);
  EXPECT_THAT(mobility.redundant, IsEmpty());
  EXPECT_EQ(mobility.loop_residual, 0);
}

TEST(Mobility, OfShippedVehiclesIsThatOfTheirTrees) {
  ExpectCounts(MobilityOf(ShippedVehicle("quarter_car")), 2, 0, 0, 2);
  ExpectCounts(MobilityOf(ShippedVehicle("landrover110_model3")), 7, 0, 0, 7);
}

// Grübler: three bars on four hinges in a plane have one freedom; the ball says once more that they stay in it.
TEST_F(MobilityTest, OfAFourBarLinkageIsOne) {
  const Mobility mobility = Of(With(ThreeBars(), Closed("ball", "pin", "coupler 0.9 0 0.1", "rocker 0.1 0 0.4")));
  ExpectCounts(mobility, 3, 3, 2, 1);
  EXPECT_THAT(mobility.redundant, ElementsAre("fp:ball 'pin' (1 of 3)"));
  EXPECT_LT(mobility.loop_residual, 1e-12);  // where the assembly stops
}

TEST_F(MobilityTest, CountsTheRepetitionsOfAHinge) {
  const Mobility mobility =
      Of(With(ThreeBars(), Closed("hinge", "pin", "coupler 0.9 0 0.1", "rocker 0.1 0 0.4", "axis=\"0 1 0\"")));
  ExpectCounts(mobility, 3, 5, 2, 1);
  EXPECT_THAT(mobility.redundant, ElementsAre("fp:hinge 'pin' (3 of 5)"));
}

// Along inclined axes the repetitions agree but for rounding, in each pose for another one.
TEST_F(MobilityTest, SurvivesTheRoundingOfRepetitions) {
  const std::string axis = "0.3 1 0.2";
  const Mobility mobility = Of(
      With(ThreeBars(axis), Closed("hinge", "pin", "coupler 0.9 0 0.1", "rocker 0.1 0 0.4", "axis=\"" + axis + "\"")));
  ExpectCounts(mobility, 3, 5, 2, 1);
  EXPECT_THAT(mobility.redundant, ElementsAre("fp:hinge 'pin' (3 of 5)"));
}

// Two bars would swing freely, a weld makes a rigid frame of them.
TEST_F(MobilityTest, TellsOfAWeldThatMakesAFrame) {
  EXPECT_THAT(LockOf(With(ThreeBars(), Closed("weld", "pin", "coupler 0.9 0 0.1", "rocker 0.1 0 0.4"))),
              Reports(kLoopsRigid, {"link 'ground', link 'crank' and link 'coupler'", "fp:weld 'pin'"}));
}

// The wheel's carrier goes up and down, and steers about the line of its ball joints once the track rod is gone.
TEST_F(MobilityTest, OfAWishboneSuspensionClosedWithABall) {
  const std::string text =
      Robot(Body("body", 400) + Body("lower", 5) + Body("upper", 3) + Body("upright", 20) +
            Joined("ground", "body", "prismatic", "0 0 0.5", "0 0 1") +
            Joined("body", "lower", "continuous", "0 0.3 -0.2", "1 0.05 0.02") +
            Joined("body", "upper", "continuous", "0 0.35 0.1", "1 0.05 0.02") +
            Joined("lower", "upright", "continuous", "0 0.4 0", "1 0.05 0.02") + Tyre("tyre", "upright", "0 0.1 0.05") +
            Closed("ball", "upper_joint", "upper 0 0.3 0", "upright 0 -0.05 0.3"));
  const Mobility mobility = Of(text);
  ExpectCounts(mobility, 4, 3, 2, 2);
  EXPECT_THAT(mobility.redundant, ElementsAre("fp:ball 'upper_joint' (1 of 3)"));
}

/// A trailing rod of this length, level, so far above the axle.
std::string Trailing(const std::string& name, double y, double length, double above) {
  const auto at = [y](double x, double z) {
    return " " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z);
  };
  return Closed("rod", name, "chassis" + at(-length, above - 0.45), "axle" + at(0, above));
}

// What urdf/README.md says of rods: an axle has six freedoms, wants two of them, and each rod takes one.
TEST_F(MobilityTest, OfABeamAxleIsSixLessItsRods) {
  const std::string two = Trailing("left", 0.4, 0.6, -0.15) + Trailing("right", -0.4, 0.6, -0.15);
  const std::string third = Trailing("top", 0, 0.5, 0.15);
  const int chassis = 6;
  EXPECT_EQ(Of(BeamAxle(two + kLevelPanhard)).dof, chassis + 3);
  EXPECT_EQ(Of(BeamAxle(two + third + kLevelPanhard)).dof, chassis + 2);
  const std::string above = Trailing("top_left", 0.35, 0.5, 0.15) + Trailing("top_right", -0.35, 0.5, 0.15);
  EXPECT_THAT(LockOf(BeamAxle(two + above + kLevelPanhard)), Reports(kLoopsDeadCentre, {"roll of link 'axle'"}));
  EXPECT_TRUE(LockOf(BeamAxle(two + above + Panhard("0 0.4 -0.3"))).HasErrors());
  const std::string converging = Closed("rod", "top_left", "chassis -0.5 0.1 -0.3", "axle 0 0.35 0.15") +
                                 Closed("rod", "top_right", "chassis -0.5 -0.1 -0.3", "axle 0 -0.35 0.15");
  EXPECT_EQ(Of(BeamAxle(two + converging)).dof, chassis + 2);
}

/// A double wishbone on the left (1) or right (-1) with a second rod, which takes the wheel's travel away.
std::string LockedWishbone(const std::string& name, int side) {
  const auto at = [side](const std::string& x, double y, const std::string& z) {
    return x + " " + std::to_string(side * y) + " " + z;
  };
  const std::string lower = "lower_" + name;
  const std::string upper = "upper_" + name;
  const std::string upright = "upright_" + name;
  return Body(lower, 5) + Body(upper, 3) + Body(upright, 20) +
         Joined("body", lower, "continuous", at("0", 0.3, "-0.2"), at("1", 0.1, "0.05")) +
         Joined("body", upper, "continuous", at("0", 0.35, "0.1"), at("1", -0.05, "-0.1")) +
         Joined("ground", upright, "floating", at("0", 0.7, "0.3")) + Tyre("tyre_" + name, upright, at("0", 0.1, "0")) +
         Closed("ball", "low_" + name, lower + " " + at("0", 0.4, "-0.02"), upright + " " + at("0.01", 0, "-0.02")) +
         Closed("ball", "up_" + name, upper + " " + at("0", 0.3, "0.01"), upright + " " + at("0", -0.05, "0.31")) +
         Closed("rod", "rod_" + name, "body " + at("-0.1", 0.3, "-0.1"), upright + " " + at("-0.12", 0, "0.1")) +
         Closed("rod", "more_" + name, "body " + at("0.3", 0.2, "0.2"), upright + " " + at("0.1", 0, "0.1"));
}

TEST_F(MobilityTest, TellsOfEachSideThatIsLockedByItself) {
  const Diagnostics lock = LockOf(Robot(Body("body", 400) + Joined("ground", "body", "prismatic", "0 0 0.5", "0 0 1") +
                                        LockedWishbone("left", 1) + LockedWishbone("right", -1)));
  for (const std::string side : {"left", "right"}) {
    const std::string other = side == "left" ? "right" : "left";
    const std::vector<std::string> words = {"link 'body', link 'lower_" + side,
                                            "link 'upper_" + side + "' and link 'upright_" + side + "'",
                                            "fp:rod 'more_" + side};
    EXPECT_THAT(lock.items(), Contains(AllOf(IsFinding(kLoopsRigid, words),
                                             Field(&Diagnostic::message, Not(HasSubstr("_" + other))))));
  }
}

// Inclined axes, ball joints and a track rod: the wheel's steering goes with its travel.
TEST_F(MobilityTest, OfASpatialWishboneSuspensionIsItsTravel) {
  const std::string text =
      Robot(Body("body", 400) + Body("lower", 5) + Body("upper", 3) + Body("upright", 20) +
            Joined("ground", "body", "prismatic", "0 0 0.5", "0 0 1") +
            Joined("body", "lower", "continuous", "0 0.3 -0.2", "1 0.1 0.05") +
            Joined("body", "upper", "continuous", "0 0.35 0.1", "1 -0.05 -0.1") +
            Joined("ground", "upright", "floating", "0 0.7 0.3") + Tyre("tyre", "upright", "0 0.1 0") +
            Closed("ball", "lower_joint", "lower 0 0.4 -0.02", "upright 0.01 0 -0.02") +
            Closed("ball", "upper_joint", "upper 0 0.3 0.01", "upright 0 -0.05 0.31") +
            Closed("rod", "track_rod", "body -0.1 0.3 -0.1", "upright -0.12 0 0.1"));
  const Mobility mobility = Of(text);
  ExpectCounts(mobility, 9, 7, 7, 2);
  EXPECT_THAT(mobility.redundant, IsEmpty());
}

TEST_F(MobilityTest, AsksForDigitsWhereAxesAreNearlyParallel) {
  const std::string text = Robot(Body("lower", 5) + Body("upper", 3) + Body("upright", 20) +
                                 Joined("ground", "lower", "continuous", "0 0.3 0.3", "1 0 0") +
                                 Joined("ground", "upper", "continuous", "0 0.35 0.6", "1 0 0.00001") +
                                 Joined("lower", "upright", "continuous", "0 0.4 0", "1 0 0") +
                                 Closed("ball", "upper_joint", "upper 0 0.3 0", "upright 0 -0.05 0.3"));
  EXPECT_THAT(LockOf(text), Reports(kLoopsRigid, {"fp:ball 'upper_joint'", "digits"}));
}

TEST_F(MobilityTest, OfALocatedBeamAxleIsHeaveAndRoll) {
  const std::string links = Closed("rod", "left", "chassis -0.9 0.4 -0.5", "axle 0 0.4 -0.05") +
                            Closed("rod", "right", "chassis -0.9 -0.4 -0.5", "axle 0 -0.4 -0.05") +
                            Closed("rod", "top", "chassis -0.8 0 -0.2", "axle 0 0 0.25");
  const Mobility mobility = Of(BeamAxle(links + kLevelPanhard));
  ExpectCounts(mobility, 12, 4, 4, 8);
  EXPECT_THAT(mobility.redundant, IsEmpty());
}

TEST_F(MobilityTest, TellsThatRigidRadiusArmsLockABeamAxlesRoll) {
  const std::string text = BeamAxle(kBracedArms + kLevelPanhard);
  const Diagnostics lock = LockOf(text);
  EXPECT_THAT(lock, Reports(kLoopsWheel, LineOf(text, "<fp:rod name=\"upper_left\""),
                            {"roll of link 'axle'", "link 'chassis'", "fp:rod 'upper_left' (line ", "one of them"}));
  EXPECT_THAT(lock.items(),
              Each(Field(&Diagnostic::message, AllOf(Not(HasSubstr("panhard")), Not(HasSubstr("heave"))))));
}

// The rod stands across the hop in the design pose and takes it away a moment later.
TEST_F(MobilityTest, TellsThatALevelPanhardRodLocksRadiusArmsWithBallJoints) {
  const Diagnostics lock = LockOf(BeamAxle(kRadiusArms + kLevelPanhard));
  EXPECT_THAT(lock, Reports(kLoopsWheel, {"roll of link 'axle'", "link 'chassis'", "fp:ball 'arm_left'"}));
  EXPECT_THAT(lock, Reports(kLoopsDeadCentre,
                            {"heave of link 'axle'", "fp:ball 'arm_left' (line ", "and fp:rod 'panhard' (line "}));
}

TEST_F(MobilityTest, TellsThatAnInclinedPanhardRodMakesAxleAndChassisOne) {
  EXPECT_THAT(LockOf(BeamAxle(kRadiusArms + Panhard("0 0.4 -0.25"))),
              Reports(kLoopsRigid, {"link 'chassis' and link 'axle'", "fp:ball 'arm_left'"}));
}

TEST_F(MobilityTest, TakesAHingeForMeant) {
  const std::string hinge = Closed("hinge", "pivot", "chassis -0.9 0 -0.4", "axle -0.9 0 0.05", "axis=\"0 1 0\"");
  ExpectCounts(Of(BeamAxle(hinge)), 12, 5, 5, 7);
}

TEST_F(MobilityTest, TakesAWeldForMeant) {
  const Mobility mobility = Of(BeamAxle(Closed("weld", "bolts", "chassis 0 0 -0.4", "axle 0 0 0.05")));
  ExpectCounts(mobility, 12, 6, 6, 6);
}

TEST_F(MobilityTest, LooksForRollWhereTheSpinningWheelsHang) {
  const std::string text =
      Replaced(Replaced(BeamAxle(kBracedArms), Tyre("left", "axle", "0 0.7 0"),
                        Body("wheel_left", 15) + Joined("axle", "wheel_left", "continuous", "0 0.7 0") +
                            Tyre("left", "wheel_left", "0 0 0")),
               Tyre("right", "axle", "0 -0.7 0"),
               Body("wheel_right", 15) + Joined("axle", "wheel_right", "continuous", "0 -0.7 0") +
                   Tyre("right", "wheel_right", "0 0 0"));
  EXPECT_THAT(LockOf(text), Reports(kLoopsWheel, {"roll of link 'axle'"}));
}

// Three equal parallel rods say twice that the plate stays level, wherever it is.
TEST_F(MobilityTest, NamesARodThatRepeatsTheOthers) {
  const Mobility mobility = Of(PlateOnRods("0.5 0 0"));
  ExpectCounts(mobility, 3, 3, 2, 1);
  EXPECT_THAT(mobility.redundant,
              ElementsAre("fp:rod 'first' (1 of 1)", "fp:rod 'middle' (1 of 1)", "fp:rod 'last' (1 of 1)"));
}

// With a shorter one among them they only seem to as long as they are upright.
TEST_F(MobilityTest, TellsOfParallelRodsOfUnequalLength) {
  EXPECT_THAT(LockOf(PlateOnRods("0.5 0 0.2")),
              Reports(kLoopsDeadCentre, {"fore-aft motion of link 'plate'", "fp:rod 'first' (line "}));
}

TEST(Mobility, TellsOfARodAtDeadCentreThatNothingCanFollow) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.rods.push_back({.name = "stay", .parent = {0, {0.5, 0, 0.3}}, .child = {1, {0, 0, 0}}, .source_line = 12});
  try {
    MobilityOf(vehicle);
    FAIL() << "the wheel moved";
  } catch (const FaultyInput& fault) {
    EXPECT_THAT(fault.diagnostics(), Reports(kLoopsDeadCentre, 12, {"heave of link 'unsprung'", "fp:rod 'stay'"}));
  }
}

TEST(Mobility, TellsOfARodThatHoldsAWheel) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.rods.push_back({.name = "stay", .parent = {0, {0.5, 0, 0}}, .child = {1, {0, 0, 0}}, .source_line = 12});
  try {
    MobilityOf(vehicle);
    FAIL() << "the wheel moved";
  } catch (const FaultyInput& fault) {
    EXPECT_THAT(fault.diagnostics(), Reports(kLoopsRigid, 12, {"link 'ground' and link 'unsprung'", "fp:rod 'stay'"}));
  }
}

// At the end of its stroke the piston stands still, but only there.
TEST_F(MobilityTest, LetsACrankPassItsDeadCentre) {
  const std::string text =
      Robot(Body("crank", 1) + Body("piston", 1) + Joined("ground", "crank", "continuous", "0 0 0") +
            Joined("ground", "piston", "prismatic", "0.5 0 0", "1 0 0") +
            Closed("rod", "connecting_rod", "crank 0.1 0 0", "piston 0 0 0"));
  ExpectCounts(Of(text), 2, 1, 1, 1);
}

// All bars in one line: the linkage may go on as parallelogram or crossed, so the design pose does not say how it
// moves.
TEST_F(MobilityTest, TellsOfAFlatParallelogram) {
  const std::string text = Robot(
      Body("first", 1) + Body("second", 1) + Joined("ground", "first", "continuous", "0 0 0") +
      Joined("ground", "second", "continuous", "0.5 0 0") + Closed("rod", "tie", "first 0.2 0 0", "second 0.2 0 0"));
  EXPECT_THAT(LockOf(text), Reports(kLoopsDeadCentre, {"fp:rod 'tie'"}));
}

// Watt's linkage leaves a straight line by the fifth power of a small motion: 5 mm of 100 mm are enough to tell.
TEST_F(MobilityTest, TellsOfALockOfHigherOrder) {
  const std::string text = Robot(
      Body("bar", 1) + Body("slide", 1) + Joined("ground", "slide", "prismatic", "0 0 0", "0 0 1") +
      Joined("slide", "bar", "continuous", "0 0 0") + Closed("rod", "left", "ground -0.1 0 0.03", "bar 0 0 0.03") +
      Closed("rod", "right", "ground 0.1 0 -0.03", "bar 0 0 -0.03"));
  EXPECT_THAT(LockOf(text), Reports(kLoopsStiff, {"fp:rod 'left' (line "}));
}

}  // namespace
}  // namespace fourpost::mobility_test
