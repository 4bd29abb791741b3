#include "identify/experiments/time_history/release.h"

#include <array>
#include <cmath>
#include <memory>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "identify/experiments/time_history/history_simulation.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/simulation/condensed_stepper.h"

namespace fourpost::release_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kRate_Hz = 500;
constexpr std::size_t kBody = 2;
constexpr std::size_t kWheel = 3;

class ReleaseTest : public testing::Test {
 protected:
  CondensedModel Model() { return CondensedVehicle(vehicle_).At(vehicle_.ParameterValues()); }

  /// The quarter car let go; signals: heights of body and wheel, all zero.
  MeasuredHistory Dropped(const Release& release, double duration_s = 1.5) {
    const auto count = static_cast<Index>(duration_s * kRate_Hz);
    MeasuredHistory history{
        .name = "drop",
        .rate_Hz = kRate_Hz,
        .posts = {.motion = [](double,
                               std::span<PostState> posts) { std::fill(posts.begin(), posts.end(), PostState()); },
                  .count = 1,
                  .start_s = 0,
                  .end_s = duration_s,
                  .step_s = 1 / kRate_Hz},
        .release = release,
        .count = count};
    for (const std::size_t sensor : {kBody, kWheel})
      history.signals.push_back({.sensor = sensor,
                                 .name = vehicle_.sensors[sensor].name,
                                 .unit = "m",
                                 .values = VectorXd::LinSpaced(count, 0, 1)});
    return history;
  }

  static Release Held(std::optional<double> reading_m) {
    return {.from = Release::From::kHeld, .held = {{.sensor = "z_sprung", .index = kBody, .reading_m = reading_m}}};
  }

  /// With what the vehicle does from this state as its measurement.
  MeasuredHistory Recorded(const Release& truth, const Release& stated) {
    MeasuredHistory history = Dropped(truth);
    const Eigen::MatrixXd run = HistorySimulation(history, 5e-4).Run(Model());
    for (std::size_t s = 0; s < history.signals.size(); ++s) history.signals[s].values = run.col(static_cast<Index>(s));
    history.release = stated;
    return history;
  }

  Vehicle vehicle_ = ShippedVehicle("quarter_car");
  double weight_N_ = (200 + 22) * kGravity;
  double stiffness_ = 15e3;
};

// A body that is lifted until the wheel hangs: the spring, which carried the body, carries the wheel.
TEST_F(ReleaseTest, HoldsTheBodyWithAHangingWheel) {
  const double lifted = 0.3;
  const VectorXd state = ReleasedState(Held(lifted), Model(), VectorXd());
  const CondensedModel model = Model();
  const VectorXd heights = model.on_position * state.head(2);
  EXPECT_NEAR(heights[kBody], lifted, 1e-9);
  EXPECT_NEAR(heights[kWheel], lifted - weight_N_ / stiffness_, 1e-9);  // forces are solved to 1e-9
  EXPECT_EQ(state.tail(2).norm(), 0);
}

// Before the tyre touches, only weight acts on both masses together.
TEST_F(ReleaseTest, FallsFreelyUntilTheTyreTouches) {
  const double lifted = 0.3;
  const MeasuredHistory history = Dropped(Held(lifted), 0.2);
  const Eigen::MatrixXd readings =
      HistorySimulation(history, 5e-4).Readings(Model(), HistorySimulation(history, 5e-4).StateOf(Model()));
  const VectorXd centre = (200 * readings.col(kBody) + 22 * readings.col(kWheel)) / 222;
  const double touches = weight_N_ / 230e3;  // where a tyre of 230 kN/m begins to carry, above rest
  Index k = 0;
  for (; k < history.count && readings(k, kWheel) > touches; ++k) {
    const double t = static_cast<double>(k) / kRate_Hz;
    // The stepper's error of second order in nonlinear forces: 1e-6 of the drop.
    EXPECT_NEAR(centre[k], centre[0] - 0.5 * kGravity * t * t, 1e-5) << t;
  }
  EXPECT_GT(k, 10);
}

