#include "identify/study_file/strict_yaml.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "analysis/text/nearest.h"
#include "analysis/text/unit_spelling.h"
#include "identify/study_file/findings.h"

namespace fourpost {

int LineOf(const YAML::Node& node) { return node.Mark().is_null() ? 0 : node.Mark().line + 1; }

std::string SuggestLegal(std::string_view word, std::span<const std::string_view> legal) {
  std::string nearest = DidYouMean(word, legal);
  if (!nearest.empty()) return nearest;
  std::string all;
  for (const std::string_view name : legal) all += (all.empty() ? "; known: " : ", ") + std::string(name);
  return all;
}

StrictMap::StrictMap(const YAML::Node& node, std::string where, const std::vector<std::string_view>& keys,
                     std::string file, Diagnostics& diagnostics)
    : node_(node), where_(std::move(where)), file_(std::move(file)), diagnostics_(diagnostics), line_(LineOf(node)) {
  if (!node_.IsMap()) {
    Fault(node_, kKeysMissing, {where_});
    return;
  }
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) {
      Fault(entry.first, kKeyNotWord, {where_});
      continue;
    }
    const std::string key = entry.first.Scalar();
    if (!seen.insert(key).second) Fault(entry.first, kKeyTwice, {key, where_});
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      Fault(entry.first, kKeyUnknown, {key, where_, SuggestLegal(key, keys)});
  }
}

bool StrictMap::Has(std::string_view key) const { return Get(key).IsDefined(); }

YAML::Node StrictMap::Get(std::string_view key) const {
  if (!node_.IsMap()) return YAML::Node(YAML::NodeType::Undefined);
  return node_[std::string(key)];
}

int StrictMap::LineOfKey(std::string_view key) const {
  if (node_.IsMap())
    for (const auto& entry : node_)
      if (entry.first.IsScalar() && entry.first.Scalar() == key) return LineOf(entry.first);
  return line_;
}

YAML::Node StrictMap::Require(std::string_view key) const {
  const YAML::Node value = Get(key);
  if (!value.IsDefined() && node_.IsMap()) Fault(node_, kKeyMissing, {where_, std::string(key)});
  return value;
}

std::optional<std::string> StrictMap::Text(std::string_view key) const {
  const YAML::Node value = Get(key);
  if (!value.IsDefined()) return std::nullopt;
  if (value.IsScalar() && !value.Scalar().empty()) return value.Scalar();
  FaultOf(key, kKeyNotText);
  return std::nullopt;
}

std::optional<double> StrictMap::Number(std::string_view key, double lower, double upper) const {
  const YAML::Node value = Get(key);
  if (!value.IsDefined()) return std::nullopt;
  double number = 0;
  if (value.IsScalar()) {
    const std::string& text = value.Scalar();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size() && number >= lower && number <= upper) return number;
  }
  FaultOf(key, kKeyNotNumber, {FormatQuantity(lower, ""), FormatQuantity(upper, "")});
  return std::nullopt;
}

std::optional<long> StrictMap::Integer(std::string_view key, long lower, long upper) const {
  const YAML::Node value = Get(key);
  if (!value.IsDefined()) return std::nullopt;
  long number = 0;
  if (value.IsScalar()) {
    const std::string& text = value.Scalar();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size() && number >= lower && number <= upper) return number;
  }
  FaultOf(key, kKeyNotInteger, {std::to_string(lower), std::to_string(upper)});
  return std::nullopt;
}

std::optional<double> StrictMap::Quantity(std::string_view key, const Dimension& dimension, double lower) const {
  const YAML::Node value = Get(key);
  if (!value.IsDefined()) return std::nullopt;
  const std::optional<double> number = ReadQuantity(value, dimension, NameOf(key), file_, diagnostics_);
  // In SI units, beyond lengths, times, frequencies and shares of any rig.
  constexpr double kMost = 1e12;
  if (!number || (*number >= lower && *number <= kMost)) return number;
  if (*number < lower) FaultOf(key, kKeyTooSmall, {FormatQuantity(lower, SiUnit(dimension))});
  else FaultOf(key, kKeyTooLarge, {FormatQuantity(kMost, SiUnit(dimension))});
  return std::nullopt;
}

StrictMap StrictMap::Map(std::string_view key, const std::vector<std::string_view>& keys) const {
  return {Get(key), "'" + std::string(key) + "'", keys, file_, diagnostics_};
}

StrictMap StrictMap::ReportingTo(Diagnostics& diagnostics) const {
  StrictMap other = *this;
  other.diagnostics_ = diagnostics;
  return other;
}

std::filesystem::path StrictMap::Resolve(const std::string& path) const {
  return (std::filesystem::path(file_).parent_path() / path).lexically_normal();
}

std::string StrictMap::NameOf(std::string_view key) const { return "'" + std::string(key) + "' of " + where_; }

void StrictMap::Fault(const YAML::Node& node, const Finding& finding, const std::vector<std::string>& words) const {
  diagnostics_.get().Report(finding, {file_, node.IsDefined() ? LineOf(node) : line_}, words);
}

void StrictMap::FaultOf(std::string_view key, const Finding& finding, std::vector<std::string> words) const {
  words.insert(words.begin(), NameOf(key));
  Fault(Get(key), finding, words);
}

namespace {

std::string UnitExample(const Dimension& dimension) {
  if (dimension == kDimensionless) return "angle or share such as deg or %";
  return DimensionName(dimension) + " such as " + SiUnit(dimension);
}

}  // namespace

std::optional<double> ReadQuantity(const YAML::Node& node, const Dimension& dimension, const std::string& what,
                                   const std::string& file, Diagnostics& diagnostics) {
  const std::optional<Quantity> quantity = node.IsScalar() ? ParseQuantity(node.Scalar()) : std::nullopt;
  // Angles are pure numbers, but degrees or radians must be written.
  if (quantity && quantity->unit.dimension == dimension && !quantity->unit_text.empty()) return quantity->si;
  diagnostics.Report(
      kKeyNotQuantity, {file, LineOf(node)},
      {what, UnitExample(dimension), node.IsScalar() ? ", got '" + node.Scalar() + "'" + UnitHint(node.Scalar()) : ""});
  return std::nullopt;
}

}  // namespace fourpost
