#include "analysis/files/mat/mat_variable.h"

#include <limits>

#include "analysis/files/mat/findings.h"

namespace fourpost {

std::uint64_t MatVariable::Length() const {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t length = dims.empty() ? 0 : 1;
  for (const std::uint64_t side : dims) {
    if (side == 0) return 0;
    length = length > kMost / side ? kMost : length * side;
  }
  return length;
}

void RequireLength(const MatVariable& variable, std::uint64_t held, const std::string& what) {
  if (held == variable.Length()) return;
  throw MatFault(kMatLength, {variable.name, std::to_string(held), what, std::to_string(variable.Length())});
}

std::vector<std::string> RowsOf(const std::vector<std::string>& characters, std::uint64_t rows) {
  if (characters.empty()) return {};
  std::vector<std::string> texts(rows);
  for (std::size_t i = 0; i < characters.size(); ++i) texts[i % rows] += characters[i];
  return texts;
}

std::string Utf8(std::uint32_t code) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(bits); };
  const auto next = [&](int shift) { return byte(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), next(0)};
  if (code >= 0xD800 && code < 0xE000) return "?";
  if (code < 0x10000) return {byte(0xE0 | code >> 12), next(6), next(0)};
  if (code < 0x110000) return {byte(0xF0 | code >> 18), next(12), next(6), next(0)};
  return "?";
}

}  // namespace fourpost
