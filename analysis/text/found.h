#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A finding with its words, of one who does not know its place.
struct Found {
  /// nullptr: nothing is wrong.
  const Finding* kind = nullptr;
  std::vector<std::string> words = {};

  explicit operator bool() const { return kind != nullptr; }
  /// "text: remedy [id]".
  std::string Text() const { return kind->Message(words) + " [" + std::string(kind->id()) + "]"; }
};

/// "text: remedy" of Found::Text(), to stand within another finding; other texts as they are.
inline std::string WithoutId(const std::string& text) {
  const std::size_t id = text.rfind(" [");
  return text.ends_with(']') && id != std::string::npos ? text.substr(0, id) : text;
}

}  // namespace fourpost
