#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/fit/fit.h"
#include "identify/run/fit_verdict.h"
#include "identify/run/growth_summary.h"

namespace fourpost {

/// A study to fit, and the folder of the results.
struct FitRequest {
  std::filesystem::path study;
  std::filesystem::path output;
  /// Values of parameters to start from and to hold, "k=20kN/m", in place of those of the study.
  std::vector<std::string> set = {};
  /// In place of the study's.
  std::optional<std::uint64_t> seed = {};
  /// 0: one per processor.
  int threads = 0;
  /// Refuse to start anew.
  bool resume = false;
  /// Fit although the data leave combinations of parameters open.
  bool accept_unidentified = false;
  /// Fit although posts of a recording move otherwise than the study states.
  bool accept_implausible = false;
  /// Refine from the values of the vehicle's file alone, without a search.
  bool from_file = false;
  /// Names of parameters to profile, or "all".
  std::vector<std::string> profile = {};
  /// Look for what the vehicle lacks where residuals are larger than noise and stated model error explain.
  bool name_missing = false;
  /// Where this fit is the last one of a growth.
  std::optional<GrowthSummary> growth = {};
  /// By name, SI: what results call the start of a parameter in place of the file's value, as where a growth began.
  std::map<std::string, double> starts = {};
  /// Leave the results of before where the user stops it.
  bool only_whole = false;
};

/// How a fit shows that it gets on; each may be empty.
struct FitRunHooks {
  WorkHooks work = {};
  /// Warnings as they are found.
  std::function<void(const Diagnostics& findings)> find = {};
  /// Called when inputs are good and the search is about to begin.
  std::function<void()> begin = {};
  /// Of the search and each refinement.
  std::function<FitHooks(const FitOptions& options)> fit = {};
};

struct FitRun {
  FitResult fit;
  FitVerdict verdict;
  /// False of a fit that ended before it had any result.
  bool is_written = false;
  /// Tables for a terminal, and what result.json holds.
  std::string text = {};
  std::string json = {};
};

/// Fits a study and writes the folder of the results: result.json, report.html, vehicle.urdf, the archive of all
/// evaluations, and what its experiments add. The same request goes on from the archive of one that was interrupted.
/// Throws FaultyInput for files and options that cannot be used, OutputError for a folder that cannot be written.
FitRun FitStudy(const FitRequest& request, const FitRunHooks& hooks = {});

}  // namespace fourpost
