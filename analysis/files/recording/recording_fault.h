#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/found.h"

namespace fourpost {

/// Why a recording is not read. Its words name the place, a byte or a record; text files have a line.
class RecordingFault : public std::exception {
 public:
  explicit RecordingFault(const Finding& kind, std::vector<std::string> words = {}, int line = 0)
      : found_{&kind, std::move(words)}, line_(line) {}
  explicit RecordingFault(Found found, int line = 0) : found_(std::move(found)), line_(line) {}
  const Found& found() const { return found_; }
  /// 0: none.
  int line() const { return line_; }
  const char* what() const noexcept override { return found_.kind->id().data(); }

 private:
  Found found_;
  int line_;
};

}  // namespace fourpost
