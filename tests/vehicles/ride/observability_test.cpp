#include "vehicles/ride/observability.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"

namespace fourpost::observability_test {
namespace {

std::vector<ParameterView> ViewsOf(const Vehicle& vehicle) {
  return ParameterViews(vehicle, CondensedVehicle(vehicle), vehicle.ParameterValues());
}

const ParameterView& ViewOf(const std::vector<ParameterView>& views, const std::string& parameter) {
  for (const ParameterView& view : views)
    if (view.parameter == parameter) return view;
  throw std::invalid_argument("no view of " + parameter);
}

/// Nothing for a sensor that does not see the parameter.
const ParameterView::Channel* ChannelOf(const ParameterView& view, const std::string& sensor) {
  for (const ParameterView::Channel& channel : view.channels)
    if (channel.sensor == sensor) return &channel;
  return nullptr;
}

/// A mass m on a tyre k, c: H = (k + i w c) / (k + i w c - m w^2).
const std::string kBlock = R"(<robot name="block" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="block">
    <inertial><mass value="50"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>
  </link>
  <joint name="travel" type="prismatic">
    <parent link="ground"/><child link="block"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>
    <limit effort="0" velocity="0"/>
  </joint>
  <fp:parameter name="m" value="50 kg" lower="40 kg" upper="60 kg" precision="1 kg" source="test">
    <fp:bind to="link[block]/mass"/>
  </fp:parameter>
  <fp:parameter name="k" value="100 kN/m" lower="100 kN/m" upper="500 kN/m" precision="1 kN/m" source="test"/>
  <fp:parameter name="c" value="1 kN*s/m" source="test"/>
  <fp:tyre name="tyre" link="block" xyz="0 0 0" stiffness="$k" damping="$c"/>
  <fp:post name="post" under="tyre"/>
  <fp:sensor name="z" type="displacement" link="block" xyz="0 0 0"/>
  <fp:sensor name="across" type="accelerometer" link="block" xyz="0 0 0" axis="0 1 0"/>
</robot>
)";

// The only sensor of its kind reads the most of its kind: sqrt(1 + 0.2^2) times as much stands below the line.
TEST(Observability, OfAMassOnATyreIsTheLogarithmicDerivative) {
  double mass = 0;
  double stiffness = 0;
  constexpr int kPoints = 60;
  for (int i = 0; i < kPoints; ++i) {
    const double w = 2 * std::numbers::pi * 0.5 * std::pow(60.0, i / (kPoints - 1.0));
    const std::complex<double> tyre(100e3, w * 1e3);
    const std::complex<double> impedance = tyre - 50 * w * w;
    mass += std::abs(50 * w * w / impedance);
    // Half its range is more than its value.
    stiffness += 200e3 * std::abs(1.0 / tyre - 1.0 / impedance);
  }
  const double share = kPoints * std::sqrt(1.04);
  const std::vector<ParameterView> views = ViewsOf(VehicleOf(kBlock));
  ASSERT_EQ(views.size(), 2u);  // c is fixed
  ASSERT_EQ(views[0].channels.size(), 1u);
  EXPECT_EQ(views[0].channels[0].sensor, "z");
  EXPECT_EQ(views[0].channels[0].excitation, "heave");
  // Squares of the difference's step, magnified by resonance.
  EXPECT_NEAR(views[0].channels[0].sensitivity, mass / share, 1e-6);
  // At its lower bound the difference is one-sided.
  EXPECT_NEAR(views[1].channels[0].sensitivity, stiffness / share, 1e-3);
}

TEST(Observability, TellsThatNothingSeesAParameter) {
  const Vehicle vehicle = VehicleOf(Replaced(kBlock, R"(name="z" type="displacement" link="block" xyz="0 0 0")",
                                             R"(name="y" type="displacement" link="block" xyz="0 0 0" axis="0 1 0")"));
  for (const ParameterView& view : ViewsOf(vehicle)) EXPECT_TRUE(view.channels.empty()) << view.parameter;
}

TEST(Observability, NeedsPosts) {
  const Vehicle vehicle = VehicleOf(Replaced(kBlock, R"(<fp:post name="post" under="tyre"/>)", ""));
  for (const ParameterView& view : ViewsOf(vehicle)) EXPECT_TRUE(view.channels.empty()) << view.parameter;
}

TEST(Observability, FindsTheTestThatShowsAParameter) {
  const std::vector<ParameterView> views = ViewsOf(ShippedVehicle("landrover110_model3"));
  EXPECT_EQ(ViewOf(views, "m_sprung").channels.at(0).excitation, "heave");
  EXPECT_EQ(ViewOf(views, "I_pitch").channels.at(0).excitation, "pitch");
  EXPECT_EQ(ViewOf(views, "I_roll").channels.at(0).excitation, "roll");
  EXPECT_EQ(ViewOf(views, "I_front_roll").channels.at(0).excitation, "warp");
  EXPECT_EQ(ViewOf(views, "m_front").channels.at(0).sensor.substr(0, 2), "F_");
  // Of roll inertia a sensor in the plane of symmetry knows nothing.
  EXPECT_EQ(ChannelOf(ViewOf(views, "I_roll"), "a_cg"), nullptr);
  for (const ParameterView& view : views) EXPECT_FALSE(view.channels.empty()) << view.parameter;
}

// A gyro about the roll axis reads nothing in heave: no sensitivity comes of dividing by it.
TEST(Observability, GivesNothingForAChannelThatReadsNothing) {
  for (const ParameterView& view : ViewsOf(VehicleOf(kIndependentCar)))
    for (const ParameterView::Channel& channel : view.channels) {
      EXPECT_LT(channel.sensitivity, 2) << view.parameter << " " << channel.sensor;
      if (channel.sensor != "roll_rate") continue;
      EXPECT_THAT(channel.excitation, testing::AnyOf("roll", "warp"));
    }
}

// Posts of a three-wheeler cannot warp: what is left to try is one of them alone.
TEST(Observability, MovesPostsAloneWhereTheyHaveNoPattern) {
  Vehicle vehicle = VehicleOf(kIndependentCar);
  vehicle.posts.pop_back();
  for (const ParameterView& view : ViewsOf(vehicle)) EXPECT_FALSE(view.channels.empty());
}

// The model about the design pose replaces these laws by rates: that it sees nothing of a gap says nothing of a march.
TEST(Observability, TellsWhatIsInACurvedLaw) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  const auto add = [&](const char* name, double value) {
    vehicle.parameters.push_back(
        {.name = name, .value = value, .lower = 0.5 * value, .upper = 2 * value, .precision = 0.01 * value});
    return Scalar{.value = value, .parameter = static_cast<int>(vehicle.parameters.size()) - 1};
  };
  Spring stop = vehicle.springs[0];
  stop.kind = Spring::Kind::kStop;
  stop.preload = Scalar();
  stop.law = {.stiffness = {}, .knees = {{-1, add("gap", 0.03), add("bump", 1e5), {}, true}}};
  vehicle.springs.push_back(stop);
  vehicle.dampers[0].law.friction = {add("friction", 40), Scalar{.value = 0.002}};
  const std::vector<ParameterView> views = ViewsOf(vehicle);
  for (const char* name : {"gap", "bump", "friction"}) {
    EXPECT_TRUE(ViewOf(views, name).in_curved_law) << name;
    EXPECT_TRUE(ViewOf(views, name).channels.empty()) << name;
  }
  for (const char* name : {"k", "kt", "c_bump", "m_sprung"}) EXPECT_FALSE(ViewOf(views, name).in_curved_law) << name;
}

}  // namespace
}  // namespace fourpost::observability_test
