#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fourpost/diagnostics.h>
#include <fourpost/study.h>

namespace fourpost::api {

/// A fitted parameter; SI. NaN where there is no standard deviation, see `state`.
struct FittedParameter {
  std::string name;
  std::string unit;
  double start = 0;
  double value = 0;
  double sd = 0;
  /// Ends of the interval, whatever its confidence: 95 %, or 80 to 90 % where the run says so.
  double lower_95 = 0;
  double upper_95 = 0;
  /// "determined", "undetermined", "at_bound", ..., as in result.json (docs/reference.md).
  std::string state;
  bool is_at_bound = false;
};

/// What a fit has found.
struct Result {
  /// "converged", "not_converged", "interrupted".
  std::string termination;
  bool is_converged() const { return termination == "converged"; }
  /// False where the model is no explanation of the data.
  bool explains_data = false;
  /// Sum of squared residuals over their deviations, and their number.
  double cost = 0;
  int residuals = 0;
  std::vector<FittedParameter> parameters;
  std::vector<Finding> warnings;
  /// With report.html, the fitted vehicle.urdf, result.json and curves.
  std::filesystem::path folder;

  /// Throws Error (code `name-unknown`).
  const FittedParameter& At(const std::string& parameter) const;
};

/// Reads the folder of a fit. Throws Error.
Result ReadResult(const std::filesystem::path& folder);

/// How far a fit is.
struct FitProgress {
  /// "search", "refine", "fit: predictions and the report", ...
  std::string stage;
  /// New evaluations so far, and those of them that failed.
  std::int64_t evaluations = 0;
  std::int64_t failed = 0;
  /// Lowest so far, by the loss of the refinement; infinite before the first.
  double best_cost = 0;
};

struct FitOptions {
  /// In place of the study's.
  std::optional<std::uint64_t> seed = {};
  /// 0: one per processor. No influence on the result.
  int threads = 0;
  /// Go on from the archive of an interrupted fit; refuse to start anew.
  bool resume = false;
  /// Fit although the data leave combinations of parameters open, or contradict the study.
  bool accept_unidentified = false;
  bool accept_implausible = false;
  /// True ends the fit with what it has; asked often, from the calling thread.
  std::function<bool()> stop = {};
  /// Warnings as they are found.
  std::function<void(const Finding& finding)> warn = {};
  /// Called by one thread at a time, but not always by the same.
  std::function<void(const FitProgress& progress)> progress = {};
};

/// Fits a study by dvHDE and Ceres and writes the folder of its results, which must be new, empty or that of an earlier
/// fit; a study from arrays is written to `inputs` in it. Throws Error; a fit that was stopped before it had any result
/// is one of kSimulation.
Result Fit(const Study& study, const std::filesystem::path& folder, const FitOptions& options = {});

}  // namespace fourpost::api
