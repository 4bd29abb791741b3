#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/recorded_motion.h"
#include "identify/experiments/run_folder.h"

namespace fourpost {

/// A section of a report, HTML.
struct ReportSection {
  std::string id;
  std::string title;
  std::string html;
  /// Whether the table of all channels' errors follows, where no section before has it.
  bool has_channels = false;
};

/// What the summary of a report says of an experiment, HTML; empty where there is nothing to say.
struct ReportRemarks {
  /// Whether a force is fitted, which gives masses, rates and damping their scale.
  bool measures_force = false;
  /// Whether an audit had something to compare and suspects no channel.
  bool is_wiring_cleared = false;
  /// What the force looks like that the model lacks in the measured motion, a sentence.
  std::string missing_force;
  /// Why no parameter has a standard deviation, text.
  std::string why_no_deviations;
  /// What to measure next: where parameters are open and no force is fitted, where no misfit is known, and in
  /// any case.
  std::string where_open;
  std::string where_not_weighed;
  std::vector<std::string> further;
  /// The recordings of result.json with the engine that modelled each.
  std::vector<nlohmann::json> modelled;
};

/// Adds what `whole` does not say.
void AddRemarks(ReportRemarks part, ReportRemarks& whole);

/// What the folder of a fit holds of one kind of experiment.
class ExperimentData {
 public:
  virtual ~ExperimentData() = default;
  /// Whether the folder has none of this kind.
  virtual bool empty() const = 0;
  /// Whether a vehicle stands on posts in it.
  virtual bool IsOnPosts() const { return true; }
  /// What the scripts draw, by the keys of analysis/report/README.md; empty lists where there is nothing.
  virtual nlohmann::ordered_json Drawn() const { return nlohmann::ordered_json::object(); }
  virtual std::vector<ReportSection> Sections() const = 0;
  virtual ReportRemarks Remarks() const { return {}; }
  /// How posts and vehicle moved. Throws FaultyInput.
  virtual void AddMotions(const Vehicle&, RecordedMotions&) const {}
};

/// Of several runs the lines that a page draws together.
struct ComparedCurves {
  /// Key of analysis/report/README.md.
  std::string id;
  std::string title;
  nlohmann::ordered_json curves;
};

/// A recording, empty for all that are judged together, and a group of its channels.
using ChannelGroup = std::pair<std::string, std::string>;

/// What reports show of one kind of experiment, from the folders of fits: one object per kind, without a state.
class ExperimentReport {
 public:
  virtual ~ExperimentReport() = default;
  /// "stepped sines"
  virtual std::string_view Name() const = 0;
  /// Texts of a folder that it reads beside result.json.
  virtual std::vector<std::string> Files() const { return {}; }
  /// Whether a fit was of this kind.
  virtual bool IsIn(const RunFolder& run) const = 0;
  /// Throws FaultyInput. The run must outlive it.
  virtual std::unique_ptr<ExperimentData> Read(const RunFolder& run) const = 0;

  /// Whether result.json lists channels of all its recordings together.
  virtual bool JoinsRecordings() const { return false; }
  /// Normalised mean square error [%] of each recording, all its channels together, by its band.
  virtual std::map<ChannelGroup, double> RecordingErrors(const nlohmann::json&) const { return {}; }
  /// What two runs must share, beside recordings, channels and settings of the study, that their costs compare.
  virtual nlohmann::json FittedData(const nlohmann::json&) const { return nullptr; }
  /// Takes from the study, a map, what its residuals do not depend on, such as the places of files.
  virtual void EraseUnseen(nlohmann::json&) const {}
  /// What is measured alike in two runs or more. Throws FaultyInput.
  virtual std::vector<ComparedCurves> Compare(std::span<const RunFolder>) const { return {}; }
};

/// One of each kind, in the order in which reports show them.
using ExperimentReports = std::span<const ExperimentReport* const>;

/// Takes these keys from an object.
void EraseKeys(nlohmann::json& object, std::span<const char* const> keys);
/// Of recordings of a study those that are fitted, without where they lie.
nlohmann::json FittedEntries(const nlohmann::json& recordings);

}  // namespace fourpost
