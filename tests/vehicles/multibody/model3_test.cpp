// The shipped Model 3 in Simbody against the written-out equations, which know nothing of Simbody.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/files/frequency_response_file.h"
#include "tests/closed_form/full_car.h"
#include "tests/vehicles/closed_form.h"

namespace fourpost::model3_test {
namespace {

constexpr int kVehicles = 20;

Vehicle Model3() { return WithLinearTyres(ShippedVehicle("landrover110_model3")); }

/// Lateral offset of a link's centre of mass [m].
double Offset(const Vehicle& vehicle, const std::string& name) {
  for (const Link& link : vehicle.links)
    if (link.name == name) return link.ComAt(vehicle.ParameterValues()).y();
  ADD_FAILURE() << "no link " << name;
  return 0;
}

/// The vehicle with its 22 parameters within their bounds.
Vehicle Drawn(Draw& draw) { return draw.Parameters(Model3()); }

/// Thesis appendix C with the parameters of the vehicle and the survey's stations.
FullCar FullCarOf(const Vehicle& vehicle) {
  const auto value = [&](const char* name) { return ValueOf(vehicle, name); };
  return {.sprung_mass = value("m_sprung"),
          .roll_inertia = value("I_roll"),
          .pitch_inertia = value("I_pitch"),
          .offset = Offset(vehicle, "chassis"),
          .stiffness = {value("k_FL"), value("k_FR"), value("k_RL"), value("k_RR")},
          .tyre_stiffness = {value("kt_FL"), value("kt_FR"), value("kt_RL"), value("kt_RR")},
          .front = {.mass = value("m_front"),
                    .roll_inertia = value("I_front_roll"),
                    .offset = Offset(vehicle, "front_axle"),
                    .x = 1.456,
                    .spring_station = 0.47,
                    .damper_station = 0.47,
                    .tyre_station = 0.743,
                    .damper = {value("c_front_bump"), value("c_front_rebound")}},
          .rear = {.mass = value("m_rear"),
                   .roll_inertia = value("I_rear_roll"),
                   .offset = Offset(vehicle, "rear_axle"),
                   .x = -1.338,
                   .spring_station = 0.5,
                   .damper_station = 0.485,
                   .tyre_station = 0.743,
                   .damper = {value("c_rear_bump"), value("c_rear_rebound")}}};
}

/// The file's heaves are those of points in the plane of symmetry, the closed form's those of centres of mass.
Eigen::MatrixXd ToJoints(const Vehicle& vehicle, const FullCar& car) {
  Eigen::MatrixXd to_symmetry = Eigen::MatrixXd::Identity(7, 7);
  to_symmetry(0, 1) = -car.offset;
  to_symmetry(3, 4) = -car.front.offset;
  to_symmetry(5, 6) = -car.rear.offset;
  return JointOrder(vehicle, {"body_heave", "body_roll", "body_pitch", "front_travel", "front_roll", "rear_travel",
                              "rear_roll"}) *
         to_symmetry;
}

ClosedForm ClosedFormOf(const Vehicle& vehicle) {
  const FullCar car = FullCarOf(vehicle);
  return {.model = car.Model(),
          .acceleration =
              [car](const MotionState& motion) { return car.Acceleration(motion.q, motion.rate, motion.ground); },
          .to_joints = ToJoints(vehicle, car)};
}

TEST(Model3, CondensesToTheClosedForm) {
  Draw draw;
  for (int i = 0; i < kVehicles; ++i) {
    const Vehicle vehicle = Drawn(draw);
    ExpectSameMatrices(vehicle, ClosedFormOf(vehicle));
  }
}

// Without angles nothing leans, whatever their rates.
TEST(Model3, AcceleratesAsTheClosedFormWhereItIsLevel) {
  Draw draw;
  for (int i = 0; i < kVehicles; ++i) {
    const Vehicle vehicle = Drawn(draw);
    Multibody multibody = Resting(vehicle);
    MotionState motion = draw.SmallMotion(7, 4);
    for (const int angle : {1, 2, 4, 6}) motion.q[angle] = 0;
    ExpectSameAcceleration(multibody, ClosedFormOf(vehicle), motion);
  }
}

TEST(Model3, AcceleratesAsTheClosedFormForSmallMotion) {
  Draw draw;
  for (int i = 0; i < kVehicles; ++i) {
    const Vehicle vehicle = Drawn(draw);
    Multibody multibody = Resting(vehicle);
    ExpectSameAccelerationForSmallMotion(multibody, ClosedFormOf(vehicle), draw.SmallMotion(7, 4));
  }
}

/// Second derivative by roll of the length of a coil, its top p above the roll axis: the top sinks by p phi^2 / 2, and
/// swings aside by p phi, which leans the coil of length l.
double LengthCurvature(double p, double l) { return -p + p * p / l; }

// Why the file's coils end at the height of the roll axis: at the surveyed height the weight would act in roll.
TEST(Model3, CoilsWithSurveyedTopsWouldTakeSomeFivePercentOfTheRollStiffness) {
  constexpr double kFrontTop = 0.73 - 0.832;
  constexpr double kRearTop = 0.76 - 0.832;
  constexpr double kAxles = 0.385 - 0.832;
  Vehicle vehicle = Model3();
  for (std::size_t i = 0; i < 4; ++i) vehicle.springs[i].line.parent.xyz.z() = i < 2 ? kFrontTop : kRearTop;
  const ClosedForm closed = ClosedFormOf(vehicle);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const double roll = (closed.to_joints.transpose() * model.stiffness * closed.to_joints)(1, 1);
  double expected = closed.model.stiffness(1, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const double top = i < 2 ? kFrontTop : kRearTop;
    expected += model.preloads.spring[i] * LengthCurvature(top, top - kAxles);
  }
  // As in ExpectSameMatrices.
  EXPECT_NEAR(roll, expected, 1e-11 * 1e6);
  EXPECT_NEAR(1 - roll / closed.model.stiffness(1, 1), 0.05, 0.005);
}

/// How the sensors follow from q, by the places of the rig's transducers ahead of the front axle and left.
std::map<std::string, Eigen::RowVectorXd> SensorRows(const FullCar& car) {
  std::map<std::string, Eigen::RowVectorXd> rows;
  const auto body = [&](double ahead, double left) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(7);
    row.head<3>() << 1, left, -(ahead + car.front.x);
    return row;
  };
  rows["a_cross_member"] = body(0.52, 0);
  rows["a_tow_point"] = body(-3.62, 0);
  rows["a_cg"] = body(-1.454, 0);
  rows["a_left_sill"] = body(-1.454, 0.44);
  const std::array<std::string, 4> corners = {"FL", "FR", "RL", "RR"};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_front = i < 2;
    const double left = i % 2 == 0 ? 1 : -1;
    const double ahead = is_front ? 0 : -2.794;
    const double coil = left * (is_front ? 0.47 : 0.5);
    const auto axle = [&](double y) {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(7);
      row.segment<2>(is_front ? 3 : 5) << 1, y;
      return row;
    };
    rows["a_body_" + corners[i]] = body(ahead, left * 0.44);
    rows["a_axle_" + corners[i]] = axle(left * 0.62);
    rows["s_strut_" + corners[i]] = body(ahead, coil) - axle(coil);
    rows["F_tyre_" + corners[i]] = -car.tyre_stiffness[i] * axle(left * 0.743);
  }
  return rows;
}

