// Every element at once: the condensed vehicle against the multibody it was taken from.
#include "tests/vehicles/element_car.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <gmock/gmock.h>

#include "tests/vehicles/resting.h"
#include "tests/vehicles/same_model.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/loops/chart.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/condensed_system.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost::element_car_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// All dashpots linear, at the rates that the condensed model's linear part takes, and no hydraulic damper.
Vehicle LinearDashpots(Vehicle vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  for (Damper& damper : vehicle.dampers) {
    const double rate = damper.hydraulic ? 1500 : damper.law.At(values).MeanRate();
    damper.law = {.compression = {rate}, .rebound = {rate}};
    damper.hydraulic.reset();
  }
  return vehicle;
}

/// The multibody's equations in the condensed vehicle's coordinates: x = [s, s', z], posts standing at given motion.
class Reduced {
 public:
  explicit Reduced(const Vehicle& vehicle) : vehicle_(vehicle), multibody_(Resting(vehicle)), chart_(multibody_) {
    basis_ = chart_.MoveTo(VectorXd::Zero(chart_.size()));
    posts_.resize(vehicle.posts.size());
    multibody_.SetPostMotion(
        [this](double, std::span<PostState> posts) { std::copy(posts_.begin(), posts_.end(), posts.begin()); });
  }

  Index freedoms() const { return chart_.size(); }
  Index size() const { return 2 * freedoms() + multibody_.state_size() - 2 * multibody_.coordinate_count(); }
  std::vector<PostState>& posts() { return posts_; }

  VectorXd Derivative(const VectorXd& x) {
    const VectorXd y = multibody_.StateDerivative(NextTime(), State(x));
    VectorXd derivative(x.size());
    const Index n = freedoms();
    // N0'(q - q0) = s, so that s'' = N0' u'.
    derivative << x.segment(n, n), basis_.transpose() * y.segment(y_coordinates(), y_coordinates()),
        y.tail(x.size() - 2 * n);
    return derivative;
  }

  VectorXd Readings(const VectorXd& x) { return multibody_.Readings(NextTime(), State(x)); }

 private:
  Index y_coordinates() const { return multibody_.coordinate_count(); }
  /// Posts are asked once for each time.
  double NextTime() { return time_ += 1; }

  VectorXd State(const VectorXd& x) {
    const Index n = freedoms();
    const MatrixXd tangent = chart_.MoveTo(x.head(n));
    // q - q0 = N0 s + what closes the loops; the multibody is in that pose.
    VectorXd y(multibody_.state_size());
    y << Pose(x.head(n)), tangent * x.segment(n, n), x.tail(x.size() - 2 * n);
    return y;
  }

  /// The chart's pose, found again by Newton's method from its definition.
  VectorXd Pose(const VectorXd& s) {
    VectorXd q = multibody_.design_pose() + basis_ * s;
    for (int i = 0; i < 20; ++i) {
      multibody_.SetPose(q);
      const MatrixXd loops = multibody_.LoopJacobian();
      MatrixXd jacobian(loops.rows() + s.size(), q.size());
      jacobian << loops, basis_.transpose();
      VectorXd error(jacobian.rows());
      error << multibody_.LoopError(), basis_.transpose() * (q - multibody_.design_pose()) - s;
      q -= jacobian.completeOrthogonalDecomposition().solve(error);
    }
    return q;
  }

  Vehicle vehicle_;
  Multibody multibody_;
  Chart chart_;
  MatrixXd basis_;
  std::vector<PostState> posts_;
  double time_ = 0;
};

/// Derivative of a vector function by each component, fourth order.
template <typename Function>
MatrixXd Differenced(Function f, Index components, double step) {
  MatrixXd matrix;
  for (Index j = 0; j < components; ++j) {
    const auto at = [&](double h) { return VectorXd(f(h * step * VectorXd::Unit(components, j))); };
    const VectorXd column = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
    if (matrix.size() == 0) matrix.resize(column.size(), components);
    matrix.col(j) = column;
  }
  return matrix;
}

/// Largest difference within a row, over the row's largest entry.
void ExpectRows(const MatrixXd& actual, const MatrixXd& expected, double tolerance) {
  ASSERT_EQ(actual.rows(), expected.rows());
  ASSERT_EQ(actual.cols(), expected.cols());
  for (Index i = 0; i < actual.rows(); ++i) {
    Index worst = 0;
    const double error = (actual.row(i) - expected.row(i)).cwiseAbs().maxCoeff(&worst);
    EXPECT_LE(error, tolerance * expected.row(i).cwiseAbs().maxCoeff())
        << "row " << i << ", column " << worst << ": " << actual(i, worst) << " for " << expected(i, worst);
  }
}

