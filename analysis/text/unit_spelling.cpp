#include "analysis/text/unit_spelling.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <utility>

#include "analysis/text/units.h"

namespace fourpost {
namespace {

using Word = std::pair<std::string_view, std::string_view>;

constexpr std::array<Word, 46> kUnitWords = {{
    {"inch", "in"},        {"inches", "in"},      {"foot", "ft"},        {"feet", "ft"},         {"mils", "mil"},
    {"meter", "m"},        {"meters", "m"},       {"metre", "m"},        {"metres", "m"},        {"millimeter", "mm"},
    {"millimeters", "mm"}, {"millimetre", "mm"},  {"millimetres", "mm"}, {"centimeter", "cm"},   {"centimeters", "cm"},
    {"centimetre", "cm"},  {"centimetres", "cm"}, {"micron", "um"},      {"microns", "um"},      {"newton", "N"},
    {"newtons", "N"},      {"kilonewton", "kN"},  {"kilonewtons", "kN"}, {"kips", "kip"},        {"second", "s"},
    {"seconds", "s"},      {"secs", "s"},         {"millisecond", "ms"}, {"milliseconds", "ms"}, {"minute", "min"},
    {"minutes", "min"},    {"hour", "h"},         {"hours", "h"},        {"hertz", "Hz"},        {"degree", "deg"},
    {"degrees", "deg"},    {"radian", "rad"},     {"radians", "rad"},    {"kilogram", "kg"},     {"kilograms", "kg"},
    {"percent", "%"},      {"pascal", "Pa"},      {"mph", "mph"},        {"kph", "kph"},         {"kmh", "kmh"},
    {"fps", "fps"},
}};

constexpr std::array<std::string_view, 4> kPounds = {"lb", "lbs", "pound", "pounds"};

/// Short names that are often written in another case; no two differ by it alone.
constexpr std::array<std::string_view, 27> kNames = {"rad", "deg", "km",  "m",   "cm",  "mm",  "kg",  "s",   "ms",
                                                     "min", "Hz",  "N",   "kN",  "daN", "kPa", "MPa", "bar", "um",
                                                     "in",  "ft",  "mil", "lbm", "lbf", "kip", "psi", "ksi", "kgf"};

std::string Lower(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Each run of letters changed.
std::string WithWords(std::string_view unit, const std::function<std::string(std::string_view)>& changed) {
  std::string text;
  while (!unit.empty()) {
    const auto end = static_cast<std::size_t>(std::find_if_not(unit.begin(), unit.end(), IsLetter) - unit.begin());
    if (end == 0) {
      text += unit.front();
      unit.remove_prefix(1);
    } else {
      text += changed(unit.substr(0, end));
      unit.remove_prefix(end);
    }
  }
  return text;
}

std::string ShortName(std::string_view word) {
  const std::string lower = Lower(word);
  for (const auto& [name, shorter] : kUnitWords)
    if (lower == name) return std::string(shorter);
  return std::string(word);
}

bool IsPound(std::string_view word) { return std::find(kPounds.begin(), kPounds.end(), Lower(word)) != kPounds.end(); }

std::string InRightCase(std::string_view word) {
  for (const std::string_view name : kNames)
    if (Lower(word) == Lower(name)) return std::string(name);
  return std::string(word);
}

/// Behind a number; without the blanks about it.
std::string_view UnitOf(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of("+-.0123456789 \t"), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// "ft lb", "ft-lb" and "N.m" with the sign of a product.
std::string WithProducts(std::string_view unit) {
  std::string text(unit);
  for (std::size_t k = 1; k + 1 < text.size(); ++k)
    if (std::string_view(" -.").find(text[k]) != std::string_view::npos && IsLetter(text[k - 1]) &&
        IsLetter(text[k + 1]))
      text[k] = '*';
  return text;
}

}  // namespace

std::string WithShortNames(std::string_view unit) { return WithWords(unit, ShortName); }

std::string UnitHint(std::string_view text) {
  const std::string_view unit = UnitOf(text);
  bool has_pound = false;
  const auto meant = [&](std::string_view pound) {
    return WithWords(WithProducts(unit), [&](std::string_view word) {
      if (!IsPound(word)) return InRightCase(ShortName(word));
      has_pound = true;
      return std::string(pound);
    });
  };
  const std::string force = meant("lbf");
  if (ParseUnit(unit) || !ParseUnit(force)) return "";
  if (has_pound) return ": pounds are a mass or a force, write '" + meant("lbm") + "' or '" + force + "'";
  return ", did you mean '" + force + "'?";
}

}  // namespace fourpost