TEST_F(ReleaseTest, FindsTheHeightItWasHeldAt) {
  const MeasuredHistory history = Recorded(Held(0.3), Held(std::nullopt));
  const HistorySimulation::Start start = HistorySimulation(history, 5e-4).StartOf(Model());
  ASSERT_EQ(start.estimate.unknowns.size(), 1);
  EXPECT_NEAR(start.estimate.unknowns[0], 0.3, 1e-7);
  EXPECT_LT(start.estimate.covariance(0, 0), 1e-12);
}

TEST_F(ReleaseTest, FindsPoseAndVelocityOfAnyState) {
  Release truth;
  truth.guess = (VectorXd(4) << 0.03, 0.01, -0.4, 0.2).finished();
  MeasuredHistory history = Dropped(truth);
  const HistorySimulation simulation(history, 5e-4);
  const Eigen::MatrixXd run = simulation.Run(Model(), ReleasedState(truth, Model(), truth.guess), {});
  for (std::size_t s = 0; s < 2; ++s) history.signals[s].values = run.col(static_cast<Index>(s));
  history.release = Release();
  const HistorySimulation::Start start = HistorySimulation(history, 5e-4).StartOf(Model());
  EXPECT_LT((start.estimate.unknowns - truth.guess).norm(), 1e-6);
}

// Deviations of an estimate from noisy signals are those it states.
TEST_F(ReleaseTest, StatesHowWellItKnowsTheHeight) {
  constexpr int kDraws = 40;
  constexpr double kNoise_m = 1e-3;
  const MeasuredHistory exact = Recorded(Held(0.3), Held(std::nullopt));
  double squares = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    MeasuredHistory noisy = exact;
    RandomStream draws(1, "noise", static_cast<std::uint64_t>(draw));
    for (MeasuredSignal& signal : noisy.signals) {
      for (double& value : signal.values) value += kNoise_m * draws.Normal();
      signal.noise_sd = kNoise_m;
    }
    noisy.release->model_error = 0;
    const EstimatedStart estimate = HistorySimulation(noisy, 1e-3).StartOf(Model()).estimate;
    squares += std::pow(estimate.unknowns[0] - 0.3, 2) / estimate.covariance(0, 0);
  }
  // Chi-square of 40: 95 % between 0.61 and 1.48.
  EXPECT_GT(squares / kDraws, 0.5);
  EXPECT_LT(squares / kDraws, 1.6);
}

TEST_F(ReleaseTest, EnginesAgreeOnADrop) {
  const MeasuredHistory history = Recorded(Held(0.3), Held(0.3));
  const std::vector<double> values = vehicle_.ParameterValues();
  const Eigen::MatrixXd reduced = SimulateBy({.engine = Engine::kReduced}, history, vehicle_, values)->modelled;
  const std::optional<EngineHistory> full = SimulateBy({.engine = Engine::kFull}, history, vehicle_, values);
  EXPECT_EQ(full->by.engine, Engine::kFull);
  // Its motions are straight lines: both are exact but for their integration, 1e-3 each.
  for (Index s = 0; s < 2; ++s) EXPECT_LT((full->modelled - reduced).col(s).norm(), 2e-3 * reduced.col(s).norm());
}

/// Friction that sticks, and bends before it slides by a millimetre.
DashpotDescription::Friction Seal() { return {.force = {100}, .speed = {}, .stiffness = Scalar{1e5}}; }

// In one stroke from rest: friction holds the wheel up or down besides the spring.
TEST_F(ReleaseTest, HoldsTheBodyAgainstFriction) {
  vehicle_.dampers[0].law.friction = Seal();
  const double lifted = 0.3;
  const CondensedModel model = Model();
  const VectorXd heights = model.on_position * ReleasedState(Held(lifted), model, VectorXd()).head(2);
  EXPECT_NEAR(heights[kWheel], lifted - (weight_N_ - 100) / stiffness_, 1e-9);  // forces are solved to 1e-9
  vehicle_.dampers[0].law.friction->stiffness = Scalar{1e8};
  EXPECT_NO_THROW(ReleasedState(Held(lifted), Model(), VectorXd()));
}

