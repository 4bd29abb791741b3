#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/run_contents.h"
#include "identify/study_file/result_reader.h"
#include "identify/uncertainty/parameter_state.h"

namespace fourpost {

/// A parameter of a run, in the unit that its vehicle file writes.
struct ReportedParameter {
  std::string name;
  std::string unit;
  double value = 0;
  /// NaN where the run does not hold it.
  double start = 0;
  double lower = 0;
  double upper = 0;
  ParameterState state = ParameterState::kNotComputed;
  /// Standard deviation; infinite where nothing determines it, NaN of those at a bound and of noise.
  double sd = 0;
  /// Interval of the run's confidence; NaN and infinite like `sd`.
  double lower_95 = 0;
  double upper_95 = 0;
  bool at_bound = false;
  /// What most of the deviation comes from: "noise", "model: struts", "held: k"; empty of runs of older versions.
  std::string limited_by;
  /// By how much `sd` would be smaller if held parameters and calibrations were known; NaN of runs of older versions.
  double held_factor = 0;
  /// By how much the interval would be narrower by noise alone; NaN of runs of older versions.
  double noise_factor = 0;
  /// Whether anything was found out of its deviation, such as that it has none.
  bool IsJudged() const { return state != ParameterState::kNotComputed || !std::isnan(sd); }
  std::string_view CutAt() const { return IntervalCutAt(lower_95, upper_95, lower, upper); }
  /// "lower" or "upper", of one at its bound.
  std::string BoundName() const { return value - lower < upper - value ? "lower" : "upper"; }
  /// The other parameter that it is most correlated with; empty where that is not known.
  std::string partner;
  double correlation = 0;

  double RelativeSd() const { return fourpost::RelativeSd(sd, value, lower, upper); }
};

/// As the vehicle file writes the unit of this entry of `parameters`; in SI where there is none.
std::string UnitOf(const nlohmann::json& parameter, const RunContents& run);

/// result.json of a run. Throws FaultyInput where it is none of `fourpost fit`, naming what it is instead.
nlohmann::json FitResultOf(const RunContents& run);

/// Throws FaultyInput about a result.json in which something is of another kind than fits write.
[[noreturn]] void RefuseResult(const std::string& file, const nlohmann::json::exception& fault);

std::vector<ReportedParameter> ReportedParameters(const nlohmann::json& result, const RunContents& run);

/// Names of those in this state.
std::vector<std::string> NamesIn(ParameterState state, const std::vector<ReportedParameter>& parameters);

/// Why no parameter has a standard deviation, `stated` by an experiment or not; empty where one has, or where there is
/// none.
std::string WhyNoDeviations(const std::vector<ReportedParameter>& parameters, const std::string& stated);

}  // namespace fourpost
