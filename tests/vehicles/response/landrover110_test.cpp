// The shipped Land Rovers in space, on bushes and on rigid links: statics, freedoms, symmetry, and agreement with each
// other and with Model 3.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/files/frequency_response_file.h"
#include "tests/vehicles/lint_all.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/response/mode_band.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::landrover110_test {
namespace {

using Complex = std::complex<double>;

const std::array<std::string, 4> kCorners = {"FL", "FR", "RL", "RR"};
const std::vector<double> kBounce = {1, 1, 1, 1};
const std::vector<double> kRoll = {1, -1, 1, -1};

VehicleSummary SummaryOf(const Vehicle& vehicle) { return Summarise(vehicle, vehicle.ParameterValues()); }

/// Response of each channel to the recorded frequencies up to `last_Hz`. The cars' laws make gains independent of the
/// amplitude.
std::map<std::string, std::vector<Complex>> Responses(const Vehicle& vehicle, const std::vector<double>& shape,
                                                      double last_Hz) {
  const Excitation all = RecordedExcitation("bounce_frf.csv", shape);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < all.frequency_Hz.size() && all.frequency_Hz[i] <= last_Hz; ++i) indices.push_back(i);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  // So many harmonics for every car: differences between cars are then none of truncation.
  constexpr HarmonicBalanceOptions kAlike{.error = 1e9};
  const PeriodicResponse periodic = SolveHarmonicBalance(model, vehicle.sensors, Only(all, indices), kAlike);
  EXPECT_TRUE(periodic.unconverged_Hz.empty());
  std::map<std::string, std::vector<Complex>> responses;
  for (const ChannelResponse& channel : periodic.response.channels) responses[channel.name] = channel.response;
  return responses;
}

std::vector<Complex> Sum(std::vector<Complex> a, const std::vector<Complex>& b) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::plus<>());
  return a;
}

/// Largest |a - b| over the largest |b|.
double Difference(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double largest = 0;
  double scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return largest / scale;
}

double LargestDecibels(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(DecibelFromGain(std::abs(a[i] / b[i]))));
  return largest;
}

void Scale(Vehicle& vehicle, const std::string& name, double factor) {
  const auto parameter = std::find_if(vehicle.parameters.begin(), vehicle.parameters.end(),
                                      [&](const Parameter& candidate) { return candidate.name == name; });
  ASSERT_NE(parameter, vehicle.parameters.end()) << name;
  parameter->value *= factor;
}

/// The rod of the car on bushes is a body, the last of all, on another one without mass.
Vehicle WithoutPanhardRod(Vehicle vehicle) {
  const auto is_panhard = [](const auto& element) { return element.name == "panhard"; };
  if (std::erase_if(vehicle.rods, is_panhard) == 1) return vehicle;
  EXPECT_EQ(std::erase_if(vehicle.bushings, is_panhard), 1U);
  EXPECT_EQ(vehicle.links.back().name, "panhard");
  vehicle.links.resize(vehicle.links.size() - 2);
  std::erase_if(vehicle.joints,
                [&](const Joint& joint) { return joint.child >= static_cast<int>(vehicle.links.size()); });
  return vehicle;
}

/// What both cars are checked for.
class BothCars : public testing::TestWithParam<std::string> {
 protected:
  const Vehicle vehicle_ = ShippedVehicle(GetParam());
};

