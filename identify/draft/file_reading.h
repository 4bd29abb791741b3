#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/measured_response/stated_unit.h"
#include "analysis/signals/frequency_response.h"
#include "identify/draft/channel_match.h"
#include "identify/draft/draft_statements.h"
#include "identify/draft/drafted_preparation.h"
#include "identify/study_file/channel_source.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Responses to one motion of the posts.
struct DraftedMotion {
  FrequencyResponse response;
  /// Of each post of the vehicle; empty where nothing says how they moved.
  std::vector<double> shape;
};

/// A file as a draft of a study sees it.
struct FileReading {
  enum class Kind { kSines, kDwells, kHistory, kLoads, kBench, kUnread };

  std::filesystem::path path;
  Kind kind = Kind::kUnread;
  /// Of what is not read: why.
  std::string reason = {};
  /// Time histories: the name of each post, and its channels.
  std::vector<ChannelMatch> posts = {};
  /// Names of all of a table.
  std::vector<std::string> columns = {};
  /// Without times and posts, in known units.
  std::vector<OfferedChannel> channels = {};
  /// Those of other columns of numbers: the name, and what stands in place of a unit.
  std::vector<std::pair<std::string, std::string>> unread = {};
  /// What is stated in place of the units that the file has.
  std::vector<StatedUnit> units = {};
  std::vector<DraftedMotion> motions = {};
  /// Of a recording over time without motions: why there are none.
  std::string not_compared = {};
  /// What of the record is left out.
  std::vector<std::string> missed = {};
  /// Of what is over time.
  DraftedPreparation preparation = {};
  /// Over time, and of a vehicle with posts, but without theirs: perhaps recorded beside another file.
  bool is_without_posts = false;
  /// Of a file that lacks a post: a channel that is nearly called as one, and that name; empty: none.
  std::pair<std::string, std::string> misspelt_post = {};
  /// Histories whose posts rest: what drives the vehicle's actuators; or it is let go and comes to rest.
  std::vector<ChannelMatch> actuators = {};
  bool is_release = false;
  /// Of a bench: the force acts along the motion.
  bool has_force_reversed = false;
};

/// Reads a file as far as a draft needs it. Adds no findings: what keeps it from being used is the reason.
/// `beside`: files that were recorded at the same time, which it is read with.
FileReading ReadForDraft(const std::filesystem::path& file, const Vehicle& vehicle, const DraftStatements& stated,
                         const std::vector<std::filesystem::path>& beside = {});

/// Of channels whose units are stated, the study states them too.
void StateUnits(const std::vector<StatedUnit>& units, ChannelSource& source);

/// The first channel of a dimension; without a name: there is none.
SourceChannel BenchChannel(const FileReading& reading, const Dimension& dimension);

/// "heave" and the like of a shape that the vehicle's posts make so, up to its sign.
std::optional<std::string> PatternOfShape(const Vehicle& vehicle, const std::vector<double>& shape);

}  // namespace fourpost
