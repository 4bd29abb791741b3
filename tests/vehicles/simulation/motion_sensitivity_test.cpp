#include "vehicles/simulation/motion_sensitivity.h"

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::motion_sensitivity_test {
namespace {

constexpr double kStep_s = 1e-3;
constexpr Eigen::Index kSteps = 1500;

/// A bounce of 12 mm that climbs from rest to some 12 Hz.
void Posts(Eigen::Index k, std::vector<PostState>& posts) {
  const double t = static_cast<double>(k) * kStep_s;
  const double phase = 2 * std::numbers::pi * 4 * t * t;
  const double speed = 2 * std::numbers::pi * 8 * t;
  for (PostState& post : posts)
    post = {0.012 * (1 - std::cos(phase)), 0.012 * speed * std::sin(phase),
            0.012 * (speed * speed * std::cos(phase) + 16 * std::numbers::pi * std::sin(phase))};
}

/// Readings, one step below the other.
Eigen::VectorXd March(const CondensedModel& model, bool& lifts) {
  CondensedStepper stepper(model, kStep_s);
  std::vector<PostState> posts(stepper.post_count());
  Posts(0, posts);
  stepper.Start(posts);
  Eigen::MatrixXd readings(stepper.sensor_count(), kSteps);
  for (Eigen::Index k = 0; k < kSteps; ++k) {
    Posts(k + 1, posts);
    stepper.Step(posts);
    stepper.Read(readings.col(k));
    lifts = lifts || stepper.lifts();
  }
  return readings.reshaped();
}

/// Changes of the readings, a column per neighbour.
Eigen::MatrixXd Sensitivity(const CondensedModel& model, const std::vector<CondensedModel>& neighbours) {
  CondensedStepper stepper(model, kStep_s);
  MotionSensitivity sensitivity(model, neighbours, kStep_s);
  std::vector<PostState> posts(stepper.post_count());
  Posts(0, posts);
  stepper.Start(posts);
  sensitivity.Start(stepper);
  const Eigen::Index sensors = stepper.sensor_count();
  Eigen::MatrixXd changes(sensors, std::ssize(neighbours));
  Eigen::MatrixXd all(sensors * kSteps, changes.cols());
  for (Eigen::Index k = 0; k < kSteps; ++k) {
    Posts(k + 1, posts);
    stepper.Step(posts);
    sensitivity.Step(stepper);
    sensitivity.Read(stepper, changes);
    all.middleRows(k * sensors, sensors) = changes;
  }
  return all;
}

/// Its damper resists both directions alike as shipped.
Vehicle BilinearQuarterCar() {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  for (Parameter& parameter : vehicle.parameters)
    if (parameter.name == "c_rebound") parameter.value *= 1.5;
  return vehicle;
}

/// Friction beside the damper that sticks, its numbers parameters.
void AddSeal(Vehicle& vehicle, double force) {
  DashpotDescription::Friction friction{.force = {force}, .speed = {}, .stiffness = Scalar{2e5}};
  for (Scalar* number : {&friction.force, &*friction.stiffness}) {
    Parameter parameter;
    parameter.name = "seal_" + std::to_string(vehicle.parameters.size());
    parameter.value = number->value;
    *number = {.value = number->value, .parameter = static_cast<int>(vehicle.parameters.size()), .factor = 1};
    vehicle.parameters.push_back(parameter);
  }
  vehicle.dampers[0].law.friction = friction;
}

struct Case {
  const char* name;
  void (*change)(Vehicle&);
  bool lifts = false;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class MotionSensitivityOf : public testing::TestWithParam<Case> {};

// Against central differences of whole marches, a ten-thousandth to either side. They are smooth to 1e-8 of that; what
// is left are steps in which a kink is met on one side and not on the other.
TEST_P(MotionSensitivityOf, IsTheDifferenceOfMarches) {
  Vehicle vehicle = BilinearQuarterCar();
  GetParam().change(vehicle);
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = condensed.At(values);
  std::vector<CondensedModel> neighbours;
  Eigen::MatrixXd expected;
  bool lifts = false;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const auto moved = [&](double share) {
      std::vector<double> other = values;
      other[p] *= 1 + share;
      return condensed.At(other);
    };
    constexpr double kNear = 1e-6;
    constexpr double kFar = 1e-4;
    neighbours.push_back(moved(kNear));
    ASSERT_TRUE(MotionSensitivity::Covers(model, neighbours.back()));
    const Eigen::VectorXd difference = (March(moved(kFar), lifts) - March(moved(-kFar), lifts)) / (2 * kFar) * kNear;
    expected.conservativeResize(difference.size(), static_cast<Eigen::Index>(p) + 1);
    expected.col(static_cast<Eigen::Index>(p)) = difference;
  }
  EXPECT_EQ(lifts, GetParam().lifts);
  const Eigen::MatrixXd changes = Sensitivity(model, neighbours);
  for (Eigen::Index p = 0; p < changes.cols(); ++p) {
    ASSERT_GT(expected.col(p).norm(), 0) << vehicle.parameters[static_cast<std::size_t>(p)].name;
    EXPECT_LT((changes.col(p) - expected.col(p)).norm(), 5e-3 * expected.col(p).norm())
        << vehicle.parameters[static_cast<std::size_t>(p)].name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Vehicles, MotionSensitivityOf,
    testing::Values(Case{"ThatStaysOnTheGround", [](Vehicle& vehicle) { vehicle.tyres[0].lifts_off = false; }},
                    Case{"WithFrictionBehindAMount",
                         [](Vehicle& vehicle) {
                           vehicle.dampers[0].law.friction =
                               DashpotDescription::Friction{.force = {40}, .speed = {0.02}};
                           vehicle.dampers[0].series = {300e3};
                         }},
                    Case{"WithFrictionThatSticks",
                         [](Vehicle& vehicle) {
                           vehicle.tyres[0].lifts_off = false;
                           AddSeal(vehicle, 60);
                         }},
                    Case{"OnATyreThatStiffens", [](Vehicle& vehicle) { MakeProgressive(vehicle, 20, 0.6); }},
                    Case{"OnAMeasuredTyre",
                         [](Vehicle& vehicle) {
                           MeasureTyres(vehicle);
                           const auto kt = static_cast<int>(vehicle.IndexOf("kt").value());
                           vehicle.tyres[0].damping = {.value = 230, .parameter = kt, .factor = 1e-3};
                         }},
                    Case{"ThatLeavesTheGround", [](Vehicle& vehicle) { vehicle.tyres[0].lifts_off = true; }, true}),
    [](const auto& instance) { return std::string(instance.param.name); });

struct AddedElement {
  const char* name;
  /// Adds that much of it, 1: a usual amount.
  void (*add)(Vehicle&, double amount);
};

void PrintTo(const AddedElement& one, std::ostream* out) { *out << one.name; }

class MotionSensitivityToward : public testing::TestWithParam<AddedElement> {};

// Against marches with a thousandth of the element and without, whose own second order is that small; friction, which
// turns within millimetres per second, has more of it.
TEST_P(MotionSensitivityToward, AnElementThatComesIsTheDifferenceOfMarches) {
  constexpr double kAmount = 1e-3;
  Vehicle vehicle = BilinearQuarterCar();
  vehicle.tyres[0].lifts_off = false;
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  Vehicle other = vehicle;
  GetParam().add(other, kAmount);
  const CondensedModel with = CondensedVehicle(other).At(other.ParameterValues());
  ASSERT_TRUE(MotionSensitivity::Covers(model, with));
  bool lifts = false;
  const Eigen::VectorXd expected = March(with, lifts) - March(model, lifts);
  const Eigen::VectorXd change = Sensitivity(model, {with});
  ASSERT_GT(expected.norm(), 0);
  EXPECT_LT((change - expected).norm(), 1e-2 * expected.norm());
  // And where it goes.
  EXPECT_LT((Sensitivity(with, {model}).col(0) + expected).norm(), 1e-2 * expected.norm());
}

INSTANTIATE_TEST_SUITE_P(
    Elements, MotionSensitivityToward,
    testing::Values(AddedElement{"CubicRate", [](Vehicle& vehicle,
                                                 double amount) { vehicle.springs[0].law.cubic = {4e6 * amount}; }},
                    AddedElement{"Friction",
                                 [](Vehicle& vehicle, double amount) {
                                   Damper damper = vehicle.dampers[0];
                                   damper.name = "friction";
                                   damper.law = {};
                                   damper.law.friction =
                                       DashpotDescription::Friction{.force = {50 * amount}, .speed = {0.02}};
                                   vehicle.dampers.push_back(damper);
                                 }},
                    AddedElement{"StopBesideASpring",
                                 [](Vehicle& vehicle, double amount) {
                                   vehicle.springs[0].law.knees.push_back(
                                       {.side = -1, .at = {0.01}, .rate = {2e5 * amount}, .adds = true});
                                 }}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(MotionSensitivity, DoesNotCoverACoordinateThatComes) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  vehicle.dampers[0].series = {300e3};
  const CondensedModel other = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  EXPECT_TRUE(MotionSensitivity::Covers(model, model));
  EXPECT_FALSE(MotionSensitivity::Covers(model, other));
}

// Its force would need a memory of its own.
TEST(MotionSensitivity, DoesNotCoverFrictionThatSticksAndComes) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  AddSeal(vehicle, 60);
  const CondensedModel other = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  EXPECT_FALSE(MotionSensitivity::Covers(model, other));
  EXPECT_TRUE(MotionSensitivity::Covers(other, other));
}

}  // namespace
}  // namespace fourpost::motion_sensitivity_test
