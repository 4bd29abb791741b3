#include "vehicles/tags/attribute_check.h"

#include <algorithm>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

constexpr const char* kTooLarge = "must not exceed 1e30 in SI units";

/// What is wrong with a plain number; empty: nothing.
std::string NumberFault(std::string_view text, Sign sign) {
  const std::optional<double> number = ParseNumber(Trimmed(text));
  if (!number) return "is not a plain number";
  return RangeFault(*number, *number, sign);
}

std::string VectorFault(std::string_view text, bool must_point) {
  const std::optional<Eigen::Vector3d> vector = ParseVector(text);
  if (!vector) return "must be three numbers, such as \"0 0 1\"";
  if (vector->cwiseAbs().maxCoeff() > kLargestNumber) return kTooLarge;
  // Its length is a square root of squares, which may be zero before the direction is.
  return must_point && vector->norm() < 1 / kLargestNumber ? "must not be zero: it is a direction" : "";
}

std::string ChoiceFault(const std::string& text, const std::vector<std::string_view>& choices) {
  if (std::find(choices.begin(), choices.end(), text) != choices.end()) return "";
  return "must be one of " + Joined(choices) + DidYouMean(text, choices);
}

std::string Fault(const AttributeRule& rule, const std::string& text) {
  if (Trimmed(text).empty()) return "is empty";
  switch (rule.kind) {
    case AttributeKind::kName:
      return std::all_of(text.begin(), text.end(), IsNameCharacter) ? ""
                                                                    : "may hold letters, digits, '_', '-' and '.' only";
    case AttributeKind::kNumber: return NumberFault(text, rule.sign);
    case AttributeKind::kVector: return VectorFault(text, false);
    case AttributeKind::kDirection: return VectorFault(text, true);
    case AttributeKind::kChoice: return ChoiceFault(text, rule.choices);
    default: return "";
  }
}

}  // namespace

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

void CheckAttribute(const tinyxml2::XMLElement& element, const AttributeRule& rule, const std::string& text, int line,
                    FileFaults& faults) {
  const std::string fault = Fault(rule, text);
  if (fault.empty()) return;
  faults.Error(line, std::string(rule.name) + "=\"" + text + "\" of " + Describe(element) + " " + fault);
}

std::string Expectation(const AttributeRule& rule) {
  if (rule.kind == AttributeKind::kScalar)
    return ", " + WithArticle(rule.dimension) + " such as \"1 " + SiUnit(rule.dimension) + "\"";
  if (!rule.doc.empty()) return ": " + std::string(rule.doc);
  if (!rule.choices.empty()) return ": " + Joined(rule.choices);
  const bool is_vector = rule.kind == AttributeKind::kVector || rule.kind == AttributeKind::kDirection;
  return is_vector ? ", such as \"0 0 1\"" : "";
}

std::string WithArticle(const Dimension& dimension) {
  const std::string name = DimensionName(dimension);
  const bool has_vowel = std::string_view("aeiou").find(name.front()) != std::string_view::npos;
  return (has_vowel ? "an " : "a ") + name;
}

std::string Plural(const Dimension& dimension) {
  const std::string name = DimensionName(dimension);
  if (name == SiUnit(dimension)) return "in " + name;
  if (name.ends_with("y")) return name.substr(0, name.size() - 1) + "ies";
  return name + (name.ends_with("s") ? "es" : "s");
}

std::string RangeFault(double least, double greatest, Sign sign) {
  if (sign == Sign::kNotNegative && !(least >= 0)) return "must not be negative";
  if (sign == Sign::kPositive && !(least >= 1 / kLargestNumber))
    return least > 0 ? "must be 1e-30 in SI units at least" : "must be above zero";
  return least >= -kLargestNumber && greatest <= kLargestNumber ? "" : kTooLarge;
}

std::string Joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace fourpost