// Steps of 0.2 mm, 0.2 mrad ..: fifth derivatives of lengths of decimetres leave 1e-9; accelerations of up to
// 1e3 m/s^2, to rounding of forces of 10 kN on 12 kg, leave 1e-13 / 1e-4.
constexpr double kStep = 2e-4;
constexpr double kDifferences = 1e-8;

class ElementCarTest : public testing::Test {
 protected:
  ElementCarTest()
      : vehicle_(LinearDashpots(ElementCar())),
        model_(CondensedVehicle(vehicle_).At(vehicle_.ParameterValues())),
        reduced_(vehicle_) {}

  Index n() const { return reduced_.freedoms(); }
  Index posts() const { return static_cast<Index>(vehicle_.posts.size()); }

  Vehicle vehicle_;
  CondensedModel model_;
  Reduced reduced_;
};

TEST_F(ElementCarTest, HasEveryElementOfAVehicle) {
  const Vehicle car = ElementCar();
  EXPECT_FALSE(car.springs.empty() || car.dampers.empty() || car.bushings.empty() || car.antiroll_bars.empty());
  EXPECT_FALSE(car.tyres.empty() || car.posts.empty() || car.rods.empty() || car.balls.empty());
  EXPECT_FALSE(car.welds.empty() || car.hinges.empty() || car.sensors.empty());
  // Chassis 6, axle 6 - 3 rods, arm 1, hub welded, trailing arm on a hinge 1, engine 6, exhaust on a ball 3.
  EXPECT_EQ(n(), 20);
}

