#pragma once

#include <functional>
#include <string>

namespace fourpost {

/// How long work shows that it gets on, and how it is stopped; each may be empty.
struct WorkHooks {
  /// One line, which the next one replaces.
  std::function<void(const std::string& text)> show = {};
  /// True asks the work to end with what it has.
  std::function<bool()> stop = {};
  /// A line that stays.
  std::function<void(const std::string& text)> note = {};

  void Show(const std::string& text) const {
    if (show) show(text);
  }
  bool IsStopped() const { return stop && stop(); }
  void Note(const std::string& text) const {
    if (note) note(text);
  }
};

}  // namespace fourpost
