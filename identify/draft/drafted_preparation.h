#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/files/recording_summary.h"
#include "analysis/files/time_recording.h"
#include "identify/draft/channel_match.h"

namespace fourpost {

/// Longer gaps hold motion that no interpolation knows.
inline constexpr double kLongestBridge_s = 0.05;

/// What a recording over time needs before a fit takes it, and what is known of its channels at rest.
struct DraftedPreparation {
  TimePreparation times;
  /// Why `resample`, `bridge` and `with` stand there; empty where they do not.
  std::string why_resampled;
  std::string why_bridged;
  std::string why_beside;
  RecordingSummary summary;
  /// A `bridge` that goes over every gap, however long, with what rounding of times next to it takes; 0: there is none.
  double over_all_gaps_s = 0;
  /// Of the column of times where the study has to state it; empty: the file does. And whether that is a guess.
  std::string time_unit;
  bool is_time_unit_guessed = false;

  const ColumnSummary* Find(const std::string& channel) const;
};

/// Even times where steps jitter, and bridges over short gaps; of a table without a column of times nothing. `units`:
/// see Summarise().
DraftedPreparation PreparationOf(const RecordedTable& table, std::span<const std::string> units = {});

/// A straight line that outweighs all motion is a sensor's drift.
bool Drifts(const ColumnSummary& column);

/// Takes the drifts of its channels away.
void RemoveDrifts(const DraftedPreparation& preparation, ChannelMatch& match);

/// Of channels that are known there: all of them, each beside the largest of its unit.
bool IsMotionless(const DraftedPreparation& preparation, const ChannelSource& source);

/// Lines `time`, `resample`, `bridge` and `with` of an entry of a study; `others`: files as the study names them.
std::string TimesLines(const DraftedPreparation& preparation, const std::vector<std::string>& others);

/// Lines of `noise` by the names of sensors: what the channels read at rest. Mains hum is said once;
/// other noise that is not white is to be looked at. Empty where nothing is known.
std::string NoiseLines(const DraftedPreparation& preparation, const std::vector<ChannelMatch>& matches);

}  // namespace fourpost
