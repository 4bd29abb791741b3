#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "identify/draft/file_reading.h"

namespace fourpost {

/// The section `bench` of a drafted study.
class BenchDraft {
 public:
  explicit BenchDraft(std::vector<std::string> dampers) : dampers_(std::move(dampers)) {}

  /// `path`: as the study names it; `times`: see TimesLines().
  void Add(const FileReading& reading, const std::string& path, const std::string& times);

  /// Empty without recordings.
  std::string Text() const;

 private:
  /// Displacement and force, as a study has them.
  using Columns = std::array<std::string, 2>;

  static Columns ColumnsOf(const FileReading& reading);
  /// For columns that are called otherwise than `others`.
  static std::string LinesOf(const Columns& own, const Columns& others, const std::string& indent);

  /// Names of the vehicle's.
  std::vector<std::string> dampers_;
  /// Of the first recording, which the others share.
  Columns shared_;
  std::string recordings_;
};

}  // namespace fourpost