TEST_F(ReleaseTest, EnginesAgreeOnADropWithFrictionThatSticks) {
  vehicle_.dampers[0].law.friction = Seal();
  const MeasuredHistory history = Recorded(Held(0.3), Held(0.3));
  const std::vector<double> values = vehicle_.ParameterValues();
  const Eigen::MatrixXd reduced = SimulateBy({.engine = Engine::kReduced}, history, vehicle_, values)->modelled;
  const std::optional<EngineHistory> full = SimulateBy({.engine = Engine::kFull}, history, vehicle_, values);
  EXPECT_EQ(full->by.engine, Engine::kFull);
  for (Index s = 0; s < 2; ++s) EXPECT_LT((full->modelled - reduced).col(s).norm(), 2e-3 * reduced.col(s).norm());
  // It comes to rest beside the pose without friction, within the force over the spring's rate.
  const MeasuredHistory longer = Dropped(Held(0.3), 4);
  const HistorySimulation simulation(longer, 5e-4);
  const Eigen::MatrixXd heights = simulation.Readings(Model(), simulation.StateOf(Model()));
  const double left = heights(heights.rows() - 1, kBody) - heights(heights.rows() - 1, kWheel);
  EXPECT_GT(std::abs(left), 1e-3);
  EXPECT_LT(std::abs(left), 100 / stiffness_);
}

/// Pose, velocities, and half of the friction in bump.
VectorXd OnTheWay() { return (VectorXd(5) << 0.03, 0.01, -0.4, 0.2, -5e-4).finished(); }

TEST_F(ReleaseTest, FrictionBeginsWithTheTensionThatIsStated) {
  vehicle_.dampers[0].law.friction = Seal();
  const CondensedModel model = Model();
  const std::array<PostState, 1> posts;
  CondensedStepper stepper(model, 1e-3);
  const auto accelerations = [&](double tension_m) {
    VectorXd unknowns = OnTheWay();
    unknowns[4] = tension_m;
    stepper.SetState(ReleasedState(Release(), model, unknowns), posts);
    return VectorXd(stepper.StateRate().segment(2, 2));
  };
  const VectorXd by_friction = model.mass * (accelerations(-5e-4) - accelerations(0));
  constexpr double kTension = -5e-4 * 1e5;
  EXPECT_NEAR((by_friction + kTension * model.rubbings[0].direction).norm(), 0, 1e-6 * 100);
}

TEST_F(ReleaseTest, FindsTheTensionOfFriction) {
  vehicle_.dampers[0].law.friction = Seal();
  Release truth;
  truth.guess = OnTheWay();
  MeasuredHistory history = Dropped(truth);
  const HistorySimulation simulation(history, 5e-4);
  const Eigen::MatrixXd run = simulation.Run(Model(), ReleasedState(truth, Model(), truth.guess), {});
  for (std::size_t s = 0; s < 2; ++s) history.signals[s].values = run.col(static_cast<Index>(s));
  history.release = Release();
  const HistorySimulation::Start start = HistorySimulation(history, 5e-4).StartOf(Model());
  EXPECT_LT((start.estimate.unknowns - truth.guess).norm(), 1e-5) << start.estimate.unknowns.transpose();
  // Both engines go on from there alike: 1e-3 of each by integration.
  const std::vector<double> values = vehicle_.ParameterValues();
  const Eigen::MatrixXd reduced = SimulateBy({.engine = Engine::kReduced}, history, vehicle_, values)->modelled;
  const Eigen::MatrixXd full = SimulateBy({.engine = Engine::kFull}, history, vehicle_, values)->modelled;
  for (Index s = 0; s < 2; ++s) EXPECT_LT((full - reduced).col(s).norm(), 2e-3 * reduced.col(s).norm());
}

}  // namespace
}  // namespace fourpost::release_test
