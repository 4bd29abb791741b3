#include "analysis/files/universal/universal_number.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool IsSign(char c) { return c == '+' || c == '-'; }

std::size_t SkipDigits(std::string_view text, std::size_t at) {
  while (at < text.size() && IsDigit(text[at])) ++at;
  return at;
}

}  // namespace

std::optional<double> TakeUniversalNumber(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t,"), text.size()));
  std::size_t at = !text.empty() && IsSign(text[0]) ? 1 : 0;
  at = SkipDigits(text, at);
  if (at < text.size() && text[at] == '.') at = SkipDigits(text, at + 1);
  std::string number(text.substr(0, at));
  if (at < text.size() && std::string_view("EeDd").find(text[at]) != std::string_view::npos) {
    const std::size_t sign = at + 1 < text.size() && IsSign(text[at + 1]) ? at + 2 : at + 1;
    const std::size_t end = SkipDigits(text, sign);
    number += "e" + std::string(text.substr(at + 1, end - at - 1));
    at = end;
  } else if (at + 3 < text.size() && IsSign(text[at]) && SkipDigits(text, at + 1) == at + 4) {
    // An exponent of three digits pushes the E out.
    number += "e" + std::string(text.substr(at, 4));
    at += 4;
  }
  const std::optional<double> value = ParseNumber(number);
  if (value) text.remove_prefix(at);
  return value;
}

std::optional<double> UniversalField(std::string_view field) {
  if (field.find_first_not_of(' ') == std::string_view::npos) return 0;
  const std::optional<double> number = TakeUniversalNumber(field);
  return field.find_first_not_of(' ') == std::string_view::npos ? number : std::nullopt;
}

}  // namespace fourpost
