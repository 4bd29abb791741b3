#include "tests/vehicles/fault_case.h"
#include "tests/vehicles/small_vehicle.h"

namespace fourpost {
namespace {

class VehicleFaults : public VehicleFileTest, public ::testing::WithParamInterface<FaultCase> {};

TEST_P(VehicleFaults, AreToldWithTheirLine) {
  const FaultCase& fault = GetParam();
  const std::string text = Replaced(kSmallVehicle, fault.from, fault.to);
  EXPECT_FALSE(Read(text).has_value());
  Expect(Severity::kError, LineOf(text, fault.at), fault.message);
}

const std::string kStand = "<fp:frame name=\"stand\" link=\"ground\" xyz=\"0 0 0.3\"/>\n";
const std::string kCoil = R"(<linear stiffness="0.5*$k" preload="-2 kN"/>)";

INSTANTIATE_TEST_SUITE_P(
    Tags, VehicleFaults,
    ::testing::Values(
        FaultCase{"NotXml", "</robot>", "</robt>", "<robot", "not XML: the tag that begins here is not closed"},
        FaultCase{"TwoRobots", "</robot>", "</robot>\n<robot name=\"b\"/>", R"(<robot name="b")",
                  "must hold one <robot>"},
        FaultCase{"NoNamespace", R"( xmlns:fp="urn:fourpost:vehicle:1")", "", "<robot",
                  R"(needs xmlns:fp="urn:fourpost)"},
        FaultCase{"OtherNamespace", "urn:fourpost:vehicle:1", "urn:fourpost:vehicle:9", "<robot", "expected xmlns:fp="},
        FaultCase{"NamelessRobot", R"( name="small")", "", "<robot", "needs the attribute 'name'"},
        FaultCase{"UnknownTag", R"(<fp:post name="post" under="tyre"/>)", R"(<fp:pots name="post" under="tyre"/>)",
                  "<fp:pots", "unknown tag <fp:pots>, did you mean 'fp:post'?"},
        FaultCase{"ForgottenPrefix", "<fp:ball ", "<ball ", "<ball ", "did you mean 'fp:ball'?"},
        FaultCase{"UnneededPrefix", kCoil, R"(<fp:linear stiffness="$k"/><linear stiffness="$k"/>)", R"("coil")",
                  "unknown tag <fp:linear> in fp:spring 'coil', did you mean 'linear'?"},
        FaultCase{"UnknownChild", kCoil, kCoil + "<color/>", "<color/>",
                  "unknown tag <color> in fp:spring 'coil'; legal: linear"},
        FaultCase{"UnknownAttribute", R"(damping="50 N*s/m")", R"(dampng="50 N*s/m")", "dampng",
                  "unknown attribute 'dampng' of fp:tyre 'tyre', did you mean 'damping'?"},
        FaultCase{"AttributeTwice", R"(damping="50 N*s/m")", R"(damping="50 N*s/m" damping="50 N*s/m")",
                  R"(damping="50)", "is given twice"},
        FaultCase{"AttributeMissing", R"( xyz="0 0 -0.3")", "", "<fp:tyre", "fp:tyre 'tyre' needs the attribute 'xyz'"},
        FaultCase{"AttributeEmpty", R"(source="bench")", R"(source=" ")", R"(name="k")", "is empty"},
        FaultCase{"NoLaw", kCoil, "", R"("coil")", "fp:spring 'coil' needs one law or shape, and no more: linear"},
        FaultCase{"TwoLaws", R"(<linear rate="10 N*s/m"/>)",
                  R"(<linear rate="10 N*s/m"/><bilinear compression="1 N*s/m" rebound="1 N*s/m"/>)", R"("hub")",
                  "needs one law or shape, and no more: linear, bilinear"},
        FaultCase{"TwoSeriesSprings", "<series ", R"(<series stiffness="1 N/m"/><series )", "<series",
                  "more than one <series>"},
        FaultCase{"NoSensorType", R"(type="strut" )", "", R"(name="s")",
                  "needs the attribute 'type': accelerometer, displacement"},
        FaultCase{"UnknownSensorType", R"(type="strut")", R"(type="struts")", "struts", "did you mean 'strut'?"},
        FaultCase{"AttributeOfOtherSensor", R"(type="load_cell" )", R"(type="load_cell" link="body" )", R"(name="F")",
                  "unknown attribute 'link' of fp:sensor 'F'"},
        FaultCase{"DuplicateName", R"(name="helper")", R"(name="coil")", R"(stiffness="$k")",
                  "fp:spring 'coil' is already defined in line 39"}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Numbers, VehicleFaults,
    ::testing::Values(
        FaultCase{"UnitMissing", R"(stiffness="200 kN/m")", R"(stiffness="200")", "<fp:tyre",
                  R"(stiffness="200" of fp:tyre 'tyre' has no unit: a stiffness is needed, such as "200 N/mm")"},
        FaultCase{"UnitMissingOfAParameter", R"(value="15 N/mm")", R"(value="15")", R"(name="k")",
                  R"(value="15" of fp:parameter 'k' has no unit, but lower has: write "15 N/mm")"},
        FaultCase{"UnitUnknown", "200 kN/m", "200 kN/in", "<fp:tyre", "unknown unit 'kN/in'"},
        FaultCase{"WrongDimension", "200 kN/m", "200 kN", "<fp:tyre", "is a force: a stiffness is needed"},
        FaultCase{"NotANumber", "200 kN/m", "stiff", "<fp:tyre", "is not a number with a unit"},
        FaultCase{"NotAVector", R"(xyz="0 0 -0.3")", R"(xyz="0 0")", "<fp:tyre", "must be three numbers"},
        FaultCase{"ZeroAxis", R"(axis="0 0 2")", R"(axis="0 0 0")", R"("coil")", "must not be zero"},
        FaultCase{"NegativeStiffness", "200 kN/m", "-200 kN/m", "<fp:tyre", "must not be negative"},
        FaultCase{"NegativeDamping", R"(compression="1 kN*s/m")", R"(compression="-1 kN*s/m")", "<bilinear",
                  "must not be negative"},
        FaultCase{"NegativeWithinBounds", "0.5*$k", "-$k", R"("coil")", "must not be negative over the whole range"},
        FaultCase{"ZeroSeriesSpring", "800 N/mm", "0 N/mm", "<series", "must be above zero"},
        FaultCase{"ZeroRateInSeries", R"(compression="1 kN*s/m")", R"(compression="0 kN*s/m")", "<series",
                  "fp:damper 'shock' has a series spring: its rates must be above zero"},
        FaultCase{"UnknownParameter", "0.5*$k", "0.5*$q", R"("coil")",
                  "refers to an unknown parameter 'q'; there are "},
        FaultCase{"MisspeltParameter", "0.5*$k", "0.5*$m_bdoy", R"("coil")", "did you mean 'm_body'?"},
        FaultCase{"ParameterOfOtherDimension", "0.5*$k", "0.5*$m_body", R"("coil")",
                  "refers to a mass: a stiffness is needed"},
        FaultCase{"BadReference", "0.5*$k", "0.5+$k", R"("coil")",
                  R"(is a sum, which is not supported; write a number with a unit, or a parameter as in "$k")"},
        FaultCase{"ValueOutsideBounds", R"(value="15 N/mm")", R"(value="25 N/mm")", R"(name="k")", "must lie between"},
        FaultCase{"BoundOfOtherDimension", R"(lower="10 N/mm")", R"(lower="10 N")", R"(name="k")", "as its value"},
        FaultCase{"ZeroPrecision", R"(precision="0.01 N/mm")", R"(precision="0 N/mm")", R"(name="k")",
                  "must be above zero"},
        FaultCase{"PrecisionBeyondTheBounds", R"(precision="0.01 N/mm")", R"(precision="10.1 N/mm")", R"(name="k")",
                  R"(precision="10.1 N/mm" of fp:parameter 'k' must not exceed upper - lower)"},
        FaultCase{"NoRangeBetweenTheBounds", R"(lower="10 N/mm" upper="20 N/mm")", R"(lower="15 N/mm" upper="15 N/mm")",
                  R"(name="k")", "to fix the parameter, leave out all three"},
        FaultCase{"SomeBounds", R"( precision="0.01 N/mm")", "", R"(name="k")", "all of lower, upper and precision"},
        FaultCase{"BadParameterName", R"(name="I_body")", R"(name="I-body")", "I-body", "letters, digits and '_' only"},
        FaultCase{"UnusedParameter", "  <fp:frame",
                  "  <fp:parameter name=\"c\" value=\"1 kg\" source=\"guess\"/>\n  <fp:frame", R"(name="c")",
                  "fp:parameter 'c' is not used"}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    References, VehicleFaults,
    ::testing::Values(
        FaultCase{"UnknownLink", R"(<fp:tyre name="tyre" link="wheel")", R"(<fp:tyre name="tyre" link="whel")",
                  "<fp:tyre", "unknown link 'whel', did you mean 'wheel'?"},
        FaultCase{"UnknownFrame", R"(<fp:rod name="link" parent="top")", R"(<fp:rod name="link" parent="topp")",
                  "<fp:rod", "unknown frame or link 'topp', did you mean 'top'?"},
        FaultCase{"UnknownTyre", R"(under="tyre")", R"(under="tire")", "<fp:post",
                  "unknown fp:tyre 'tire', did you mean 'tyre'?"},
        FaultCase{"TwoPostsUnderATyre", "<fp:rod", "<fp:post name=\"second\" under=\"tyre\"/>\n  <fp:rod",
                  R"("second")", "drives the tyre that fp:post 'post' drives already"},
        FaultCase{"FrameNamedAsLink", "<fp:rod", "<fp:frame name=\"body\" link=\"body\" xyz=\"0 0 0\"/>\n  <fp:rod",
                  R"(<fp:frame name="body")", "has the name of a link"},
        FaultCase{"BothEndsOnALink", R"(<fp:damper name="shock" parent="top" child="wheel")",
                  R"(<fp:damper name="shock" parent="top" child="body")", R"("shock")", "both ends on link 'body'"},
        FaultCase{"RodWithBothEndsOnALink", R"(<fp:rod name="link" parent="top" child="ground")",
                  R"(<fp:rod name="link" parent="top" child="body")", "<fp:rod",
                  "fp:rod 'link' has both ends on link 'body': it joins nothing"},
        FaultCase{"BallWithBothEndsOnALink", R"(<fp:ball name="joint" parent="top" child="ground")",
                  R"(<fp:ball name="joint" parent="top" child="body")", "<fp:ball",
                  "fp:ball 'joint' has both ends on link 'body': it joins nothing"},
        FaultCase{"SpringWithoutLength", "<fp:rod",
                  kStand + R"(<fp:spring name="h" parent="stand" child="wheel"><linear )"
                           "stiffness=\"$k\"/></fp:spring>\n<fp:rod",
                  R"("h")", "'h' has no length, so it has no direction"},
        FaultCase{"RodWithoutLength", "<fp:rod",
                  kStand + "<fp:rod name=\"r\" parent=\"stand\" child=\"wheel\"/>\n<fp:rod", R"("r")",
                  "or use fp:ball"},
        FaultCase{"BindToNowhere", "link[body]/mass", "body/mass", R"("body/mass")", "must be link[NAME]/mass"},
        FaultCase{"BindToUnknownLink", "link[body]/mass", "link[bdy]/mass", "link[bdy]", "did you mean 'body'?"},
        FaultCase{"BindToUnknownNumber", "link[body]/mass", "link[body]/maas", "maas", "did you mean 'mass'?"},
        FaultCase{"BindToLinkWithoutInertial", "link[body]/mass", "link[ground]/mass", "link[ground]",
                  "finds no such number"},
        FaultCase{"BindOfOtherDimension", "link[body]/mass", "link[body]/inertia/ixx", "inertia/ixx",
                  "is an inertia, but the parameter is a mass"},
        FaultCase{"BindDisagrees", R"(<mass value="200"/>)", R"(<mass value="201"/>)", "link[body]/mass",
                  "is 201 kg in the tree, but factor times value is 200 kg"},
        FaultCase{"BoundTwice", R"(<fp:bind to="link[body]/mass"/>)",
                  "<fp:bind to=\"link[body]/mass\"/>\n<fp:bind  to=\"link[body]/mass\"/>", "<fp:bind  to",
                  "is bound twice"},
        FaultCase{"BoundInertiaTurned", R"(<origin xyz="0.1 0 0.2"/>)", R"(<origin xyz="0.1 0 0.2" rpy="0 0 1"/>)",
                  "link[body]/inertia/iyy", "without rpy"},
        FaultCase{"MassNegativeWithinBounds", R"(lower="150 kg")", R"(lower="-1 kg")", "link[body]/mass",
                  "must not be negative"}),
    CaseName);

}  // namespace
}  // namespace fourpost
