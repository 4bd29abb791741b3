#include "vehicles/templates/written_xml.h"

#include "analysis/text/utf8.h"

namespace fourpost {
namespace {

/// XML has no control characters but tab and ends of lines.
char Legal(char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c; }

}  // namespace

std::string InAttribute(std::string_view text) {
  std::string written;
  for (const char c : ValidUtf8(text)) {
    if (c == '&') written += "&amp;";
    else if (c == '<') written += "&lt;";
    else if (c == '"') written += "&quot;";
    else written += Legal(c);
  }
  return written;
}

std::string InComment(std::string_view text) {
  std::string written;
  for (const char c : ValidUtf8(text)) {
    if (c == '-' && written.ends_with('-')) written += ' ';
    written += Legal(c);
  }
  return written;
}

}  // namespace fourpost
