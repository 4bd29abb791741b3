#pragma once

#include <optional>
#include <string>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/time_recording.h"
#include "identify/study_file/channel_source.h"

namespace fourpost {

/// What a study says of a channel, as its reader takes it.
inline RecordedChannel AsRecorded(const SourceChannel& channel, const Dimension& dimension, const std::string& what) {
  return {.names = {channel.name},
          .dimension = dimension,
          .what = what,
          .unit = channel.unit,
          .factor = channel.factor,
          .delay_s = channel.delay_s,
          .offset = ParseRecordedQuantity(channel.offset),
          .has_trend = channel.has_trend,
          .high_pass_Hz = channel.high_pass_Hz,
          .integrated_above_Hz = channel.integrated_above_Hz};
}

/// The usual one where a study names none.
inline RecordedChannel TimeColumn(const std::optional<SourceChannel>& time) {
  return time ? AsRecorded(*time, kTime, kTimeColumn.what) : kTimeColumn;
}

}  // namespace fourpost
