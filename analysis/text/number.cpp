#include "analysis/text/number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace fourpost {
namespace {

/// std::from_chars on the whole text.
template <typename Value>
std::optional<Value> FromChars(std::string_view text) {
  Value value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<double> FiniteFromChars(std::string_view text) {
  const std::optional<double> value = FromChars<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// std::from_chars does not take the plus sign that people write.
std::string_view WithoutPlus(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  return text;
}

/// The same number with a larger exponent, as text; nothing when the exponent does not fit an int.
std::optional<std::string> ShiftExponent(std::string_view text, int power_of_ten) {
  const std::size_t e = text.find_first_of("eE");
  int exponent = 0;
  if (e != std::string_view::npos) {
    const std::optional<int> written = FromChars<int>(WithoutPlus(text.substr(e + 1)));
    // Far beyond any double, and far from overflow.
    if (!written || std::abs(*written) > 100000) return std::nullopt;
    exponent = *written;
  }
  return std::string(text.substr(0, e)) + "e" + std::to_string(exponent + power_of_ten);
}

/// A positive number d1.d2d3... times ten to the exponent.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

/// The shortest decimal that reads back to the value, which must be positive.
Decimal ShortestDecimal(double value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  Decimal decimal;
  const std::size_t e = text.find('e');
  decimal.exponent = FromChars<int>(WithoutPlus(text.substr(e + 1))).value();
  decimal.digits = text.substr(0, 1);
  if (e > 2) decimal.digits += text.substr(2, e - 2);
  return decimal;
}

/// 0.00123
std::string LayOutSmall(const std::string& digits, int exponent) {
  return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
}

/// 123, 12.3, 12300
std::string LayOutLarge(std::string digits, int exponent) {
  const auto before_point = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= before_point) return digits + std::string(before_point - digits.size(), '0');
  return digits.insert(before_point, ".");
}

/// 1.23e-9
std::string LayOutScientific(std::string digits, int exponent) {
  if (digits.size() > 1) digits.insert(1, ".");
  return digits + "e" + std::to_string(exponent);
}

}  // namespace

std::optional<double> ParseNumber(std::string_view text, int power_of_ten) {
  text = WithoutPlus(text);
  if (power_of_ten == 0) return FiniteFromChars(text);
  const std::optional<std::string> shifted = ShiftExponent(text, power_of_ten);
  return shifted ? FiniteFromChars(*shifted) : std::nullopt;
}

std::string FormatNumber(double value, int power_of_ten) {
  if (std::isnan(value)) return "nan";
  const std::string sign = std::signbit(value) ? "-" : "";
  if (std::isinf(value)) return sign + "inf";
  if (value == 0) return sign + "0";
  const Decimal decimal = ShortestDecimal(std::abs(value));
  const int exponent = decimal.exponent + power_of_ten;
  // Plain digits as long as a person can take them in.
  if (exponent < -5 || exponent > 11) return sign + LayOutScientific(decimal.digits, exponent);
  if (exponent < 0) return sign + LayOutSmall(decimal.digits, exponent);
  return sign + LayOutLarge(decimal.digits, exponent);
}

}  // namespace fourpost
