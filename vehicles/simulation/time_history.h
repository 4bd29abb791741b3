#pragma once

#include <functional>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// When a history is sampled: at start + k / rate while that is not beyond `end`. The vehicle rests in its design pose
/// until `lead` before the start.
struct TimeGrid {
  double start_s = 0;
  double end_s = 0;
  double rate_Hz = 0;
  double lead_s = 0;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
  /// Of the samples from start to end.
  Eigen::Index count() const;
  /// Of those before, so many that the lead is in them.
  Eigen::Index lead_count() const;
};

/// Samples of posts and sensors at a fixed rate.
struct TimeHistory {
  /// Time of the first sample.
  double start_s = 0;
  double rate_Hz = 0;
  /// Samples x posts: height [m].
  Eigen::MatrixXd posts;
  /// Samples x sensors.
  Eigen::MatrixXd readings;

  Eigen::Index size() const { return readings.rows(); }
  double TimeAt(Eigen::Index k) const { return start_s + static_cast<double>(k) / rate_Hz; }

  /// Takes so many samples away at the start.
  void DropFirst(Eigen::Index count);
};

/// Hears the time now and then; false ends the history there.
using GoOn = std::function<bool(double t)>;

/// Runs a vehicle from rest and samples it, the lead included. The samples up to then where `go_on` ends it.
/// Throws std::invalid_argument for a grid that is out of bounds, std::runtime_error when the motion cannot be
/// computed.
TimeHistory Simulate(TimeSystem& system, const PostMotion& posts, const TimeGrid& grid, const GoOn& go_on = {});

/// Root mean square difference of each sensor of two histories, as a share of its root mean square in the second; of
/// that of a tenth of the loudest sensor of its unit where that is more, or of a tenth of a unit per metre of what the
/// post that moves most does.
Eigen::ArrayXd RelativeDifferences(const TimeHistory& history, const TimeHistory& reference,
                                   const std::vector<Sensor>& sensors);

struct CondensedHistoryOptions {
  /// Halves the step until that changes no sensor by more than this, see RelativeDifferences(). The error left is about
  /// a third.
  double error = 1e-3;
  /// The first step; one of the grid where that is shorter [s].
  double longest_step_s = 2e-3;
  /// Gives up after so many halvings.
  int most_halvings = 7;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

struct CondensedHistory {
  TimeHistory history;
  /// The step it came to [s].
  double step_s = 0;
  /// By how much the last halving changed the sensor that it changed most; more than the error asked for where halving
  /// did not help, infinite where there are no two steps to compare.
  double change = 0;
  /// Ended from outside: the last whole history, with its step and change; without one what there is of the first.
  bool ended = false;
};

/// Runs a history by steps none longer than this; hears whether to go on.
using HistoryRun = std::function<TimeHistory(double longest_step_s, const GoOn& go_on)>;

/// A history to a stated error, by halving its step. Throws as `run` does, where that is so at the shortest step as
/// well.
CondensedHistory SimulateByHalving(const HistoryRun& run, const std::vector<Sensor>& sensors, const TimeGrid& grid,
                                   const CondensedHistoryOptions& options = {}, const GoOn& go_on = {});

/// The history of a condensed or closed-form model to a stated error. Throws as Simulate() does, where that is so at
/// the shortest step as well.
CondensedHistory SimulateCondensed(const CondensedModel& model, const RigView& rig, const PostMotion& posts,
                                   const TimeGrid& grid, const CondensedHistoryOptions& options = {},
                                   const GoOn& go_on = {});

}  // namespace fourpost
