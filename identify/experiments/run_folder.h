#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/run_contents.h"

namespace fourpost {

/// The folder of a fit as a report reads it.
struct RunFolder {
  /// Empty where files are known by their names alone.
  std::string folder;
  const RunContents& contents;
  /// result.json.
  const nlohmann::json& result;

  /// Null where there is none.
  const std::string* Find(const std::string& file) const;
  /// For messages: with the folder.
  std::string FileNamed(const std::string& file) const;
};

/// Names of the recordings that were fitted, sorted.
std::vector<std::string> FittedRecordings(const nlohmann::json& result);

}  // namespace fourpost
