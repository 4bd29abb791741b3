#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fourpost {

/// A time of day, perhaps of a date.
struct TimeStamp {
  /// Since 1970-01-01; 0 without a date.
  std::int64_t day = 0;
  bool has_date = false;
  double second = 0;

  /// Seconds after an earlier one. A time of day before that of the earlier one by half a day is of the next day.
  double After(const TimeStamp& earlier) const;
};

/// "2025-11-14 20:09:00.563811", "2025-11-14T20:09:00Z", "11/14/2025 8:09:00.56 PM", "14.11.2025 20:09:00,56",
/// "20:09:00.5". Of dates with slashes the month is first, unless it is above 12. Zones are not counted: those of a
/// recording do not change. Nothing for other text.
std::optional<TimeStamp> ParseTimeStamp(std::string_view text);

}  // namespace fourpost
