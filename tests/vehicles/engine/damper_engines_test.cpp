// Random dampers of a quarter car by Simbody's own integrator, which shares no solver with the engines.
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

#include <gtest/gtest.h>

#include "tests/vehicles/random_dampers.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/response/march.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost::damper_engines_test {
namespace {

constexpr int kDampers = 15;
/// On stiffer mounts an explicit integrator takes minutes; tests/validation/damper_engines.cpp has them.
constexpr double kStiffest = 1e6;

class DamperEngines : public testing::TestWithParam<int> {
 protected:
  DamperEngines()
      : vehicle_(QuarterCarWith(drawn_.elements)), model_(CondensedVehicle(vehicle_).At(vehicle_.ParameterValues())) {
    multibody_.emplace(vehicle_);
    multibody_->SetParameters(vehicle_.ParameterValues(), model_.preloads);
  }

  DamperDraw draw_{7, static_cast<std::uint64_t>(GetParam())};
  Drawn drawn_ = DrawDamper(GetParam(), draw_, kStiffest);
  Vehicle vehicle_;
  CondensedModel model_;
  std::optional<Multibody> multibody_;
};

TEST_P(DamperEngines, AnswerASteppedSineAlike) {
  const Excitation excitation{.frequency_Hz = {1.6, 9}, .amplitude_m = {0.008, 0.0018}, .shape = {1}};
  const SteadyResponse answer = SteadySolver(vehicle_).Solve(excitation, Engine::kAuto);
  const MarchedResponse marched = March(*multibody_, excitation, {.accuracy = 1e-7, .tolerance = 1e-4});
  // What either leaves: tolerances of 1e-4 a window, and kinks between samples.
  constexpr double kAlike = 3e-3;
  for (std::size_t c = 0; c < marched.response.channels.size(); ++c)
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
      const std::complex<double> expected = marched.response.channels[c].response[i];
      EXPECT_LT(std::abs(answer.response.channels[c].response[i] - expected), kAlike * std::abs(expected))
          << drawn_.row << ' ' << marched.response.channels[c].name << ' ' << excitation.frequency_Hz[i];
    }
}

TEST_P(DamperEngines, AnswerAHistoryAlike) {
  const PostMotion motion = [](double t, std::span<PostState> posts) {
    const double w = 2 * std::numbers::pi * 1.3;
    // Begins at rest, with a cube.
    const double share = t < 1 ? t * t * t : 1;
    const double share_rate = t < 1 ? 3 * t * t : 0;
    const double share_bend = t < 1 ? 6 * t : 0;
    const double z = 0.015 * std::sin(w * t);
    const double v = 0.015 * w * std::cos(w * t);
    for (PostState& post : posts)
      post = {share * z, share_rate * z + share * v, share_bend * z + 2 * share_rate * v - share * w * w * z};
  };
  constexpr TimeGrid kGrid{.end_s = 2.5, .rate_Hz = 500};
  const SolvedHistory answer = HistorySolver(vehicle_).Solve(motion, kGrid, {});
  MultibodySystem system(*multibody_, 1e-7);
  const TimeHistory exact = Simulate(system, motion, kGrid);
  ASSERT_TRUE(answer.by.change);
  // The error asked for.
  EXPECT_LT(LargestDifferenceOf(answer.history, exact, vehicle_.sensors).share, 1e-3) << drawn_.row;
}

INSTANTIATE_TEST_SUITE_P(Random, DamperEngines, testing::Range(0, kDampers));

}  // namespace
}  // namespace fourpost::damper_engines_test
