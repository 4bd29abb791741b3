#pragma once

#include "analysis/files/recorded_table.h"

namespace fourpost {

// What a table holds, by the names of its columns.

/// A row per frequency and channel, see ReadFrequencyResponse().
bool IsSteppedSine(const RecordedTable& table);

/// A column of times, and no stepped sine.
bool IsTimeHistory(const RecordedTable& table);

}  // namespace fourpost
