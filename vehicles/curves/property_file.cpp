#include "vehicles/curves/property_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/curves/findings.h"

namespace fourpost {
namespace {

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\f\v";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string Capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return capitals;
}

/// Up to a comment, which no quoted text begins.
std::string_view WithoutComment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) quote = c == quote ? 0 : quote;
    else if (c == '\'' || c == '"') quote = c;
    else if (c == '$' || c == '!') return line.substr(0, i);
  }
  return line;
}

std::string_view WithoutQuotes(std::string_view text) {
  const bool is_quoted =
      text.size() >= 2 && (text.front() == '\'' || text.front() == '"') && text.back() == text.front();
  return Trimmed(is_quoted ? text.substr(1, text.size() - 2) : text);
}

/// "CURVE" of "[CURVE]"; nothing for another text.
std::optional<std::string> Within(std::string_view text, char begin, char end) {
  if (text.size() < 2 || text.front() != begin || text.back() != end) return std::nullopt;
  return Capitals(Trimmed(text.substr(1, text.size() - 2)));
}

struct NamedUnit {
  std::string_view name;
  double si;
};

// The names that Adams documents for [UNITS], with the spellings that are met beside them.
constexpr std::array kLengths = {NamedUnit{"MM", 1e-3},       NamedUnit{"MILLIMETER", 1e-3},
                                 NamedUnit{"CM", 1e-2},       NamedUnit{"CENTIMETER", 1e-2},
                                 NamedUnit{"M", 1},           NamedUnit{"METER", 1},
                                 NamedUnit{"METERS", 1},      NamedUnit{"KM", 1e3},
                                 NamedUnit{"KILOMETER", 1e3}, NamedUnit{"INCH", 0.0254},
                                 NamedUnit{"IN", 0.0254},     NamedUnit{"FOOT", 0.3048},
                                 NamedUnit{"FEET", 0.3048},   NamedUnit{"FT", 0.3048},
                                 NamedUnit{"MILE", 1609.344}};
// A pound is 0.45359237 kg, standard gravity 9.80665 m/s^2.
constexpr std::array kForces = {NamedUnit{"NEWTON", 1},
                                NamedUnit{"N", 1},
                                NamedUnit{"KNEWTON", 1e3},
                                NamedUnit{"KILONEWTON", 1e3},
                                NamedUnit{"KN", 1e3},
                                NamedUnit{"DYNE", 1e-5},
                                NamedUnit{"KG_FORCE", 9.80665},
                                NamedUnit{"KGF", 9.80665},
                                NamedUnit{"POUND_FORCE", 4.4482216152605},
                                NamedUnit{"LBF", 4.4482216152605},
                                NamedUnit{"OUNCE_FORCE", 4.4482216152605 / 16}};
constexpr std::array kAngles = {NamedUnit{"DEGREES", std::numbers::pi / 180},
                                NamedUnit{"DEGREE", std::numbers::pi / 180},
                                NamedUnit{"DEG", std::numbers::pi / 180},
                                NamedUnit{"RADIANS", 1},
                                NamedUnit{"RADIAN", 1},
                                NamedUnit{"RAD", 1}};
constexpr std::array kTimes = {NamedUnit{"SECOND", 1},  NamedUnit{"SECONDS", 1}, NamedUnit{"SEC", 1},
                               NamedUnit{"S", 1},       NamedUnit{"MS", 1e-3},   NamedUnit{"MILLISECOND", 1e-3},
                               NamedUnit{"MINUTE", 60}, NamedUnit{"MIN", 60},    NamedUnit{"HOUR", 3600}};

