#include "analysis/files/recorded_unit.h"

#include <array>
#include <cmath>
#include <utility>

#include "analysis/text/number.h"
#include "analysis/text/unit_spelling.h"

namespace fourpost {
namespace {

using Spelling = std::pair<std::string_view, std::string_view>;

/// In UTF-8, then in Latin-1.
constexpr std::array<Spelling, 13> kSpellings = {{
    {"\xC2\xB2", "^2"},
    {"\xC2\xB3", "^3"},
    {"\xC2\xB0", "deg"},
    {"\xC2\xB7", "*"},
    {"\xC2\xB5", "u"},
    {"\xCE\xBC", "u"},
    {"\xB2", "^2"},
    {"\xB3", "^3"},
    {"\xB0", "deg"},
    {"\xB7", "*"},
    {"\xB5", "u"},
    {"s2", "s^2"},
    {"sec", "s"},
}};

constexpr double kGravity = 9.80665;

struct RecordedUnit {
  std::string_view name;
  double si = 1;
  Dimension dimension;
};

/// Those that ParseUnit does not take, or takes as something else. "lb" may be a mass or a force, and is neither.
constexpr std::array<RecordedUnit, 9> kRecordedUnits = {{
    {"g", kGravity, kAcceleration},
    {"gn", kGravity, kAcceleration},
    {"ips", 0.0254, kVelocity},
    {"fps", 0.3048, kVelocity},
    // Of the international mile of 1609.344 m.
    {"mph", 0.44704, kVelocity},
    {"kph", 1 / 3.6, kVelocity},
    {"kmh", 1 / 3.6, kVelocity},
    {"km/hr", 1 / 3.6, kVelocity},
    // Of the international pound and the standard gravity, as in units.cpp.
    {"klbf", 1000 * 0.45359237 * kGravity, kForce},
}};

std::string Normalised(std::string_view text) {
  std::string normal = WithShortNames(text);
  for (const auto& [from, to] : kSpellings)
    for (std::size_t at = normal.find(from); at != std::string::npos; at = normal.find(from, at + to.size()))
      normal.replace(at, from.size(), to);
  return normal;
}

std::string_view Trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "Force [kN]" with '[' and ']'.
std::optional<NamedColumn> SplitAt(std::string_view text, char open, char close) {
  const std::size_t at = text.rfind(open);
  if (!text.ends_with(close) || at == std::string_view::npos) return std::nullopt;
  return NamedColumn{std::string(Trimmed(text.substr(0, at))),
                     std::string(Trimmed(text.substr(at + 1, text.size() - at - 2)))};
}

}  // namespace

std::optional<Unit> ParseRecordedUnit(std::string_view text) {
  const std::string unit = Normalised(Trimmed(text));
  if (unit == "-") return Unit{};
  for (const RecordedUnit& known : kRecordedUnits)
    if (unit == known.name) return Unit{known.si, known.dimension};
  return ParseUnit(unit);
}

std::string RecordedUnitHint(std::string_view text) {
  return ParseRecordedUnit(text) ? "" : UnitHint(WithoutBrackets(text));
}

std::optional<Quantity> ParseRecordedQuantity(std::string_view text) {
  text = Trimmed(text);
  const std::size_t end = text.find_first_not_of("+-.0123456789eE");
  const std::string_view unit_text = end == std::string_view::npos ? std::string_view() : Trimmed(text.substr(end));
  const std::optional<Unit> unit = unit_text.empty() ? Unit{} : ParseRecordedUnit(unit_text);
  const std::optional<double> number = ParseNumber(Trimmed(text.substr(0, end)));
  if (!unit || !number || !std::isfinite(*number * unit->si)) return std::nullopt;
  return Quantity{*number * unit->si, *unit, std::string(unit_text)};
}

std::string WithoutBrackets(std::string_view unit) {
  for (const std::string_view brackets : {"[]", "()"})
    if (unit.size() > 2 && unit.front() == brackets[0] && unit.back() == brackets[1] &&
        unit.find_last_of(brackets, unit.size() - 2) == 0)
      return std::string(Trimmed(unit.substr(1, unit.size() - 2)));
  return std::string(unit);
}

NamedColumn SplitColumnName(std::string_view text) {
  if (std::optional<NamedColumn> column = SplitAt(text, '[', ']');
      column && !column->name.empty() && !ParseNumber(column->unit))
    return *column;
  if (std::optional<NamedColumn> column = SplitAt(text, '(', ')');
      column && !column->name.empty() && ParseRecordedUnit(column->unit))
    return *column;
  if (const std::size_t at = text.rfind(" / "); at != std::string_view::npos && at > 0)
    if (const std::string_view unit = Trimmed(text.substr(at + 3)); ParseRecordedUnit(unit))
      return {std::string(Trimmed(text.substr(0, at))), std::string(unit)};
  return {std::string(text), ""};
}

}  // namespace fourpost
