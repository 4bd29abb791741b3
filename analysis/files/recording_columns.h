#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "analysis/files/recording/recording_file.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A recording as a table: a column "time" in s and one a channel, all of one length. The times are those of the
/// fastest channels; slower ones are interpolated there, by cubic splines where their samples are even, else by
/// straight lines, within the time that all channels cover. Without any times in the file the channels are the columns.
/// Columns are read when they are asked for, and the last one is kept.
class RecordingColumns {
 public:
  /// `name`: of the file. Reports channels that are interpolated, and those without times where others have some.
  RecordingColumns(std::shared_ptr<const RecordingFile> file, std::string name, Diagnostics& diagnostics);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }
  std::size_t rows(std::size_t column) const;
  /// Valid until another column is asked for. Throws FaultyInput where the file is faulty there.
  const std::vector<double>& Column(std::size_t column) const;
  /// As the file has it, before interpolation.
  std::vector<double> Recorded(std::size_t column) const;
  /// Of its own; 0 of the times and where it is not known.
  double rate_Hz(std::size_t column) const;
  bool HasSeveralRates() const { return has_several_rates_; }
  /// Without its samples; nullptr of the times.
  const RecordingChannel* channel(std::size_t column) const {
    return IsTimes(column) ? nullptr : &header().channels[channels_[column]];
  }
  const Recording& header() const { return file_->header(); }

 private:
  struct Clock {
    /// A channel that has it.
    std::size_t channel = 0;
    double start_s = 0;
    double end_s = 0;
    double step_s = 0;
    std::size_t samples = 0;
    /// Of its own; empty of an even one.
    std::vector<double> times_s;
  };

  void ReadClocks(Diagnostics& diagnostics);
  std::size_t ClockOf(std::size_t channel);
  void ChooseTimes(Diagnostics& diagnostics);
  void ReportRates(Diagnostics& diagnostics) const;
  std::vector<double> OnTimes(std::size_t column) const;
  bool IsTimes(std::size_t column) const { return has_times_ && column == 0; }

  std::shared_ptr<const RecordingFile> file_;
  std::string name_;
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  /// Of the file, by column; of the times 0.
  std::vector<std::size_t> channels_;
  std::vector<Clock> clocks_;
  /// By column.
  std::vector<std::size_t> clock_of_;
  bool has_times_ = false;
  bool has_several_rates_ = false;
  std::vector<double> times_s_;
  mutable std::size_t held_;
  mutable std::vector<double> values_;
};

}  // namespace fourpost
