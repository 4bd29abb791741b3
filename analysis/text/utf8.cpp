#include "analysis/text/utf8.h"

namespace fourpost {
namespace {

unsigned ByteAt(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

/// Of the character that begins here; 0 where none does.
std::size_t LengthOfCharacter(std::string_view text, std::size_t at) {
  const unsigned first = ByteAt(text, at);
  if (first < 0x80) return 1;
  // The second byte keeps long forms of short characters, surrogates and what is beyond Unicode out.
  unsigned lower = 0x80;
  unsigned upper = 0xBF;
  std::size_t length = 0;
  if (first >= 0xC2 && first <= 0xDF) length = 2;
  else if (first >= 0xE0 && first <= 0xEF) length = 3;
  else if (first >= 0xF0 && first <= 0xF4) length = 4;
  if (first == 0xE0) lower = 0xA0;
  if (first == 0xED) upper = 0x9F;
  if (first == 0xF0) lower = 0x90;
  if (first == 0xF4) upper = 0x8F;
  for (std::size_t i = 1; i < length; ++i, lower = 0x80, upper = 0xBF)
    if (ByteAt(text, at + i) < lower || ByteAt(text, at + i) > upper) return 0;
  return length;
}

}  // namespace

std::string ValidUtf8(std::string_view text) {
  std::string valid;
  valid.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = LengthOfCharacter(text, at);
    if (length > 0) valid += text.substr(at, length);
    else valid += "\uFFFD";
    at += length > 0 ? length : 1;
  }
  return valid;
}

std::string Utf8OfEither(std::string_view text) {
  bool is_utf8 = true;
  for (std::size_t at = 0; is_utf8 && at < text.size();) {
    const std::size_t length = LengthOfCharacter(text, at);
    is_utf8 = length > 0;
    at += length;
  }
  if (is_utf8) return std::string(text);
  std::string converted;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80) {
      converted += letter;
    } else {
      converted += static_cast<char>(0xC0 | (byte >> 6));
      converted += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return converted;
}

}  // namespace fourpost
