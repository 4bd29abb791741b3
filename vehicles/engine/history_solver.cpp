#include "vehicles/engine/history_solver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/text/found.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/engine/findings.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/full_system.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// What a motion is compared at: enough for the 30 Hz of a rig [Hz].
constexpr double kComparedRate_Hz = 250;
/// The longest step over which forces that linear kinematics leave out go straight [s].
constexpr double kLongestStep_s = 4e-3;

constexpr int kMostHalvings = 3;
constexpr const char* kReducedWork = "reduced model";
constexpr const char* kFullWork = "full geometry";
constexpr const char* kMultibodyWork = "multibody system";

TimeHistory EveryOf(const TimeHistory& history, Index stride) {
  TimeHistory some{.start_s = history.start_s, .rate_Hz = history.rate_Hz / static_cast<double>(stride)};
  const auto rows = Eigen::seq(0, history.size() - 1, stride);
  some.posts = history.posts(rows, Eigen::all);
  some.readings = history.readings(rows, Eigen::all);
  return some;
}

/// The same grid, which begins where the lead does.
TimeGrid WholeGrid(const TimeHistory& history) {
  return {.start_s = history.start_s, .end_s = history.TimeAt(history.size() - 1), .rate_Hz = history.rate_Hz};
}

SolvedHistory Taken(CondensedHistory answer, Engine engine) {
  SolvedHistory out{
      .history = std::move(answer.history), .by = {.engine = engine, .step_s = answer.step_s}, .ended = answer.ended};
  if (std::isfinite(answer.change)) out.by.change = answer.change;
  return out;
}

}  // namespace

HistoryDifference LargestDifferenceOf(const TimeHistory& history, const TimeHistory& reference,
                                      const std::vector<Sensor>& sensors, std::size_t compared) {
  const auto count = static_cast<Index>(std::min(compared, sensors.size()));
  if (count == 0) return {};
  Index at = 0;
  const double share = RelativeDifferences(history, reference, sensors).head(count).maxCoeff(&at);
  return {.share = share, .channel = share == 0 ? "" : sensors[static_cast<std::size_t>(at)].name};
}

int HistorySolver::MostRuns(std::string_view work) {
  // One for the error of linear kinematics, but by the reduced model; the multibody system's accuracy has two values.
  if (work == kReducedWork) return CondensedHistoryOptions().most_halvings + 1;
  return 1 + (work == kFullWork ? kMostHalvings + 1 : 2);
}

HistorySolver::HistorySolver(const Vehicle& vehicle) : HistorySolver(vehicle, vehicle.ParameterValues()) {}

HistorySolver::HistorySolver(const Vehicle& vehicle, std::vector<double> values)
    : vehicle_(vehicle), values_(std::move(values)), rig_(RigViewOf(vehicle)) {
  model_ = CondensedVehicle(vehicle).At(values_);
}

Multibody& HistorySolver::FullSystemAtValues() {
  if (!multibody_) {
    multibody_.emplace(vehicle_);
    multibody_->SetParameters(values_, model_.preloads);
  }
  return *multibody_;
}

SolvedHistory HistorySolver::Reduced(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                                     const Progress& progress) {
  const auto go_on = [&](double t) { return !progress || progress(kReducedWork, t); };
  CondensedHistory answer =
      SimulateCondensed(model_, rig_, posts, grid, {.error = options.error, .released = options.released}, go_on);
  return Taken(std::move(answer), Engine::kReduced);
}

/// `step_s`: of the condensed model within the steps of the full one, at first.
SolvedHistory HistorySolver::Full(const PostMotion& posts, const TimeGrid& grid, const Options& options, double step_s,
                                  const Progress& progress) {
  const auto go_on = [&](double t) { return !progress || progress(kFullWork, t); };
  const double share = std::min(1.0, step_s / std::min(1 / grid.rate_Hz, kLongestStep_s));
  const HistoryRun run = [&](double longest_step, const GoOn& goes_on) {
    FullSystem system(FullSystemAtValues(), model_,
                      {.longest_s = longest_step, .longest_part_s = share * longest_step});
    system.StartFrom(options.released);
    return Simulate(system, posts, grid, goes_on);
  };
  try {
    CondensedHistory answer = SimulateByHalving(
        run, rig_.sensors, grid,
        {.error = options.error, .longest_step_s = kLongestStep_s, .most_halvings = kMostHalvings}, go_on);
    if (!std::isfinite(answer.change) && !answer.ended) throw SimulationError(kOneStepOnly);
    return Taken(std::move(answer), Engine::kFull);
  } catch (const std::runtime_error&) {
    return Integrated(posts, grid, options, progress);
  }
}

