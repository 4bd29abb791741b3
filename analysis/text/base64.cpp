#include "analysis/text/base64.h"

namespace fourpost {

std::string Base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  unsigned bits = 0;
  int held = 0;
  for (const char byte : bytes)
    for (bits = bits << 8 | static_cast<unsigned char>(byte), held += 8; held >= 6; held -= 6)
      text += kDigits[bits >> (held - 6) & 63u];
  if (held > 0) text += kDigits[bits << (6 - held) & 63u];
  while (text.size() % 4 != 0) text += '=';
  return text;
}

}  // namespace fourpost
