#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/engine/engine.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// Difference of two histories in the channel that differs most, see RelativeDifferences().
struct HistoryDifference {
  double share = 0;
  /// The sensor's name; empty where there is no difference.
  std::string channel;

  bool IsVisible() const { return share > kVisibleShare; }
};

/// Of the first sensors, at most `compared` of them.
HistoryDifference LargestDifferenceOf(const TimeHistory& history, const TimeHistory& reference,
                                      const std::vector<Sensor>& sensors,
                                      std::size_t compared = static_cast<std::size_t>(-1));

/// The engine that was used, and what is known of its error.
struct HistoryEngine {
  /// kReduced or kFull.
  Engine engine = Engine::kReduced;
  /// Step of the integration [s]; empty: Simbody's integrator, used where FullSystem found no motion.
  std::optional<double> step_s;
  /// Largest change of a channel from the last halving of the step (of the integrator: from a tenfold accuracy), see
  /// RelativeDifferences(); empty if there are no two to compare.
  std::optional<double> change;
  /// Error of linear kinematics, if requested; and why it is not known.
  std::optional<HistoryDifference> kinematics_error;
  std::string not_estimated;
  /// In a fit that corrects the reduced model by the full one: the remaining change of the correction.
  std::optional<double> correction_change;
};

struct SolvedHistory {
  /// The lead included.
  TimeHistory history;
  HistoryEngine by;
  /// Ended from outside, with the results so far: see CondensedHistory::ended. If the check was ended, the reduced
  /// model's whole history without a check.
  bool ended = false;
};

/// A vehicle, at given values, whose histories any engine can solve.
class HistorySolver {
 public:
  struct Options {
    Engine engine = Engine::kAuto;
    /// Error allowed in the integration, of each channel's rms, see RelativeDifferences(). By halving the step; the
    /// remaining error is about a third.
    double error = 1e-3;
    /// Number of sensors, the first ones, that count in the error of linear kinematics.
    std::size_t compared = static_cast<std::size_t>(-1);
    /// For kAuto: the full geometry is used if linear kinematics are off by more than this share of a channel's rms.
    double visible = kVisibleShare;
    /// See TimeSystem::StartFrom(); empty: from rest.
    Eigen::VectorXd released = {};
  };

  /// Called with the work ("reduced model", "full geometry", "multibody system") and its time; false ends it.
  using Progress = std::function<bool(const char* work, double t)>;
  /// Runs over the grid that one work takes at most: each halves the step until two agree.
  static int MostRuns(std::string_view work);

  /// The vehicle must outlive this object. Throws FaultyInput if it cannot be assembled or held in its design pose.
  explicit HistorySolver(const Vehicle& vehicle);
  HistorySolver(const Vehicle& vehicle, std::vector<double> values);

  const CondensedModel& model() const { return model_; }

  /// Throws std::invalid_argument for options or a grid that are out of bounds or for kTimeIntegration, SimulationError
  /// if the motion cannot be computed.
  SolvedHistory Solve(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                      const Progress& progress = {});

 private:
  Multibody& FullSystemAtValues();
  SolvedHistory Reduced(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                        const Progress& progress);
  SolvedHistory Full(const PostMotion& posts, const TimeGrid& grid, const Options& options, double step_s,
                     const Progress& progress);
  SolvedHistory Integrated(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                           const Progress& progress);
  /// Adds the kinematics error of a reduced result.
  void Estimate(const PostMotion& posts, const TimeGrid& grid, const Options& options, const Progress& progress,
                SolvedHistory& reduced);

  const Vehicle& vehicle_;
  std::vector<double> values_;
  CondensedModel model_;
  RigView rig_;
  std::optional<Multibody> multibody_;
};

}  // namespace fourpost
