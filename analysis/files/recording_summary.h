#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "analysis/files/rest_search.h"
#include "analysis/signals/sensor_noise.h"

namespace fourpost {

/// What a column of a recording looks like, in its own unit and at its own rate.
struct ColumnSummary {
  std::string name;
  /// As written; empty where the file has none.
  std::string unit;
  /// Whether ParseRecordedUnit knows it.
  bool unit_known = false;
  std::size_t samples = 0;
  /// Of its own, of a recording of a measurement system; else 0.
  double rate_Hz = 0;
  /// Samples without a finite number; the first of them.
  std::size_t missing = 0;
  std::size_t first_missing = 0;
  /// Samples that a logger held, see HeldStretches(), and the first of them.
  std::size_t held = 0;
  std::size_t first_held = 0;
  /// Of the others; 0 without any. `rms` is that about the mean.
  double minimum = 0;
  double maximum = 0;
  double mean = 0;
  double rms = 0;
  /// See LevelOf.
  double level = 0;
  /// See IsDead; false where no other column moves.
  bool is_dead = false;
  /// See ClippedAtTop and ClippedAtBottom; 0 below kFewestClipped in all.
  std::size_t clipped_top = 0;
  std::size_t clipped_bottom = 0;
  /// By which its straight line rises over the record; of one with releases by its slope at rest, see DriftAtRest().
  double drift = 0;
  /// Of each release by how much it stood above its rest before; 0 within its noise, or without a rest before.
  std::vector<double> above_rest = {};
  /// What of it is beside the channel's motion, see SlowDrift(); nothing where the vehicle may have moved so: of a
  /// displacement where another one drifts as well, none does not, or its name may be a post's, and of a force or an
  /// acceleration where any displacement does.
  std::optional<double> slow_drift = {};
  /// At RecordingSummary::rest; nothing without it, and of fewer than 64 samples there.
  std::optional<SensorNoise> noise = {};
};

/// Times that are further apart than the usual step, or step back.
struct TimeGap {
  /// 0 of a MAT file.
  int line = 0;
  double from_s = 0;
  double to_s = 0;
};

/// The samples' times.
struct TimeSummary {
  std::string column;
  double start_s = 0;
  double end_s = 0;
  /// Of the usual step.
  double rate_Hz = 0;
  std::vector<TimeGap> gaps;
  /// The largest difference from even steps between first and last sample, in steps; of a record without gaps.
  double unevenness = 0;
  /// Root mean square of the steps that are no gaps about the usual one, as a share of it; of a record without gaps
  /// only beyond what rounding of the times explains.
  double jitter = 0;
  /// Neither by name nor by unit: the column rises evenly, and no other does.
  bool is_guessed = false;
};

/// A vehicle that is let go, see ReleasesOf(); times of the record.
struct RecordedRelease {
  /// From where on it rests before; `let_go_s` where the record begins in motion.
  double rest_from_s = 0;
  double let_go_s = 0;
  /// At rest again, and until when.
  double rest_s = 0;
  double end_s = 0;
};

struct RecordingSummary {
  /// Nothing without a column of times, or where they do not rise.
  std::optional<TimeSummary> time;
  /// All columns but that of the times.
  std::vector<ColumnSummary> columns;
  /// When nothing moves, without a gap, from the begin of the record.
  std::optional<RestTime> rest = {};
  /// By all displacements, accelerations and forces.
  std::vector<RecordedRelease> releases = {};
};

/// The column of the samples' times; empty where there is none.
std::string TimesColumn(const RecordedTable& table);

/// Looks at all columns. Times are a column of kTimeColumn's names, else the first in a unit of time, else the only one
/// without a unit that rises evenly.
/// `units`: what is stated in place of the units that the columns have, one each or empty; none: nothing is.
RecordingSummary Summarise(const RecordedTable& table, std::span<const std::string> units = {});

}  // namespace fourpost