TEST(Model3, SensorsReadWhatTheRigsTransducersDo) {
  Draw draw;
  Vehicle vehicle = draw.Parameters(Model3());
  // The closed form's coordinates are those of the centres of mass, the sensors' places are told from the midline.
  for (const char* offset : {"y_body", "y_front", "y_rear"}) Set(vehicle, offset, 0);
  ExpectSensorRows(vehicle, ClosedFormOf(vehicle).to_joints, SensorRows(FullCarOf(vehicle)));
}

// A study needs no renaming; the model has no engine.
TEST(Model3, SensorsCarryTheNamesOfTheRecordedChannels) {
  Diagnostics diagnostics;
  const auto measured = ReadFrequencyResponse(
      std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies" / "landrover110" / "bounce_frf.csv", diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  const Vehicle vehicle = Model3();
  std::vector<std::string> channels = {"a_engine"};
  // Load cells with their pans are those of recordings over time.
  for (const Sensor& sensor : vehicle.sensors)
    if (!sensor.name.starts_with("F_pan")) channels.push_back(sensor.name);
  std::vector<std::string> recorded;
  for (const auto& channel : measured->channels) recorded.push_back(channel.name);
  EXPECT_THAT(channels, testing::UnorderedElementsAreArray(recorded));
}

}  // namespace
}  // namespace fourpost::model3_test
