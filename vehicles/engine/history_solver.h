#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/engine/engine.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// By how much two histories differ in the channel that differs most, as RelativeDifferences() has it.
struct HistoryDifference {
  double share = 0;
  /// The sensor's name; empty where there is no difference.
  std::string channel;

  bool IsVisible() const { return share > kVisibleShare; }
};

/// Of the first sensors, `compared` at most.
HistoryDifference LargestDifferenceOf(const TimeHistory& history, const TimeHistory& reference,
                                      const std::vector<Sensor>& sensors,
                                      std::size_t compared = static_cast<std::size_t>(-1));

/// The engine that answered, and what is known of its error.
struct HistoryEngine {
  /// kReduced or kFull.
  Engine engine = Engine::kReduced;
  /// Of the integration [s]; empty: that of Simbody's integrator, where FullSystem found no motion.
  std::optional<double> step_s;
  /// By how much the last halving of the step changed the channel that it changed most, of the integrator a tenfold
  /// accuracy, see RelativeDifferences(); empty where there are no two to compare.
  std::optional<double> change;
  /// By how much linear kinematics are off, if that was asked for; and why it is not known.
  std::optional<HistoryDifference> kinematics_error;
  std::string not_estimated;
  /// Of a fit that corrects the reduced model by the full one: what the correction would still change.
  std::optional<double> correction_change;
};

struct SolvedHistory {
  /// The lead included.
  TimeHistory history;
  HistoryEngine by;
  /// Ended from outside, with what there is: see CondensedHistory::ended. Where the check was ended, the reduced
  /// model's whole history without one.
  bool ended = false;
};

/// A vehicle, at given values, that answers histories by any engine.
class HistorySolver {
 public:
  struct Options {
    Engine engine = Engine::kAuto;
    /// Allowed to the integration, of each channel's rms, see RelativeDifferences(). By halving; the error left is
    /// about a third.
    double error = 1e-3;
    /// So many sensors, the first ones, count in what linear kinematics are off by; the others only go along.
    std::size_t compared = static_cast<std::size_t>(-1);
    /// Of kAuto: the full geometry answers where linear kinematics are off by more than this share of a channel's rms.
    double visible = kVisibleShare;
  };

  /// Hears what is run ("reduced model", "full geometry", "multibody system") and the time it is at; false ends it.
  using Progress = std::function<bool(const char* work, double t)>;

  /// The vehicle must outlive this object. Throws FaultyInput when it cannot be assembled or held in its design pose.
  explicit HistorySolver(const Vehicle& vehicle);
  HistorySolver(const Vehicle& vehicle, std::vector<double> values);

  const CondensedModel& model() const { return model_; }

  /// Throws std::invalid_argument for options or a grid that are out of bounds or for kMarch, SimulationError when
  /// the motion cannot be computed.
  SolvedHistory Solve(const PostMotion& posts, const TimeGrid& grid, const Options& options,
                      const Progress& progress = {});

 private:
  Multibody& FullSystemAtValues();
  SolvedHistory Reduced(const PostMotion& posts, const TimeGrid& grid, double error, const Progress& progress);
  SolvedHistory Full(const PostMotion& posts, const TimeGrid& grid, double error, double step_s,
                     const Progress& progress);
  SolvedHistory Integrated(const PostMotion& posts, const TimeGrid& grid, double error, const Progress& progress);
  /// Adds the kinematics error of a reduced answer.
  void Estimate(const PostMotion& posts, const TimeGrid& grid, std::size_t compared, const Progress& progress,
                SolvedHistory& reduced);

  const Vehicle& vehicle_;
  std::vector<double> values_;
  CondensedModel model_;
  RigView rig_;
  std::optional<Multibody> multibody_;
};

}  // namespace fourpost
