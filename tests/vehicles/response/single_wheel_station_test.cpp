// The shipped single wheel station against the figures of the thesis, chapter 4, and the written-out equations.
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/closed_form/quarter_car.h"
#include "tests/vehicles/closed_form.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::single_wheel_station_test {
namespace {

Vehicle Station() { return ShippedVehicle("single_wheel_station"); }

VehicleSummary SummaryOf(const Vehicle& vehicle) { return Summarise(vehicle, vehicle.ParameterValues()); }

TEST(SingleWheelStation, RestsOnTheStaticLoadOfTheThesis) {
  constexpr double kThesisGravity = 9.81;
  const double load = SummaryOf(Station()).corner_loads.at(0).load_N;
  EXPECT_NEAR(load * kThesisGravity / 9.80665, 2041.5, 0.05);  // printed digits
}

// The thesis prints frequencies, but not the tyre rate behind them: 232.4 kN/m gives both. The bench value of the
// virtual rig, 229.5 kN/m, gives 14.16 Hz.
TEST(SingleWheelStation, HasTheModesOfTheThesis) {
  Vehicle station = Station();
  Set(station, "c_bump", 1500);
  Set(station, "c_rebound", 1500);
  Set(station, "kt", 232.4e3);
  const VehicleSummary summary = SummaryOf(station);
  ASSERT_EQ(summary.modes.size(), 2u);
  // Printed digits.
  EXPECT_NEAR(summary.modes[0].frequency_Hz, 1.45, 0.005);
  EXPECT_NEAR(summary.modes[1].frequency_Hz, 14.25, 0.005);
}

TEST(SingleWheelStation, AcceleratesAsTheClosedForm) {
  Draw draw;
  for (int i = 0; i < 20; ++i) {
    const Vehicle vehicle = draw.Parameters(WithLinearTyres(Station()));
    const QuarterCar car = {.sprung_mass = ValueOf(vehicle, "m_sprung"),
                            .unsprung_mass = ValueOf(vehicle, "m_unsprung"),
                            .stiffness = ValueOf(vehicle, "k"),
                            .tyre_stiffness = ValueOf(vehicle, "kt"),
                            .damper = {ValueOf(vehicle, "c_bump"), ValueOf(vehicle, "c_rebound")}};
    const ClosedForm closed = {.acceleration =
                                   [car](const MotionState& motion) {
                                     const Eigen::Vector<double, 5> state(motion.q[0], motion.q[1], motion.rate[0],
                                                                          motion.rate[1], 0.0);
                                     return Eigen::VectorXd(car.Derivative(state, motion.ground[0]).segment<2>(2));
                                   },
                               .to_joints = JointOrder(vehicle, {"body_travel", "wheel_travel"})};
    Multibody multibody = Resting(vehicle);
    ExpectSameAcceleration(multibody, closed, draw.SmallMotion(2, 1));
  }
}

// With z_ground and a_ground, the motion of the post, these are the columns of the recordings.
TEST(SingleWheelStation, HasTheFiveOutputsOfTheThesis) {
  const Vehicle station = Station();
  std::vector<std::string> names;
  for (const Sensor& sensor : station.sensors) names.push_back(sensor.name);
  EXPECT_THAT(names, testing::ElementsAre("z_sprung", "z_unsprung", "a_sprung", "a_unsprung", "F_tyre"));
  EXPECT_EQ(station.posts.at(0).name, "ground");
}

}  // namespace
}  // namespace fourpost::single_wheel_station_test
