#include "vehicles/tags/attribute_check.h"

#include <algorithm>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/tags/findings.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// What is wrong with a plain number; nullptr: nothing.
const Finding* NumberFault(std::string_view text, Sign sign) {
  const std::optional<double> number = ParseNumber(Trimmed(text));
  return number ? RangeFault(*number, *number, sign) : &kNotAPlainNumber;
}

const Finding* VectorFault(std::string_view text, bool must_point) {
  const std::optional<Eigen::Vector3d> vector = ParseVector(text);
  if (!vector) return &kNotAVector;
  if (vector->cwiseAbs().maxCoeff() > kLargestNumber) return &kNumberTooLarge;
  // Its length is a square root of squares, which may be zero before the direction is.
  return must_point && vector->norm() < 1 / kLargestNumber ? &kZeroDirection : nullptr;
}

bool IsOneOf(const std::string& text, const std::vector<std::string_view>& choices) {
  return std::find(choices.begin(), choices.end(), text) != choices.end();
}

const Finding* Fault(const AttributeRule& rule, const std::string& text) {
  if (Trimmed(text).empty()) return &kAttributeEmpty;
  switch (rule.kind) {
    case AttributeKind::kName:
      return std::all_of(text.begin(), text.end(), IsNameCharacter) ? nullptr : &kNameCharacters;
    case AttributeKind::kNumber: return NumberFault(text, rule.sign);
    case AttributeKind::kVector: return VectorFault(text, false);
    case AttributeKind::kDirection: return VectorFault(text, true);
    case AttributeKind::kChoice: return IsOneOf(text, rule.choices) ? nullptr : &kUnknownChoice;
    default: return nullptr;
  }
}

std::string QuotedText(std::string_view attribute, const std::string& text, const tinyxml2::XMLElement& element) {
  return std::string(attribute) + "=\"" + text + "\" of " + Describe(element);
}

/// Whether a finding has a word behind the attribute's, for the range of a parameter.
bool IsAboutRange(const Finding& fault) { return fault.text().ends_with("{}"); }

}  // namespace

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

void CheckAttribute(const tinyxml2::XMLElement& element, const AttributeRule& rule, const std::string& text, int line,
                    FileFaults& faults) {
  const Finding* fault = Fault(rule, text);
  if (!fault) return;
  std::vector<std::string> words = {QuotedText(rule.name, text, element)};
  if (fault == &kUnknownChoice) words.insert(words.end(), {Joined(rule.choices), DidYouMean(text, rule.choices)});
  else if (IsAboutRange(*fault)) words.emplace_back();
  faults.Report(*fault, line, words);
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

const Finding* RangeFault(double least, double greatest, Sign sign) {
  if (sign == Sign::kNotNegative && !(least >= 0)) return &kNumberNegative;
  if (sign == Sign::kPositive && !(least >= 1 / kLargestNumber))
    return least > 0 ? &kNumberTooSmall : &kNumberNotPositive;
  return least >= -kLargestNumber && greatest <= kLargestNumber ? nullptr : &kNumberTooLarge;
}

std::string Quoted(std::string_view attribute, const Tag& tag) {
  return QuotedText(tag.Spelling(attribute), tag.Text(attribute), *tag.element);
}

std::string Joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace fourpost