TEST_P(BothCars, RestInTheirDesignPose) {
  Multibody multibody = Prepared(vehicle_).multibody;
  // Rounding of forces of some 10 kN on the least inertia, 0.2 kg m^2.
  EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST_P(BothCars, TyresBearTheWeightWhereItIs) {
  Vehicle vehicle = vehicle_;
  Set(vehicle, "y_body", 0.03);
  Set(vehicle, "y_front", -0.04);
  Set(vehicle, "y_rear", 0.02);
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
  Eigen::Vector3d borne = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    borne += preloads.tyre[i] * Eigen::Vector3d(1, i < 2 ? 0 : -2.794, i % 2 == 0 ? 0.743 : -0.743);
  // Body, front and rear axle, A-frame.
  Eigen::Vector3d weight = 1725 * Eigen::Vector3d(1, -1.456, 0.03) + 220 * Eigen::Vector3d(1, 0, -0.04) +
                           220 * Eigen::Vector3d(1, -2.794, 0.02) + 8 * Eigen::Vector3d(1, -2.425, 0);
  // Panhard rod and trailing links at the chassis.
  if (vehicle.rods.empty()) weight += 2 * Eigen::Vector3d(1, 0.09, -0.46) + 4 * Eigen::Vector3d(1, -1.9, 0);
  // Rounding.
  EXPECT_LT((borne - kGravity * weight).norm(), 1e-12 * borne.norm());
}

TEST_P(BothCars, HaveNothingOddAboutThem) { EXPECT_EQ(Lint(vehicle_).Format(), ""); }

TEST_P(BothCars, OscillateInEveryMode) {
  const VehicleSummary summary = SummaryOf(vehicle_);
  EXPECT_EQ(summary.modes.size(), static_cast<std::size_t>(summary.dof));
  for (const Mode& mode : summary.modes) {
    EXPECT_EQ(mode.kind, Mode::Kind::kOscillating) << mode.name;
    EXPECT_GT(mode.damping_ratio, 0.02) << mode.name;
  }
}

TEST_P(BothCars, MoveAtFrequenciesOfACar) {
  const std::array<ModeBand, 8> kBands = {{{"heave", 1, 2},
                                           {"pitch", 1, 2.5},
                                           {"roll", 0.9, 3.5},
                                           {"yaw", 2, 8},
                                           {"front hop", 8, 13},
                                           {"rear hop", 8, 13},
                                           {"front tramp", 8, 15},
                                           {"rear tramp", 8, 15}}};
  const VehicleSummary summary = SummaryOf(vehicle_);
  ExpectWithin(kBands, summary);
}

TEST_P(BothCars, TakeTheParametersOfModel3) {
  const Vehicle model3 = ShippedVehicle("landrover110_model3");
  ASSERT_GT(vehicle_.parameters.size(), model3.parameters.size());
  for (std::size_t i = 0; i < model3.parameters.size(); ++i) {
    EXPECT_EQ(vehicle_.parameters[i].name, model3.parameters[i].name);
    EXPECT_EQ(vehicle_.parameters[i].value, model3.parameters[i].value);
    EXPECT_EQ(vehicle_.parameters[i].lower, model3.parameters[i].lower);
    EXPECT_EQ(vehicle_.parameters[i].upper, model3.parameters[i].upper);
  }
}

// A study needs no renaming; the model has no engine.
TEST_P(BothCars, SensorsCarryTheNamesOfTheRecordedChannels) {
  Diagnostics diagnostics;
  const auto measured = ReadFrequencyResponse(
      std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies" / "landrover110" / "bounce_frf.csv", diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  std::vector<std::string> channels = {"a_engine"};
  // Load cells with their pans are those of recordings over time.
  for (const Sensor& sensor : vehicle_.sensors)
    if (!sensor.name.starts_with("F_pan")) channels.push_back(sensor.name);
  std::vector<std::string> recorded;
  for (const auto& channel : measured->channels) recorded.push_back(channel.name);
  EXPECT_THAT(channels, testing::UnorderedElementsAreArray(recorded));
  std::vector<std::string> posts;
  for (const Post& post : vehicle_.posts) posts.push_back(post.name);
  EXPECT_THAT(posts, testing::ElementsAreArray(kCorners));
}

/// Largest difference of a channel on the left from `sign` times its twin on the right.
double Asymmetry(const Vehicle& vehicle, const std::vector<double>& shape, double sign) {
  const auto responses = Responses(vehicle, shape, 30);
  double largest = 0;
  for (const char* channel : {"a_body_", "a_axle_", "s_strut_", "F_tyre_"})
    for (const char* axle : {"F", "R"}) {
      const std::string name = std::string(channel) + axle;
      std::vector<Complex> right = responses.at(name + "R");
      for (Complex& value : right) value *= sign;
      largest = std::max(largest, Difference(responses.at(name + "L"), right));
    }
  return largest;
}

TEST_P(BothCars, AreAlikeOnBothSidesButForThePanhardRod) {
  // Second derivatives of lengths are good to 1e-11 of the stiffness; resonances and sums over poles make more of it.
  constexpr double kDifferences = 1e-9;
  // The posts' amplitudes lift wheels in roll, and a motion with such kinks is known less well.
  const Vehicle alike = WithLinearTyres(WithoutPanhardRod(vehicle_));
  EXPECT_LT(Asymmetry(alike, kBounce, 1), kDifferences);
  EXPECT_LT(Asymmetry(alike, kRoll, -1), kDifferences);
  EXPECT_GT(Asymmetry(vehicle_, kBounce, 1), 0.01);
}

/// Both see the same vertical motion where rear dampers of Model 3 do what inclined ones do: their extension, and what
/// their force does upward, is cos(29.6 deg) as much. What remains is the slope of the links, the axles' pitch inertia,
/// the rubber of the bushes and 8 kg of A-frame.
TEST_P(BothCars, HeaveAsModel3BelowSixHertz) {
  constexpr double kAgreement_dB = 0.4;
  Vehicle model3 = ShippedVehicle("landrover110_model3");
  const double cosine = Eigen::Vector3d(0.27, -0.09, 0.5).normalized().z();
  for (const char* rate : {"c_rear_bump", "c_rear_rebound"}) Scale(model3, rate, cosine * cosine);
  Vehicle car = vehicle_;
  Set(car, "ct", 0);
  for (const char* mount : {"k_mount_front", "k_mount_rear"}) Set(car, mount, 1e9);
  const auto expected = Responses(model3, kBounce, 6);
  const auto actual = Responses(car, kBounce, 6);
  for (const char* channel : {"a_body_F", "a_body_R", "a_axle_F", "a_axle_R", "s_strut_F", "s_strut_R"}) {
    const auto both = [&](const auto& responses) {
      return Sum(responses.at(std::string(channel) + "L"), responses.at(std::string(channel) + "R"));
    };
    EXPECT_LT(LargestDecibels(both(actual), both(expected)), kAgreement_dB) << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(Landrover110, BothCars, testing::Values("landrover110", "landrover110_rigid"));

TEST(Landrover110, HasTheFreedomsThatItsFileTells) {
  EXPECT_EQ(SummaryOf(ShippedVehicle("landrover110")).dof, 27);
  EXPECT_EQ(SummaryOf(ShippedVehicle("landrover110_rigid")).dof, 10);
}

// For small motion of the posts; geometry bends more for larger.
TEST(Landrover110, MovesInSimbodyAsItsCondensedModel) {
  constexpr double kScale = 1e-3;
  Prepared car(ShippedVehicle("landrover110"));
  const Excitation excitation = Sparse(RecordedExcitation("bounce_frf.csv", kBounce, kScale));
  ExpectAgreement(car.Linearised(excitation).response, car.Full(excitation).response, 1e-3, 5e-3);
}

/// The car on bushes of `much` the stiffness, whose arms may slide along their bushes' axes; links without mass, as in
/// the rigid car. Without the Panhard rod nothing rolls in bounce: the rigid car's front axle is free to, this one's is
/// not.
Vehicle Stiffened(double much) {
  Vehicle vehicle = WithoutPanhardRod(ShippedVehicle("landrover110"));
  for (const char* rate : {"k_arm_bush", "k_arm_lift", "k_trailing_link", "k_a_frame_bush"}) Scale(vehicle, rate, much);
  for (const char* rate : {"kr_arm_bush", "kr_link_bush", "kr_a_frame_bush", "loss"}) Set(vehicle, rate, 0);
  for (Link& link : vehicle.links)
    if (link.name.starts_with("trailing_R")) link.mass.value = 1e-6;
  return vehicle;
}

TEST(Landrover110, BecomesTheRigidCarWhereNoBushYields) {
  const auto rigid = Responses(WithoutPanhardRod(ShippedVehicle("landrover110_rigid")), kBounce, 30);
  const auto stiff = Responses(Stiffened(200), kBounce, 30);
  const auto stiffer = Responses(Stiffened(2000), kBounce, 30);
  // Deviations, some 1e-6 of the response, go with the bushes' compliance, but for its square and the iteration of
  // harmonic balance.
  for (const auto& [channel, response] : rigid)
    EXPECT_NEAR(Difference(stiffer.at(channel), response) / Difference(stiff.at(channel), response), 0.1, 0.003)
        << channel;
}

/// First coordinate of a joint in the order of the file.
Eigen::Index CoordinateOf(const Vehicle& vehicle, const std::string& joint) {
  Eigen::Index coordinate = 0;
  for (const Joint& candidate : vehicle.joints) {
    if (candidate.name == joint) return coordinate;
    coordinate += candidate.type == Joint::Type::kFloating ? 6 : 1;
  }
  ADD_FAILURE() << "no joint " << joint;
  return 0;
}

// The arms turn by an angle about their seats, .87 m behind the axle's x and .46 m high, and the rod's end on the axle
// with them, from (.09, .50, .43) on a circle across y; it is .96 m to the left of the rod's end on the chassis and
// .04 m below. What it goes ahead and up, the rod takes from its sideways reach.
TEST(Landrover110, PanhardRodShiftsTheRigidFrontAxleOnItsCircle) {
  const Vehicle vehicle = ShippedVehicle("landrover110_rigid");
  Multibody multibody(vehicle);
  const double length = std::hypot(0.96, 0.04);
  for (const double angle : {-0.1, -0.05, 0.05, 0.1}) {
    const double ahead = 0.96 * std::cos(angle) - 0.03 * std::sin(angle) - 0.96;
    const double up = -0.96 * std::sin(angle) - 0.03 * std::cos(angle) + 0.03 - 0.04;
    const double reach = std::sqrt(length * length - ahead * ahead - up * up);
    Eigen::VectorXd pose = multibody.design_pose();
    pose[CoordinateOf(vehicle, "arm_hinge")] = angle;
    pose[CoordinateOf(vehicle, "arm_slide")] = reach - 0.96;
    multibody.SetPose(pose);
    const auto& loops = multibody.loop_closures();
    const auto panhard = std::find_if(loops.begin(), loops.end(),
                                      [](const LoopClosure& loop) { return loop.element == "fp:rod 'panhard'"; });
    ASSERT_NE(panhard, loops.end());
    // Rounding of positions of metres.
    EXPECT_NEAR(multibody.LoopError()[panhard->first_row], 0, 1e-15) << angle;
    EXPECT_GT(std::abs(reach - 0.96), 1e-4);
  }
}

}  // namespace
}  // namespace fourpost::landrover110_test