SolvedHistory HistorySolver::Integrated(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                                        const Progress& progress) {
  const auto run = [&](double accuracy) {
    MultibodySystem system(FullSystemAtValues(), accuracy);
    system.StartFrom(options.released);
    return Simulate(system, posts, grid, [&](double t) { return !progress || progress(kMultibodyWork, t); });
  };
  const Index whole = grid.lead_count() + grid.count();
  // Simbody weighs states by about 1 m, posts move by millimetres.
  SolvedHistory out{.by = {.engine = Engine::kFull}};
  const TimeHistory rough = run(1e-2 * options.error);
  out.history = rough.size() < whole ? rough : run(1e-3 * options.error);
  out.ended = out.history.size() < whole;
  if (!out.ended) out.by.change = LargestDifferenceOf(rough, out.history, rig_.sensors).share;
  return out;
}

void HistorySolver::Estimate(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                             const Progress& progress, SolvedHistory& reduced) {
  const auto stride = std::max(Index{1}, static_cast<Index>(std::floor(grid.rate_Hz / kComparedRate_Hz)));
  const TimeHistory linear = EveryOf(reduced.history, stride);
  const auto compare = [&](TimeSystem& system, const char* work) {
    system.StartFrom(options.released);
    const TimeHistory full =
        Simulate(system, posts, WholeGrid(linear), [&](double t) { return !progress || progress(work, t); });
    reduced.ended = full.size() < linear.size();
    if (reduced.ended) reduced.by.not_estimated = Found{&kInterrupted}.Text();
    else reduced.by.kinematics_error = LargestDifferenceOf(linear, full, rig_.sensors, options.compared);
  };
  try {
    FullSystem full(FullSystemAtValues(), model_, {.longest_s = kLongestStep_s, .longest_part_s = *reduced.by.step_s});
    compare(full, kFullWork);
    return;
  } catch (const std::runtime_error&) {
    // Simbody's own integrator may find the motion that steps of milliseconds do not.
  }
  try {
    MultibodySystem full(FullSystemAtValues(), 1e-5);
    compare(full, kMultibodyWork);
  } catch (const std::runtime_error& fault) {
    reduced.by.not_estimated = fault.what();
  }
}

SolvedHistory HistorySolver::Solve(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                                   const Progress& progress) {
  if (options.engine == Engine::kTimeIntegration)
    throw std::invalid_argument("HistorySolver: engine time is for steady responses; take full");
  if (options.engine == Engine::kFull)
    return Full(posts, grid, options, 0.25 * std::min(1 / grid.rate_Hz, kLongestStep_s), progress);
  SolvedHistory reduced = Reduced(posts, grid, options, progress);
  if (options.engine == Engine::kReduced || reduced.ended) return reduced;
  Estimate(posts, grid, options, progress, reduced);
  if (reduced.ended || !reduced.by.kinematics_error || !(reduced.by.kinematics_error->share > options.visible))
    return reduced;
  SolvedHistory full;
  try {
    full = Full(posts, grid, options, *reduced.by.step_s, progress);
  } catch (const SimulationError& fault) {
    // Simbody's integrator, which finds most motions, starts from rest only.
    if (options.released.size() == 0) throw;
    reduced.by.not_estimated = fault.what();
    return reduced;
  }
  full.by.kinematics_error = full.ended
                                 ? reduced.by.kinematics_error
                                 : LargestDifferenceOf(reduced.history, full.history, rig_.sensors, options.compared);
  return full;
}

}  // namespace fourpost
