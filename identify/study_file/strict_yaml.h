#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "analysis/text/diagnostics.h"
#include "analysis/text/units.h"

namespace fourpost {

/// A YAML mapping in which every key must be expected and may stand once; yaml-cpp itself accepts any key any number of
/// times. Faults go to the diagnostics with file and line.
class StrictMap {
 public:
  /// Reports a fault when `node` is not a mapping, when a key stands twice, or when it is not among `keys`.
  StrictMap(const YAML::Node& node, std::string where, const std::vector<std::string_view>& keys, std::string file,
            Diagnostics& diagnostics);

  bool Has(std::string_view key) const;
  /// Undefined node when the key is missing.
  YAML::Node Get(std::string_view key) const;
  /// As Get, with a fault when the key is missing.
  YAML::Node Require(std::string_view key) const;

  std::optional<std::string> Text(std::string_view key) const;
  /// A finite number without unit within [lower, upper].
  std::optional<double> Number(std::string_view key, double lower, double upper) const;
  std::optional<long> Integer(std::string_view key, long lower, long upper) const;
  /// A number with a unit of this dimension, in SI, at least `lower` and at most what any rig has.
  std::optional<double> Quantity(std::string_view key, const Dimension& dimension, double lower) const;

  /// The mapping under a key, which is there.
  StrictMap Map(std::string_view key, const std::vector<std::string_view>& keys) const;
  /// The same, its faults to be reported elsewhere.
  StrictMap ReportingTo(Diagnostics& diagnostics) const;
  /// Of the study: a file that it names, against the study's folder.
  std::filesystem::path Resolve(const std::string& path) const;
  const std::string& file() const { return file_; }
  Diagnostics& diagnostics() const { return diagnostics_; }

  /// At the line of the node.
  void Fault(const YAML::Node& node, const Finding& finding, const std::vector<std::string>& words = {}) const;
  /// At the line of a key; the first word is "'key' of 'map'".
  void FaultOf(std::string_view key, const Finding& finding, std::vector<std::string> words = {}) const;
  /// Line of the mapping itself.
  int line() const { return line_; }
  /// Line on which a key stands, above the entries of its block; that of the mapping without it.
  int LineOfKey(std::string_view key) const;

 private:
  /// "'key' of 'map'"
  std::string NameOf(std::string_view key) const;

  YAML::Node node_;
  std::string where_;
  std::string file_;
  std::reference_wrapper<Diagnostics> diagnostics_;
  int line_ = 0;
};

/// To end a message about an unknown word with: ", did you mean ...?", or all known ones when none is near.
std::string SuggestLegal(std::string_view word, std::span<const std::string_view> legal);

/// 1-based line of a node.
int LineOf(const YAML::Node& node);

/// A quantity of this dimension; a fault and nothing when it is not one.
std::optional<double> ReadQuantity(const YAML::Node& node, const Dimension& dimension, const std::string& what,
                                   const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
