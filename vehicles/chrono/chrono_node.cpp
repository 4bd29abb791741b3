#include "vehicles/chrono/chrono_node.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "analysis/files/text_file.h"
#include "analysis/text/number.h"
#include "vehicles/chrono/findings.h"

namespace fourpost {
namespace {

using nlohmann::json;

/// The largest file of Chrono's cars has 12 kB.
constexpr std::size_t kMost_MiB = 1;
/// No number of a car is larger in SI.
constexpr double kLargest = 1e12;

int LineOfByte(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

/// What the parser says, without the place, which the finding has.
std::string Reason(const std::string& what) {
  const std::size_t at = what.find("syntax error");
  return at == std::string::npos ? "it cannot be read" : what.substr(at);
}

std::optional<ChronoNumber> Search(const json& value, const std::vector<std::string_view>& names, int depth) {
  if (depth > 8) return std::nullopt;
  if (value.is_object())
    for (std::string_view name : names)
      if (const auto found = value.find(name); found != value.end() && found->is_number())
        return ChronoNumber{name, found->get<double>()};
  if (value.is_structured())
    for (const json& below : value)
      if (const std::optional<ChronoNumber> found = Search(below, names, depth + 1)) return found;
  return std::nullopt;
}

}  // namespace

std::optional<ChronoNode> ChronoNode::Read(const std::filesystem::path& path, Diagnostics& diagnostics) {
  std::error_code failure;
  if (std::filesystem::is_regular_file(path, failure) && std::filesystem::file_size(path, failure) > kMost_MiB << 20U) {
    diagnostics.Report(kChronoTooLarge, {path.string()}, {std::to_string(kMost_MiB) + " MiB"});
    return std::nullopt;
  }
  std::optional<std::string> text = ReadTextFile(path, diagnostics);
  if (!text) return std::nullopt;
  auto file = std::make_shared<ChronoFile>(ChronoFile{.path = path, .text = *std::move(text)});
  try {
    file->json = json::parse(file->text, nullptr, true, true);
  } catch (const json::parse_error& error) {
    diagnostics.Report(kChronoNoJson, {path.string(), LineOfByte(file->text, error.byte)}, {Reason(error.what())});
    return std::nullopt;
  } catch (const json::exception&) {
    diagnostics.Report(kChronoNoJson, {path.string()}, {"a number in it is out of range"});
    return std::nullopt;
  }
  const json* const root = &file->json;
  return ChronoNode(std::move(file), root, "", 0, diagnostics);
}

bool ChronoNode::Has(std::string_view name) const { return value_ && value_->is_object() && value_->contains(name); }

std::size_t ChronoNode::PlaceOf(std::string_view name) const {
  const std::string quoted = '"' + std::string(name) + '"';
  for (std::size_t at = file_->text.find(quoted, at_); at != std::string::npos; at = file_->text.find(quoted, at + 1)) {
    const std::size_t colon = file_->text.find_first_not_of(" \t\r\n", at + quoted.size());
    if (colon != std::string::npos && file_->text[colon] == ':') return at;
  }
  return at_;
}

int ChronoNode::LineAt(std::size_t place) const { return LineOfByte(file_->text, place); }

std::string ChronoNode::Called() const {
  return name_.empty() ? '\'' + file_->path.filename().string() + '\'' : '"' + name_ + '"';
}

std::string ChronoNode::Called(std::string_view name) const {
  return '"' + (name_.empty() ? "" : name_ + "/") + std::string(name) + '"';
}

void ChronoNode::Report(const Finding& finding, const std::vector<std::string>& words) const {
  diagnostics_->Report(finding, {file_->path.string(), LineAt(at_)}, words);
}

void ChronoNode::ReportAt(std::string_view name, const Finding& finding, const std::vector<std::string>& words) const {
  diagnostics_->Report(finding, {file_->path.string(), LineAt(PlaceOf(name))}, words);
}

const json* ChronoNode::Needed(std::string_view name, std::string_view what) const {
  if (!value_) return nullptr;
  if (Has(name)) return &value_->at(std::string(name));
  Report(kChronoMissing, {Called(), std::string(name), std::string(what)});
  return nullptr;
}

const json* ChronoNode::NeededList(std::string_view name, std::string_view what, std::size_t most) const {
  const json* found = Needed(name, what);
  if (!found || !found->is_array() || found->size() <= most) return found;
  ReportAt(name, kChronoTooMany, {Called(name), std::to_string(found->size()), std::to_string(most)});
  return nullptr;
}

ChronoNode ChronoNode::Child(std::string_view name) const {
  const std::string called = (name_.empty() ? "" : name_ + "/") + std::string(name);
  const json* found = Needed(name, "an object in braces");
  // Without a search for a place that there is not.
  if (!found) return {file_, nullptr, called, at_, *diagnostics_};
  if (!found->is_object()) {
    ReportAt(name, kChronoValue, {Called(name), "an object in braces"});
    found = nullptr;
  }
  return {file_, found, called, PlaceOf(name), *diagnostics_};
}

std::vector<ChronoNode> ChronoNode::Items(std::string_view name, std::size_t most) const {
  std::vector<ChronoNode> items;
  const json* found = NeededList(name, "a list in brackets", most);
  if (!found) return items;
  if (!found->is_array()) {
    ReportAt(name, kChronoValue, {Called(name), "a list in brackets"});
    return items;
  }
  std::size_t place = PlaceOf(name);
  for (std::size_t i = 0; i < found->size(); ++i) {
    place = std::min(file_->text.find('{', place + 1), file_->text.size());
    const std::string called = (name_.empty() ? "" : name_ + "/") + std::string(name) + " " + std::to_string(i + 1);
    const bool is_object = found->at(i).is_object();
    if (!is_object) ReportAt(name, kChronoValue, {'"' + called + '"', "an object in braces"});
    items.push_back(ChronoNode(file_, is_object ? &found->at(i) : nullptr, called, place, *diagnostics_));
    // Behind what it holds; its braces are balanced outside of texts and comments, as far as files of Chrono go.
    int depth = 0;
    for (; place < file_->text.size(); ++place) {
      depth += file_->text[place] == '{' ? 1 : file_->text[place] == '}' ? -1 : 0;
      if (depth == 0) break;
    }
  }
  return items;
}

std::optional<double> ChronoNode::NumberIn(const json& value, std::string_view name) const {
  if (value.is_number() && std::abs(value.get<double>()) <= kLargest) return value.get<double>();
  ReportAt(name, kChronoValue, {Called(name), value.is_number() ? "a number of this size" : "a number"});
  return std::nullopt;
}

double ChronoNode::Number(std::string_view name) const {
  const json* found = Needed(name, "a number");
  return found ? NumberIn(*found, name).value_or(0) : 0;
}

std::optional<double> ChronoNode::MaybeNumber(std::string_view name) const {
  if (!Has(name)) return std::nullopt;
  return Number(name);
}

Eigen::Vector3d ChronoNode::Vector(std::string_view name) const {
  const json* found = Needed(name, "three numbers in brackets");
  if (!found) return Eigen::Vector3d::Zero();
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  bool is_good = found->is_array() && found->size() == 3;
  for (std::size_t i = 0; is_good && i < 3; ++i) {
    is_good = found->at(i).is_number() && std::abs(found->at(i).get<double>()) <= kLargest;
    if (is_good) vector[static_cast<Eigen::Index>(i)] = found->at(i).get<double>();
  }
  if (is_good) return vector;
  ReportAt(name, kChronoValue, {Called(name), "three numbers in brackets"});
  return Eigen::Vector3d::Zero();
}

std::string ChronoNode::Text(std::string_view name) const {
  const json* found = Needed(name, "a name in quotes");
  if (!found) return "";
  if (found->is_string() && !found->get_ref<const std::string&>().empty()) return found->get<std::string>();
  ReportAt(name, kChronoValue, {Called(name), "a name in quotes"});
  return "";
}

std::vector<std::vector<double>> ChronoNode::Rows(std::string_view name, std::size_t width) const {
  const json* found = NeededList(name, "rows of numbers in brackets", kMostItems);
  std::vector<std::vector<double>> rows;
  if (!found) return rows;
  bool is_good = found->is_array();
  for (std::size_t i = 0; is_good && i < found->size(); ++i) {
    const json& row = found->at(i);
    is_good = row.is_array() && (width == 0 || row.size() == width);
    rows.emplace_back();
    for (std::size_t j = 0; is_good && j < row.size(); ++j) {
      is_good = row.at(j).is_number() && std::abs(row.at(j).get<double>()) <= kLargest;
      if (is_good) rows.back().push_back(row.at(j).get<double>());
    }
  }
  if (is_good) return rows;
  ReportAt(name, kChronoValue,
           {Called(name), width == 0 ? "rows of numbers" : "rows of " + std::to_string(width) + " numbers"});
  return {};
}

std::vector<double> ChronoNode::Numbers(std::string_view name) const {
  const json* found = NeededList(name, "numbers in brackets", kMostItems);
  std::vector<double> numbers;
  if (!found) return numbers;
  const bool is_good = found->is_array() && std::all_of(found->begin(), found->end(), [](const json& one) {
                         return one.is_number() && std::abs(one.get<double>()) <= kLargest;
                       });
  if (is_good) return found->get<std::vector<double>>();
  ReportAt(name, kChronoValue, {Called(name), "numbers in brackets"});
  return {};
}

std::optional<ChronoNode> ChronoNode::File(std::string_view name) const {
  const std::string text = Text(name);
  if (text.empty()) return std::nullopt;
  std::error_code failure;
  const std::filesystem::path from = std::filesystem::absolute(file_->path).parent_path();
  for (std::filesystem::path folder = from;; folder = folder.parent_path()) {
    for (const char* below : {"", "vehicle", "data", "data/vehicle"})
      if (const std::filesystem::path path = (folder / below / text).lexically_normal();
          std::filesystem::is_regular_file(path, failure))
        return Read(path, *diagnostics_);
    if (folder == folder.parent_path()) break;
  }
  ReportAt(name, kChronoFileMissing, {Called(name), text});
  return std::nullopt;
}

std::optional<ChronoNumber> ChronoNode::Find(const std::vector<std::string_view>& names) const {
  return value_ ? Search(*value_, names, 0) : std::nullopt;
}

std::optional<double> ChronoNode::FindNumber(const std::vector<std::string_view>& names) const {
  const std::optional<ChronoNumber> found = Find(names);
  if (!found || !(std::abs(found->value) <= kLargest)) return std::nullopt;
  return found->value;
}

}  // namespace fourpost
