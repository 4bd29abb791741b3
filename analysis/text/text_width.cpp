#include "analysis/text/text_width.h"

#include <algorithm>

namespace fourpost {
namespace {

constexpr std::string_view kDots = "...";

bool BeginsCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// The first characters, `count` at most.
std::string_view Beginning(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if (BeginsCharacter(text[at]) && count-- == 0) break;
  return text.substr(0, at);
}

}  // namespace

std::size_t Width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), BeginsCharacter));
}

std::string CutToWidth(const std::string& text, std::size_t width) {
  if (Width(text) <= width) return text;
  if (width <= kDots.size()) return std::string(Beginning(text, width));
  std::string_view kept = Beginning(text, width - kDots.size());
  // Half a number is another number.
  const std::size_t blank = kept.rfind(' ');
  if (blank != std::string_view::npos) kept = kept.substr(0, kept.find_last_not_of(" ,;:(", blank) + 1);
  return std::string(kept) + std::string(kDots);
}

}  // namespace fourpost
