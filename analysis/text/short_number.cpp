#include "analysis/text/short_number.h"

#include <array>
#include <charconv>
#include <cmath>

#include "analysis/text/number.h"
#include "analysis/text/option_check.h"

namespace fourpost {

double AtDigits(double value, int digits) {
  RequireOption(digits >= 1 && digits <= 17, "digits", digits, "1 to 17");
  if (value == 0 || !std::isfinite(value)) return value;
  std::array<char, 32> text;
  char* const begin = text.data();
  const auto written = std::to_chars(begin, begin + text.size(), value, std::chars_format::scientific, digits - 1);
  double rounded = value;
  std::from_chars(begin, written.ptr, rounded);
  return rounded;
}

std::string ShortNumber(double value, int digits) {
  return !std::isfinite(value) ? "unknown" : FormatNumber(AtDigits(value, digits));
}

}  // namespace fourpost
