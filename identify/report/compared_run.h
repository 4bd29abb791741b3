#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/experiment_report.h"
#include "identify/report/run_result.h"

namespace fourpost {

/// The group of a channel, by which those that differ by their place only, such as a_axle_FL and a_axle_FR, are one
/// group a_axle: its name without `_front`, `_rear`, `_left`, `_right`, or a corner such as `_FL` at the end.
std::string GroupOf(const std::string& channel);

/// A run to compare with others.
struct ComparedRun {
  /// Its study without the ending; with the folder where runs share it.
  std::string name;
  std::string folder;
  RunContents contents;
  nlohmann::json result;
  std::vector<ReportedParameter> parameters;
  /// Mean normalised mean square errors [%].
  std::map<ChannelGroup, double> fitted;
  std::map<ChannelGroup, double> predicted;
  /// Likewise of each fitted recording over the run's band, all its channels together, of experiments that judge
  /// theirs so; none of older versions.
  std::map<ChannelGroup, double> recordings;
  /// Runs of the same number were fitted to the same data, weighed alike, see FittedData: their costs can be compared.
  std::size_t data = 0;

  /// Names of its experiments, joined by commas: "stepped sines, static loads".
  std::string kind;

  RunFolder Folder() const { return {folder, contents, result}; }
  /// For messages: with its folder.
  std::string FileNamed(const std::string& file) const { return Folder().FileNamed(file); }
  /// Recordings that were fitted, joined by commas.
  std::string Recordings() const;
};

/// From the folders and what they hold, of which result.json must be that of a fit. Throws
/// FaultyInput, with the folder, for one that is not understood.
std::vector<ComparedRun> ComparedRuns(std::vector<std::pair<std::string, RunContents>> folders,
                                      ExperimentReports experiments);

/// Groups that every run has an error of.
std::vector<ChannelGroup> CommonGroups(const std::vector<ComparedRun>& runs,
                                       std::map<ChannelGroup, double> ComparedRun::*errors);

}  // namespace fourpost