TEST_F(ElementCarTest, RestsInItsDesignPose) {
  for (const Vehicle& car : {vehicle_, ElementCar()}) {
    Multibody multibody = Resting(car);
    // Rounding of 10 kN, once on 12 kg and once on 0.1 kg m^2 at arms of half a metre.
    EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(multibody.Readings(0, multibody.RestState()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST_F(ElementCarTest, HasTheStateMatrixOfTheMultibody) {
  const MatrixXd differenced =
      Differenced([&](const VectorXd& x) { return reduced_.Derivative(x); }, reduced_.size(), kStep);
  ExpectRows(StateMatrix(model_), differenced, kDifferences);
}

TEST_F(ElementCarTest, FeelsItsPostsAsTheMultibodyDoes) {
  const auto derivative = [&](const VectorXd& post) {
    for (Index p = 0; p < posts(); ++p)
      reduced_.posts()[static_cast<std::size_t>(p)] = {.height = post[p], .velocity = post[posts() + p]};
    return VectorXd(reduced_.Derivative(VectorXd::Zero(reduced_.size())).segment(n(), n()));
  };
  MatrixXd force(n(), 2 * posts());
  force << model_.post_stiffness, model_.post_damping;
  ExpectRows(model_.mass.ldlt().solve(force), Differenced(derivative, 2 * posts(), kStep), kDifferences);
}

TEST_F(ElementCarTest, HasTheSensorsOfTheMultibody) {
  const MatrixXd state = StateMatrix(model_);
  MatrixXd rows = model_.on_acceleration * state.middleRows(n(), n());
  rows.leftCols(n()) += model_.on_position;
  rows.middleCols(n(), n()) += model_.on_velocity;
  const MatrixXd differenced =
      Differenced([&](const VectorXd& x) { return reduced_.Readings(x); }, reduced_.size(), kStep);
  ExpectRows(rows, differenced, kDifferences);
}

TEST_F(ElementCarTest, HasTheSensorsOfTheMultibodyOverItsPosts) {
  const Index p = posts();
  const auto readings = [&](const VectorXd& post) {
    for (Index i = 0; i < p; ++i)
      reduced_.posts()[static_cast<std::size_t>(i)] = {post[i], post[p + i], post[2 * p + i]};
    return reduced_.Readings(VectorXd::Zero(reduced_.size()));
  };
  MatrixXd rows(model_.on_position.rows(), 3 * p);
  const auto mass = model_.mass.ldlt();
  rows << model_.on_post_height + model_.on_acceleration * mass.solve(model_.post_stiffness),
      model_.on_post_velocity + model_.on_acceleration * mass.solve(model_.post_damping), model_.on_post_acceleration;
  ExpectRows(rows, Differenced(readings, 3 * p, kStep), kDifferences);
}

/// All parameters, or one, a tenth larger.
std::vector<double> Larger(const Vehicle& vehicle, int only = -1) {
  std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (only < 0 || static_cast<int>(i) == only) values[i] *= 1.1;
  return values;
}

Vehicle With(Vehicle vehicle, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) vehicle.parameters[i].value = values[i];
  return vehicle;
}

/// Far from rest: centimetres, decimetres a second, series springs under some 100 N, oil under 0.1 MPa.
VectorXd SomeState(const Multibody& multibody, int number) {
  VectorXd state = multibody.RestState();
  const Index n = multibody.coordinate_count();
  for (Index i = 0; i < state.size(); ++i) {
    const double size = i < n ? 0.06 : i < 2 * n ? 0.3 : i < 2 * n + 2 ? 0.001 : 0.1;
    state[i] += size * std::sin(1.0 + number + (1.7 + 0.1 * number) * static_cast<double>(i));
  }
  return state;
}

/// What the multibody answers in eight states, which close every stop and pass every knee.
struct Answers {
  MatrixXd derivatives;
  MatrixXd readings;
  MatrixXd residuals;
};

Answers AnswersOf(Multibody& multibody) {
  constexpr int kStates = 8;
  multibody.SetPostMotion([](double, std::span<PostState> posts) {
    std::fill(posts.begin(), posts.end(), PostState{.height = 0.01, .velocity = 0.1, .acceleration = 3});
  });
  const Index size = multibody.state_size();
  const Index sensors = static_cast<Index>(multibody.vehicle().sensors.size());
  Answers answers{MatrixXd(size, kStates), MatrixXd(sensors, kStates),
                  MatrixXd(size - multibody.coordinate_count(), kStates)};
  for (int i = 0; i < kStates; ++i) {
    const VectorXd state = SomeState(multibody, i);
    answers.derivatives.col(i) = multibody.StateDerivative(0, state);
    answers.readings.col(i) = multibody.Readings(0, state);
    answers.residuals.col(i) = multibody.Residual(0, state, VectorXd::Zero(size));
  }
  return answers;
}

TEST(ElementCar, ChangedParametersEqualARebuiltMultibody) {
  const Vehicle vehicle = ElementCar();
  const std::vector<double> values = Larger(vehicle);
  Multibody changed = Resting(vehicle);
  AnswersOf(changed);
  changed.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  Multibody rebuilt = Resting(With(vehicle, values), values);
  const Answers a = AnswersOf(changed);
  const Answers b = AnswersOf(rebuilt);
  EXPECT_TRUE(a.derivatives.allFinite());
  // Preloads of a rebuilt vehicle follow from differences of poses, and those at given parameters as well: the same.
  EXPECT_EQ(a.derivatives, b.derivatives);
  EXPECT_EQ(a.readings, b.readings);
  EXPECT_EQ(a.residuals, b.residuals);
}

TEST(ElementCar, ChangedParametersEqualARebuiltCondensedVehicle) {
  const Vehicle vehicle = ElementCar();
  const std::vector<double> values = Larger(vehicle);
  const CondensedModel changed = CondensedVehicle(vehicle).At(values);
  const CondensedModel rebuilt = CondensedVehicle(With(vehicle, values)).At(values);
  ExpectSameModel(changed, rebuilt);
  EXPECT_EQ(StateMatrix(changed), StateMatrix(rebuilt));
}

// A centre of mass that parameters move against one that stands in the tree.
TEST(ElementCar, MovedCentreOfMassEqualsAFixedOne) {
  Vehicle moved = ElementCar();
  std::vector<double> values = moved.ParameterValues();
  for (std::size_t i = 1; i < 4; ++i) values[i] += 0.07 * static_cast<double>(i);
  Vehicle fixed = moved;
  for (Scalar& component : fixed.links[1].com) component = {.value = component.At(values)};
  const CondensedModel a = CondensedVehicle(moved).At(values);
  const CondensedModel b = CondensedVehicle(fixed).At(values);
  EXPECT_NE(CondensedVehicle(moved).At(moved.ParameterValues()).mass, a.mass);
  EXPECT_LT((a.mass - b.mass).norm(), 1e-13 * b.mass.norm());  // rounding
  // Second derivatives of heights: differences leave 1e-10 / m of 10 kN, beside stiffnesses of 1 MN/m.
  EXPECT_LT((a.stiffness - b.stiffness).norm(), 1e-11 * b.stiffness.norm());
  for (std::size_t i = 0; i < a.preloads.tyre.size(); ++i)
    EXPECT_NEAR(a.preloads.tyre[i], b.preloads.tyre[i], 1e-8);  // rounding of 10 kN
}

// No number is read and then forgotten.
TEST(ElementCar, EveryParameterMovesTheMultibody) {
  const Vehicle vehicle = ElementCar();
  const CondensedVehicle condensed(vehicle);
  Multibody multibody = Resting(vehicle);
  const Answers before = AnswersOf(multibody);
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const std::vector<double> values = Larger(vehicle, static_cast<int>(i));
    multibody.SetParameters(values, condensed.PreloadsAt(values));
    const Answers after = AnswersOf(multibody);
    const double change = (after.derivatives - before.derivatives).norm() + (after.readings - before.readings).norm();
    EXPECT_GT(change, 1e-6) << vehicle.parameters[i].name;
  }
}

/// 80 mm at 1.5 Hz, each post another share of it.
void LargeMotion(double t, std::span<PostState> posts) {
  constexpr std::array<double, 4> kShares = {1, 0.5, -0.3, 0.2};
  const double omega = 2 * std::numbers::pi * 1.5;
  for (std::size_t i = 0; i < posts.size(); ++i) {
    const double amplitude = 0.08 * kShares.at(i);
    posts[i] = {.height = amplitude * std::sin(omega * t),
                .velocity = amplitude * omega * std::cos(omega * t),
                .acceleration = -amplitude * omega * omega * std::sin(omega * t)};
  }
}

TEST(ElementCar, EveryParameterMovesTheCondensedVehicle) {
  const Vehicle vehicle = ElementCar();
  const CondensedVehicle condensed(vehicle);
  const auto answer = [&](const std::vector<double>& values) {
    const CondensedModel model = condensed.At(values);
    CondensedSystem system(model, RigViewOf(vehicle), 1e-3);
    return Simulate(system, LargeMotion, {.end_s = 0.7, .rate_Hz = 100}).readings;
  };
  const MatrixXd before = answer(vehicle.ParameterValues());
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const double change = (answer(Larger(vehicle, static_cast<int>(i))) - before).norm() / before.norm();
    EXPECT_GT(change, 1e-9) << vehicle.parameters[i].name;
  }
}

// At rest in the design pose whatever the parameters are.
TEST(ElementCar, RestsWithAnyParameters) {
  const Vehicle vehicle = ElementCar();
  const CondensedVehicle condensed(vehicle);
  Multibody multibody = Resting(vehicle);
  for (int i = 0; i < static_cast<int>(vehicle.parameters.size()); ++i) {
    const std::vector<double> values = Larger(vehicle, i);
    multibody.SetParameters(values, condensed.PreloadsAt(values));
    // As in ElementCarTest.RestsInItsDesignPose.
    EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).cwiseAbs().maxCoeff(), 1e-9)
        << vehicle.parameters[static_cast<std::size_t>(i)].name;
  }
}

TEST(ElementCar, HasTheSameForwardAndInverseDynamics) {
  // Without loop closures, whose forces inverse dynamics leave out.
  Vehicle vehicle = ElementCar();
  vehicle.rods.clear();
  vehicle.balls.clear();
  vehicle.welds.clear();
  vehicle.hinges.clear();
  Multibody multibody(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const Preloads preloads = CondensedVehicle(ElementCar()).PreloadsAt(values);
  multibody.SetParameters(values, preloads);
  const VectorXd state = SomeState(multibody, 0);
  const VectorXd derivative = multibody.StateDerivative(0, state);
  const Index n = multibody.coordinate_count();
  ASSERT_EQ(state.size(), 2 * n + 6);  // two series springs, two chambers of two dampers
  const VectorXd residual = multibody.Residual(0, state, derivative);
  // Rounding of forces of 1e5 N; of 1e3 MPa/s.
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-9);
  for (Index i = n; i < state.size(); ++i) {
    const VectorXd other = derivative + VectorXd::Unit(state.size(), i);
    EXPECT_GT((multibody.Residual(0, state, other) - residual).cwiseAbs().maxCoeff(), 0.05)
        << "no use of derivative " << i;
  }
}

}  // namespace
}  // namespace fourpost::element_car_test
