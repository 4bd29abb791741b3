#pragma once

#include <optional>

#include "analysis/files/recorded_table.h"
#include "identify/draft/file_reading.h"

namespace fourpost {

/// Of a recording, in seconds.
struct GaplessStretch {
  double from_s = 0;
  double to_s = 0;
};

/// The longest stretch of a reading's channels and posts without a gap above kLongestBridge_s; nothing where there is
/// no such gap, or they cannot be read with it.
std::optional<GaplessStretch> LongestGapless(const RecordedTable& table, const FileReading& reading);

}  // namespace fourpost
