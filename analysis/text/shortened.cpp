#include "analysis/text/shortened.h"

namespace fourpost {
namespace {

bool IsWithinCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::string Shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t begin = 2 * most / 3;
  std::size_t end = text.size() - (most - begin);
  while (begin > 0 && IsWithinCharacter(text[begin])) --begin;
  while (end < text.size() && IsWithinCharacter(text[end])) ++end;
  return std::string(text.substr(0, begin)) + "[... " + std::to_string(end - begin) + " bytes ...]" +
         std::string(text.substr(end));
}

}  // namespace fourpost
