#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Whether `item` is of `kind` and its message names each of `words`: values and names, not wording.
inline bool Is(const Diagnostic& item, const Finding& kind, const std::vector<std::string>& words) {
  return item.id == kind.id() && std::all_of(words.begin(), words.end(), [&](const std::string& word) {
           return item.message.find(word) != std::string::npos;
         });
}

/// Of Diagnostics: one of them is of this kind, at this line, and names each of `words`.
inline auto Reports(const Finding& kind, int line, std::vector<std::string> words = {}) {
  return testing::ResultOf(
      "finding " + std::string(kind.id()) + " at line " + std::to_string(line),
      [&kind, line, words](const Diagnostics& diagnostics) {
        const auto& items = diagnostics.items();
        return std::any_of(items.begin(), items.end(), [&](const Diagnostic& item) {
          return item.place.line == line && item.place.option.empty() && Is(item, kind, words);
        });
      },
      testing::IsTrue());
}

/// Of Diagnostics: one of them, at any line of a file, is of this kind and names each of `words`.
inline auto Reports(const Finding& kind, std::vector<std::string> words = {}) {
  return testing::ResultOf(
      "finding " + std::string(kind.id()),
      [&kind, words](const Diagnostics& diagnostics) {
        const auto& items = diagnostics.items();
        return std::any_of(items.begin(), items.end(), [&](const Diagnostic& item) { return Is(item, kind, words); });
      },
      testing::IsTrue());
}

/// Of Diagnostics: there is one, of this kind, at this line.
inline auto ReportsOnly(const Finding& kind, int line, std::vector<std::string> words = {}) {
  return testing::AllOf(testing::Property("items", &Diagnostics::items, testing::SizeIs(1)),
                        Reports(kind, line, std::move(words)));
}

/// Of one finding: it is of this kind and names each of `words`.
inline auto IsFinding(const Finding& kind, std::vector<std::string> words = {}) {
  return testing::ResultOf(
      "finding " + std::string(kind.id()), [&kind, words](const Diagnostic& item) { return Is(item, kind, words); },
      testing::IsTrue());
}

/// Of Diagnostics: one of them is of this kind, about this option.
inline auto ReportsOption(const Finding& kind, std::string option, std::vector<std::string> words = {}) {
  return testing::ResultOf(
      "finding " + std::string(kind.id()) + " about " + option,
      [&kind, option, words](const Diagnostics& diagnostics) {
        const auto& items = diagnostics.items();
        return std::any_of(items.begin(), items.end(), [&](const Diagnostic& item) {
          return item.place.option == option && Is(item, kind, words);
        });
      },
      testing::IsTrue());
}

/// Of something to call: it throws FaultyInput with a finding of this kind at this line.
inline auto Refuses(const Finding& kind, int line, std::vector<std::string> words = {}) {
  return testing::Throws<FaultyInput>(
      testing::Property(&FaultyInput::diagnostics, Reports(kind, line, std::move(words))));
}

/// Of something to call: it throws FaultyInput with a finding of this kind about this option.
inline auto Refuses(const Finding& kind, const char* option, std::vector<std::string> words = {}) {
  return testing::Throws<FaultyInput>(
      testing::Property(&FaultyInput::diagnostics, ReportsOption(kind, option, std::move(words))));
}

/// Printed by GoogleTest where an expectation fails.
inline void PrintTo(const Diagnostic& item, std::ostream* out) { *out << Format(item); }
inline void PrintTo(const Diagnostics& diagnostics, std::ostream* out) { *out << '\n' << diagnostics.Format(); }

}  // namespace fourpost
