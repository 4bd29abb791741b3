#pragma once

#include <functional>
#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// How long work shows that it gets on, and how it is stopped; each may be empty.
struct WorkHooks {
  /// One line, which the next one replaces.
  std::function<void(const std::string& text)> show = {};
  /// True asks the work to end with what it has.
  std::function<bool()> stop = {};
  /// A line that stays.
  std::function<void(const std::string& text)> note = {};
  /// What was found so far, before long work that may fail; results carry it as well.
  std::function<void(const Diagnostics& findings)> find = {};

  void Show(const std::string& text) const {
    if (show) show(text);
  }
  bool IsStopped() const { return stop && stop(); }
  void Note(const std::string& text) const {
    if (note) note(text);
  }
  void Find(const Diagnostics& findings) const {
    if (find) find(findings);
  }
};

}  // namespace fourpost
