#pragma once

#include <functional>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// Sampling times of a history: start + k / rate up to `end`. The vehicle rests in its design pose until `lead` before
/// the start.
struct TimeGrid {
  double start_s = 0;
  double end_s = 0;
  double rate_Hz = 0;
  double lead_s = 0;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
  /// Number of samples from start to end.
  Eigen::Index count() const;
  /// Number of samples before, enough to cover the lead.
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

  /// Removes this number of samples at the start.
  void DropFirst(Eigen::Index count);
};

/// Called regularly with the time; false ends the history there.
using GoOn = std::function<bool(double t)>;

/// Runs a vehicle from rest and samples it, the lead included. If `go_on` ends it, the samples up to then. Throws
/// std::invalid_argument for a grid that is out of bounds, std::runtime_error if the motion cannot be computed.
TimeHistory Simulate(TimeSystem& system, const PostMotion& posts, const TimeGrid& grid, const GoOn& go_on = {});

/// Root mean square difference of each sensor between two histories, relative to its root mean square in the second; or
/// relative to a tenth of the loudest sensor of its unit, or a tenth of a unit per metre of motion of the post that
/// moves most, where that is more.
Eigen::ArrayXd RelativeDifferences(const TimeHistory& history, const TimeHistory& reference,
                                   const std::vector<Sensor>& sensors);

struct CondensedHistoryOptions {
  /// Halves the step until no sensor changes by more than this, see RelativeDifferences(). The remaining error is about
  /// a third.
  double error = 1e-3;
  /// The first step; one of the grid if that is shorter [s].
  double longest_step_s = 2e-3;
  /// Limit of halvings.
  int most_halvings = 7;
  /// See TimeSystem::StartFrom(); empty: from rest.
  Eigen::VectorXd released = {};

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

struct CondensedHistory {
  TimeHistory history;
  /// The final step [s].
  double step_s = 0;
  /// Largest change of a sensor by the last halving; more than the requested error if halving did not help, infinite if
  /// there are no two steps to compare.
  double change = 0;
  /// Ended from outside: the last whole history, with its step and change; without one the incomplete first one.
  bool ended = false;
};

/// Runs a history with steps no longer than this; asks whether to go on.
using HistoryRun = std::function<TimeHistory(double longest_step_s, const GoOn& go_on)>;

/// A history to a stated error, by halving its step. Throws as `run` does, if it does so at the shortest step as well.
CondensedHistory SimulateByHalving(const HistoryRun& run, const std::vector<Sensor>& sensors, const TimeGrid& grid,
                                   const CondensedHistoryOptions& options = {}, const GoOn& go_on = {});

/// The history of a reduced or closed-form model to a stated error. Throws as Simulate() does, if it does so at the
/// shortest step as well.
CondensedHistory SimulateCondensed(const CondensedModel& model, const RigView& rig, const PostMotion& posts,
                                   const TimeGrid& grid, const CondensedHistoryOptions& options = {},
                                   const GoOn& go_on = {});

}  // namespace fourpost
