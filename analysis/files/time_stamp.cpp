#include "analysis/files/time_stamp.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <string>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr double kDay_s = 86400;

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Takes so many digits at most; nothing without one.
std::optional<int> TakeDigits(std::string_view& text, std::size_t most) {
  std::size_t count = 0;
  int number = 0;
  for (; count < std::min(most, text.size()) && IsDigit(text[count]); ++count)
    number = 10 * number + (text[count] - '0');
  text.remove_prefix(count);
  return count == 0 ? std::nullopt : std::optional(number);
}

bool TakeOne(std::string_view& text, std::string_view of) {
  if (text.empty() || of.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// Three numbers with one of "-/." between them, and what parts them from the time.
std::optional<std::int64_t> TakeDay(std::string_view& text) {
  std::array<int, 3> parts{};
  char separator = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<int> part = TakeDigits(text, 4);
    if (!part) return std::nullopt;
    parts[i] = *part;
    if (i == 2) break;
    if (text.empty() || std::string_view("-/.").find(text[0]) == std::string_view::npos) return std::nullopt;
    if (i == 1 && text[0] != separator) return std::nullopt;
    separator = text[0];
    text.remove_prefix(1);
  }
  if (!TakeOne(text, " T_")) return std::nullopt;
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  int year = parts[0];
  int month = parts[1];
  int day = parts[2];
  if (year <= 31) {
    const bool is_month_first = separator == '/' && parts[0] <= 12;
    month = is_month_first ? parts[0] : parts[1];
    day = is_month_first ? parts[1] : parts[0];
    year = parts[2];
  }
  const std::chrono::year_month_day date(std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

/// "12:09", "8:09:00.5 PM".
std::optional<double> TakeSeconds(std::string_view& text) {
  const std::optional<int> hour = TakeDigits(text, 2);
  if (!hour || *hour > 24 || !TakeOne(text, ":")) return std::nullopt;
  const std::optional<int> minute = TakeDigits(text, 2);
  if (!minute || *minute > 59) return std::nullopt;
  double second = 0;
  if (TakeOne(text, ":")) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.,"), text.size());
    std::string number(text.substr(0, end));
    std::replace(number.begin(), number.end(), ',', '.');
    const std::optional<double> seconds = ParseNumber(number);
    if (!seconds || *seconds >= 61) return std::nullopt;
    second = *seconds;
    text.remove_prefix(end);
  }
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  int hours = *hour;
  if (text.size() >= 2 && (text[1] == 'M' || text[1] == 'm') && TakeOne(text, "AaPp")) {
    // What was taken stands before.
    const char half = *(text.data() - 1);
    hours = hours % 12 + (half == 'P' || half == 'p' ? 12 : 0);
    text.remove_prefix(1);
  }
  return 3600.0 * hours + 60.0 * *minute + second;
}

/// "Z", "+01:00", or nothing.
bool IsZone(std::string_view text) {
  if (text.empty() || text == "Z") return true;
  return TakeOne(text, "+-") && text.find_first_not_of("0123456789:") == std::string_view::npos;
}

}  // namespace

double TimeStamp::After(const TimeStamp& earlier) const {
  double after = static_cast<double>(day - earlier.day) * kDay_s + (second - earlier.second);
  if (!has_date && after < -0.5 * kDay_s) after += kDay_s;
  return after;
}

std::optional<TimeStamp> ParseTimeStamp(std::string_view text) {
  TimeStamp stamp;
  std::string_view rest = text;
  if (const std::optional<std::int64_t> day = TakeDay(rest)) {
    stamp.day = *day;
    stamp.has_date = true;
  } else {
    rest = text;
  }
  const std::optional<double> second = TakeSeconds(rest);
  if (!second || !IsZone(rest)) return std::nullopt;
  stamp.second = *second;
  return stamp;
}

}  // namespace fourpost