std::string NamesOf(std::span<const NamedUnit> units) {
  std::string names;
  for (const NamedUnit& unit : units) {
    std::string name(unit.name);
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace

std::optional<double> NumberInSi(std::string_view text, double si) {
  const int power = static_cast<int>(std::lround(std::log10(si)));
  const bool is_power = std::abs(std::pow(10, power) - si) < 1e-12 * si;
  const std::optional<double> number = ParseNumber(text, is_power ? power : 0);
  if (!number) return std::nullopt;
  const double product = is_power ? *number : *number * si;
  return std::isfinite(product) ? std::optional(product) : std::nullopt;
}

PropertyFile::PropertyFile(std::string file, std::string_view text, Diagnostics& diagnostics)
    : file_(std::move(file)), diagnostics_(diagnostics) {
  for (int line = 1; !text.empty() && !HasManyFaults(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    Take(Trimmed(WithoutComment(text.substr(0, end))), line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool PropertyFile::IsOne(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = Trimmed(WithoutComment(text.substr(0, end)));
    if (!line.empty()) return line.front() == '[' && line.find(']') != std::string_view::npos;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

void PropertyFile::Take(std::string_view line, int number) {
  if (line.empty()) return;
  if (const std::optional<std::string> name = Within(line, '[', ']')) {
    is_in_subblock_ = false;
    const auto [found, is_new] = blocks_.try_emplace(*name, Block{.line = number});
    if (!is_new) Report(kTeimBlockTwice, number, {*name, std::to_string(found->second.line)});
    block_ = &found->second;
    return;
  }
  if (Within(line, '(', ')')) {
    is_in_subblock_ = true;
    return;
  }
  if (is_in_subblock_ || Within(line, '{', '}')) return;
  if (!block_) return Report(kTeimLine, number, {std::string(line)});
  if (const std::size_t equals = line.find('='); equals != std::string_view::npos) {
    block_->values.insert_or_assign(Capitals(Trimmed(line.substr(0, equals))),
                                    Value{std::string(WithoutQuotes(Trimmed(line.substr(equals + 1)))), number});
    return;
  }
  block_->rows.push_back({std::string(line), number});
}

void PropertyFile::CheckType(std::string_view type, std::string_view what) const {
  for (const char* header : {"MDI_HEADER", "HEADER"}) {
    const Block* block = FindAny(header);
    if (!block || !block->values.contains("FILE_TYPE")) continue;
    const Value& value = block->values.find("FILE_TYPE")->second;
    if (Capitals(value.text) != Capitals(type))
      Report(kTeimType, value.line, {value.text, std::string(what), std::string(type)});
  }
}

const PropertyFile::Block* PropertyFile::FindAny(std::string_view name) const {
  const auto found = blocks_.find(name);
  return found == blocks_.end() ? nullptr : &found->second;
}

const PropertyFile::Block* PropertyFile::Find(std::string_view name, std::string_view what) const {
  if (const Block* block = FindAny(name)) return block;
  std::vector<std::string> names;
  for (const auto& [known, block] : blocks_) names.push_back(known);
  Report(kTeimBlockMissing, 0, {std::string(name), DidYouMean(name, names), std::string(what)});
  return nullptr;
}

std::optional<PropertyFile::Units> PropertyFile::ReadUnits(bool with_angle, std::string_view what) const {
  const Block* block = Find("UNITS", what);
  if (!block) return std::nullopt;
  bool is_good = true;
  const auto read = [&](const char* name, std::span<const NamedUnit> known, double& si) {
    const auto found = block->values.find(name);
    if (found == block->values.end()) {
      Report(kTeimValueMissing, block->line, {"UNITS", name, name, "'" + std::string(known.front().name) + "'"});
      is_good = false;
      return;
    }
    const auto unit = std::find_if(known.begin(), known.end(), [&](const NamedUnit& candidate) {
      return candidate.name == Capitals(found->second.text);
    });
    if (unit == known.end()) {
      Report(kTeimUnit, found->second.line, {name, found->second.text, NamesOf(known)});
      is_good = false;
      return;
    }
    si = unit->si;
  };
  Units units;
  read("LENGTH", kLengths, units.length);
  read("FORCE", kForces, units.force);
  read("TIME", kTimes, units.time);
  if (with_angle) read("ANGLE", kAngles, units.angle);
  if (!is_good) return std::nullopt;
  return units;
}

std::optional<double> PropertyFile::Number(std::string_view block_name, std::string_view name, double si,
                                           std::string_view sample) const {
  const Block* block = FindAny(block_name);
  if (!block) return std::nullopt;
  const auto found = block->values.find(name);
  if (found == block->values.end()) {
    Report(kTeimValueMissing, block->line,
           {std::string(block_name), std::string(name), std::string(name), std::string(sample)});
    return std::nullopt;
  }
  const std::optional<double> number = NumberInSi(found->second.text, si);
  if (!number)
    Report(kTeimValue, found->second.line,
           {std::string(name), found->second.text, std::string(name), std::string(sample)});
  return number;
}

}  // namespace fourpost
