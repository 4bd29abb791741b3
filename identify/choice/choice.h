#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/choice/metric.h"
#include "identify/choice/setting_table.h"
#include "identify/choice/settings_file.h"
#include "identify/decision/decision.h"
#include "identify/decision/value_of_information.h"

namespace fourpost {

/// A car whose settings are to be chosen, and what is known of it.
struct ChoiceRequest {
  SettingsFile settings;
  /// Those that the objectives and limits of `settings` refer to.
  std::vector<Metric> metrics;
  /// For all settings: power spectra with statistical linearisation.
  MetricsOf spectra;
  /// For a few: the reduced model over time, and the multibody system; empty: not compared.
  MetricsOf histories = {};
  MetricsOf full = {};
  /// SI, order of Vehicle::parameters.
  std::vector<double> fitted;
  /// Possible cars, a row each; without rows nothing is known of the doubt.
  Eigen::MatrixXd draws;
  /// Parameters of bench fits in the same possible cars, whose laws are in Knob::Position::drawn; empty: none.
  Eigen::MatrixXd bench_draws = {};
  /// Names of the columns of both.
  std::vector<std::string> parameters;
  /// 0: one per processor; without influence on the result.
  int threads = 0;
};

/// A setting with what it is worth. Changes are against the present setting of the same possible car, as shares.
struct RatedSetting {
  Setting setting;
  /// Why it has no answer; empty: all below holds.
  std::string failure;
  /// Mean of each objective over the draws, SI, and its change.
  std::vector<double> objectives;
  std::vector<DrawSummary> changes;
  /// Of the objectives together.
  DrawSummary change;
  /// Of all admitted settings: see Decision.
  double best_probability = 0;
  double regret = 0;
  /// Of the change minus that of the best setting.
  DrawSummary beside_best;
  /// Share of draws that meet each limit, and all.
  std::vector<double> limits_met;
  double all_met = 1;
  /// It meets the limits with the certainty that is asked for.
  bool is_admitted = false;
  bool is_indistinct = false;
  bool is_on_front = false;
};

/// One click of one knob away from the best setting.
struct ClickLoss {
  std::size_t knob = 0;
  /// The larger change of the two neighbours, as a share; NaN where there is none with an answer.
  double loss = 0;
  /// Whether a neighbour does not meet the limits.
  bool leaves_limits = false;
};

/// The change of an objective against the present setting by one engine beside that by the spectra, at the fitted
/// values.
struct EngineCheck {
  enum class Engine { kHistories, kFull };
  Engine engine = Engine::kHistories;
  /// Row of Choice::rows, and objective; empty: of all together.
  std::size_t row = 0;
  std::optional<std::size_t> objective;
  double by_spectra = 0;
  double by_engine = 0;

  double Difference() const { return by_engine - by_spectra; }
};

struct Choice {
  /// Of those with draws: in the order of the lattice, or of a search.
  std::vector<RatedSetting> rows;
  std::size_t present = 0;
  /// Empty: no setting is admitted, and nothing is chosen.
  std::optional<std::size_t> best;
  std::size_t rival = 0;
  /// Settings on the lattice; those evaluated at the fitted values, and whether a search chose them.
  std::int64_t lattice = 0;
  std::int64_t evaluated = 0;
  bool was_searched = false;
  /// Rows of the front of two objectives, by the first one.
  std::vector<std::size_t> front;
  std::vector<ClickLoss> clicks;
  /// See DecidingParameters(); `parameter` is an index in ChoiceRequest::parameters.
  std::vector<DecidingParameter> deciding;
  /// `setting` is a row.
  std::vector<InformativeRun> runs;
  std::vector<EngineCheck> checks;
  Diagnostics findings;
  bool is_interrupted = false;

  std::size_t IndistinctCount() const;
  /// Of settings that were compared by time histories.
  std::size_t ComparedCount() const;
};

/// Rates the settings and chooses one. Findings name the file of settings. Throws FaultyInput where the present setting
/// has no answer.
Choice Choose(const ChoiceRequest& request, const WorkHooks& hooks);

}  // namespace fourpost
