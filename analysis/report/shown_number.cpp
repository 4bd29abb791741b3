#include "analysis/report/shown_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace fourpost {
namespace {

/// Decimal exponent of the leading digit.
int Exponent(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

/// Of five digits and more before the point.
std::string WithThousandsApart(std::string text) {
  const std::size_t first = text[0] == '-' ? 1 : 0;
  const std::size_t point = std::min(text.find('.'), text.size());
  if (point - first > 4)
    for (std::size_t i = point; i > first + 3; i -= 3) text.insert(i - 3, "\u2009");
  if (first == 1) text.replace(0, 1, "\u2212");
  return text;
}

}  // namespace

std::string ShownDecimals(double value, int decimals) {
  if (!std::isfinite(value)) return std::isnan(value) ? "\u2013" : value > 0 ? "\u221e" : "\u2212\u221e";
  char text[400];
  // No "-0".
  std::snprintf(text, sizeof text, "%.*f", std::clamp(decimals, 0, 30), value + 0.0);
  return WithThousandsApart(text);
}

std::string ShownNumber(double value, int digits) {
  if (!std::isfinite(value) || value == 0) return ShownDecimals(value, 0);
  const int exponent = Exponent(value);
  if (exponent >= -4 && exponent < 7) return ShownDecimals(value, std::max(0, digits - 1 - exponent));
  char text[64];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
  const std::string written = text;
  const std::size_t e = written.find('e');
  const int power = std::stoi(written.substr(e + 1));
  return WithThousandsApart(written.substr(0, e)) + "\u00b710" + ShownUnit("^" + std::to_string(power));
}

std::string ShownShort(double value, int digits) {
  std::string text = ShownNumber(value, digits);
  if (text.find('.') == std::string::npos || text.find("\u00b710") != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string ShownUnit(const std::string& unit) {
  constexpr std::array<const char*, 10> kRaised = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                   "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text;
  bool is_power = false;
  for (const char c : unit) {
    if (c == '^') is_power = true;
    else if (c == '*') text += "\u00b7";
    else if (is_power && c == '-') text += "\u207b";
    else if (is_power && c >= '0' && c <= '9') text += kRaised[static_cast<std::size_t>(c - '0')];
    else text += c;
    is_power = is_power && (c == '^' || c == '-' || (c >= '0' && c <= '9'));
  }
  return text;
}

html::Cell SdCell(double sd, int decimals) {
  if (std::isnan(sd)) return {"\u2013", "n pm"};
  return {"\u00b1\u2009" + (std::isinf(sd) ? std::string("open") : ShownDecimals(sd, decimals)), "n pm"};
}

int DecimalsFor(double value, double sd) {
  if (std::isfinite(sd) && sd > 0) return std::clamp(1 - Exponent(sd), 0, 12);
  if (value == 0 || !std::isfinite(value)) return 0;
  return std::clamp(3 - Exponent(value), 0, 12);
}

}  // namespace fourpost
