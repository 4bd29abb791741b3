#include "vehicles/reader/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/unit_spelling.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/parameter_likeness.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/reader/tree_reference.h"
#include "vehicles/tags/attribute_check.h"
#include "vehicles/tags/findings.h"

namespace fourpost {
namespace {

constexpr const char* kOverRange = " over the whole range of the parameter";

const Scalar kUnreadable{.value = std::numeric_limits<double>::quiet_NaN()};

// The words of these faults are to follow the attribute's.

/// Why this is no quantity; `needed`: what is, with an example.
Found QuantityFault(std::string_view text, const std::string& needed) {
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  if (end == text.size() || !ParseNumber(text.substr(0, end))) return {&kNotAQuantity, {needed}};
  if (text[end] == ',') return {&kNumberComma, {needed}};
  return {&kNumberUnknownUnit, {std::string(Trimmed(text.substr(end))), UnitHint(text), needed}};
}

std::string Example(const Dimension& dimension) { return "1 " + SiUnit(dimension); }

/// Why a quantity does not have this dimension; `as`: as what else.
Found DimensionFault(const Quantity& quantity, std::string_view text, const Dimension& wanted,
                     const std::string& as = "") {
  if (quantity.unit_text.empty())
    return {&kNumberWithoutUnit,
            {WithArticle(wanted), std::string(Trimmed(text)) + " " + LikelyUnit(wanted, quantity.si), as}};
  return {&kNumberOfOtherDimension, {WithArticle(quantity.unit.dimension), WithArticle(wanted), Example(wanted), as}};
}

/// Why a text with '$' is no reference.
const Finding& ReferenceFault(std::string_view text) {
  const auto is_operator = [&](std::size_t i) {
    return (text[i] == '+' || text[i] == '-') && text[i - 1] != 'e' && text[i - 1] != 'E';
  };
  bool is_sum = false;
  for (std::size_t i = 1; i < text.size(); ++i) is_sum = is_sum || is_operator(i);
  if (is_sum) return kReferenceSum;
  return std::count(text.begin(), text.end(), '$') > 1 ? kReferenceProduct : kReferenceUnreadable;
}

/// The quantity in an attribute of `<fp:parameter>`; nothing when it is left out or faulty.
std::optional<Quantity> QuantityIn(const Tag& tag, std::string_view attribute) {
  return ParseQuantity(Trimmed(tag.Text(attribute)));
}

/// "lower", "lower and upper", "lower, upper and precision".
std::string NamesOf(const std::vector<std::pair<std::string_view, Quantity>>& quantities) {
  std::string text;
  for (std::size_t i = 0; i < quantities.size(); ++i)
    text += (i == 0 ? "" : i + 1 == quantities.size() ? " and " : ", ") + std::string(quantities[i].first);
  return text;
}

/// "in line 4", "in lines 4 and 5", "in lines 4, 5, 6 and others".
std::string LinesText(const std::set<int>& lines) {
  constexpr std::size_t kMostShown = 3;
  std::string text = lines.size() == 1 ? "in line " : "in lines ";
  std::size_t count = 0;
  for (const int line : lines) {
    if (count == kMostShown) return text + " and others";
    const bool is_last = ++count == lines.size();
    text += (count == 1 ? "" : is_last ? " and " : ", ") + std::to_string(line);
  }
  return text;
}

/// Whether a step of the precision leads from one bound to the other, or less far.
bool HasAStep(const Parameter& parameter) {
  // Rounding of the bounds: 0.3 - 0.2 is less than 0.1.
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(parameter.lower), std::abs(parameter.upper));
  return parameter.precision <= parameter.upper - parameter.lower + rounding;
}

/// Whether each step between the bounds has a number of its own, as searches need it.
bool HasCountableSteps(const Parameter& parameter) {
  constexpr double kMostSteps = 0x1p53;
  return (parameter.upper - parameter.lower) / parameter.precision < kMostSteps;
}

}  // namespace

bool Agrees(double literal, double bound) {
  // The digits of a rounded number in a file.
  constexpr double kEqual = 1e-9;
  return std::abs(bound - literal) <= kEqual * std::abs(bound);
}

ParameterReader::ParameterReader(const tinyxml2::XMLElement& robot, FileFaults& faults)
    : faults_(faults), lost_names_(LostNames(robot)) {
  for (const Tag& tag : TagsOf(robot, "fp:parameter")) {
    const int errors = faults_.errors();
    parameters_.push_back(ReadParameter(tag));
    sound_.push_back(faults_.errors() == errors && AttributeText(*tag.element, "value"));
    index_.try_emplace(parameters_.back().name, static_cast<int>(parameters_.size()) - 1);
  }
  used_.resize(parameters_.size());
  const std::vector<Tag> tags = TagsOf(robot, "fp:parameter");
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (sound_[i]) parameters_[i].like = ReadLikeness(tags[i], i, parameters_, sound_, faults_);
  JudgeByUses(robot);
}

Parameter ParameterReader::ReadParameter(const Tag& tag) const {
  Parameter parameter;
  parameter.name = tag.Text("name");
  parameter.source = tag.Text("source");
  parameter.line = tag.Line();
  const auto is_legal = [](char c) { return c != '-' && c != '.'; };
  if (!std::all_of(parameter.name.begin(), parameter.name.end(), is_legal)) Fault(tag, "name", {&kParameterName});
  const int errors = faults_.errors();
  CheckQuantities(tag);
  const std::optional<Quantity> value = QuantityIn(tag, "value");
  if (!value) return parameter;
  parameter.value = parameter.lower = parameter.upper = value->si;
  parameter.dimension = value->unit.dimension;
  parameter.unit = value->unit_text;
  CheckDimensions(tag, parameter);
  if (faults_.errors() > errors) return parameter;
  ReadBounds(tag, parameter);
  ReadPrior(tag, parameter);
  return parameter;
}

void ParameterReader::CheckQuantities(const Tag& tag) const {
  for (const char* attribute : {"value", "lower", "upper", "precision", "prior_sd"}) {
    const std::string text(Trimmed(tag.Text(attribute)));
    if (text.empty()) continue;
    const std::optional<Quantity> quantity = QuantityIn(tag, attribute);
    if (!quantity) Fault(tag, attribute, QuantityFault(text, "a number with a unit, such as \"32 N/mm\""));
    else if (const Finding* fault = RangeFault(quantity->si, quantity->si, Sign::kAny))
      Fault(tag, attribute, {fault, {""}});
  }
}

/// The value is at fault where all others contradict it, and agree.
void ParameterReader::CheckDimensions(const Tag& tag, const Parameter& parameter) const {
  std::vector<std::pair<std::string_view, Quantity>> others;
  for (const char* attribute : {"lower", "upper", "precision", "prior_sd"})
    if (const std::optional<Quantity> quantity = QuantityIn(tag, attribute)) others.emplace_back(attribute, *quantity);
  const auto contradicts = [&](const auto& other) { return other.second.unit.dimension != parameter.dimension; };
  const auto agrees = [&](const auto& other) {
    return other.second.unit.dimension == others.front().second.unit.dimension;
  };
  const bool is_outvoted = (others.size() > 1 || parameter.unit.empty()) && !others.empty() &&
                           std::all_of(others.begin(), others.end(), contradicts) &&
                           std::all_of(others.begin(), others.end(), agrees);
  if (is_outvoted) {
    const auto& [attribute, quantity] = others.front();
    const std::string name(attribute);
    const std::string are =
        others.size() > 1 ? " are " + Plural(quantity.unit.dimension) : " is " + WithArticle(quantity.unit.dimension);
    if (parameter.unit.empty())
      Fault(tag, "value", {&kValueWithoutUnit, {name, tag.Text("value") + " " + quantity.unit_text}});
    else Fault(tag, "value", {&kValueOfOtherDimension, {WithArticle(parameter.dimension), NamesOf(others) + are}});
    return;
  }
  for (const auto& other : others)
    if (contradicts(other))
      Fault(tag, other.first,
            DimensionFault(other.second, tag.Text(other.first), parameter.dimension, ", as its value"));
}

void ParameterReader::ReadPrior(const Tag& tag, Parameter& parameter) const {
  const std::optional<Quantity> sd = QuantityIn(tag, "prior_sd");
  if (sd && sd->si <= 0) Fault(tag, "prior_sd", {&kNumberNotPositive, {""}});
  if (sd) parameter.prior_sd = sd->si;
}

void ParameterReader::ReadBounds(const Tag& tag, Parameter& parameter) const {
  const std::vector<std::pair<std::string_view, double*>> places = {
      {"lower", &parameter.lower}, {"upper", &parameter.upper}, {"precision", &parameter.precision}};
  std::size_t given = 0;
  for (const auto& [attribute, place] : places) {
    if (!AttributeText(*tag.element, attribute)) continue;
    ++given;
    if (const std::optional<Quantity> quantity = QuantityIn(tag, attribute)) *place = quantity->si;
  }
  if (given == places.size()) return CheckBounds(tag, parameter);
  if (given > 0) faults_.Report(kBoundsIncomplete, tag.Line(), {Describe(*tag.element)});
}

void ParameterReader::CheckBounds(const Tag& tag, const Parameter& parameter) const {
  const auto given = [&](const char* attribute) { return std::string(attribute) + "=\"" + tag.Text(attribute) + "\""; };
  if (parameter.precision <= 0) Fault(tag, "precision", {&kNumberNotPositive, {""}});
  if (parameter.lower > parameter.upper) Fault(tag, "lower", {&kBoundsSwapped, {given("upper")}});
  else if (parameter.value < parameter.lower) Fault(tag, "value", {&kValueBelowLower, {given("lower")}});
  else if (parameter.value > parameter.upper) Fault(tag, "value", {&kValueAboveUpper, {given("upper")}});
  else if (!HasAStep(parameter)) Fault(tag, "precision", {&kPrecisionTooCoarse});
  else if (parameter.precision > 0 && !HasCountableSteps(parameter)) Fault(tag, "precision", {&kPrecisionTooFine});
}

/// Notes which parameters are used, and reports those that all uses contradict: the uses are right then.
void ParameterReader::JudgeByUses(const tinyxml2::XMLElement& robot) {
  std::map<std::string, std::vector<ParameterUse>, std::less<>> uses;
  for (ParameterUse& use : FindParameterUses(robot)) uses[use.parameter].push_back(std::move(use));
  for (const auto& [name, found] : uses) {
    const auto index = index_.find(name);
    if (index == index_.end()) {
      NoteMisspelt(name);
      continue;
    }
    const auto i = static_cast<std::size_t>(index->second);
    used_[i] = true;
    if (sound_[i]) sound_[i] = AgreesWithUses(parameters_[i], found);
  }
}

/// A misspelt name is reported where it is used, and counts as a use of what it probably means.
void ParameterReader::NoteMisspelt(const std::string& name) {
  // Of so many, not all are reported.
  constexpr int kMost = 100;
  if (++misspelt_ > kMost) return;
  const std::vector<std::string> names = Names();
  if (const auto near = NearestName(name, names)) used_[static_cast<std::size_t>(index_.find(*near)->second)] = true;
}

bool ParameterReader::AgreesWithUses(const Parameter& parameter, const std::vector<ParameterUse>& uses) const {
  std::set<int> lines;
  std::vector<Dimension> needed;
  for (const ParameterUse& use : uses) {
    if (!use.dimension) continue;
    lines.insert(use.line);
    needed.push_back(*use.dimension);
  }
  const auto contradicts = [&](const Dimension& dimension) {
    return dimension != parameter.dimension && dimension == needed.front();
  };
  // Of a single use nobody knows which of the two is wrong.
  if (needed.size() < 2 || !std::all_of(needed.begin(), needed.end(), contradicts)) return true;
  faults_.Report(kParameterMisused, parameter.line,
                 {parameter.name, WithArticle(parameter.dimension), WithArticle(needed.front()), LinesText(lines),
                  Example(needed.front())});
  return false;
}

Scalar ParameterReader::Fault(const Tag& tag, std::string_view attribute, const Found& fault) const {
  std::vector<std::string> words = fault.words;
  words.insert(words.begin(), Quoted(attribute, tag));
  faults_.Report(*fault.kind, tag.Line(attribute), words);
  return kUnreadable;
}

/// For a number whose fault is reported already.
Scalar ParameterReader::Unreadable() const {
  faults_.Follow();
  return kUnreadable;
}

Scalar ParameterReader::ReadScalar(const Tag& tag, std::string_view attribute) {
  const AttributeRule& rule = *FindAttribute(*tag.rule, attribute);
  const std::string text(Trimmed(tag.Text(attribute)));
  if (text.find('$') != std::string::npos) return ReadReference(tag, rule, text);
  if (text.empty()) return Unreadable();
  const std::optional<Quantity> quantity = ParseQuantity(text);
  if (!quantity) return Fault(tag, attribute, NumberFault(rule, text));
  if (quantity->unit.dimension != rule.dimension)
    return Fault(tag, attribute, DimensionFault(*quantity, text, rule.dimension));
  const Scalar scalar{.value = quantity->si};
  CheckRange(tag, rule, scalar);
  return scalar;
}

/// Why this is no number with a unit, and what it should be.
Found ParameterReader::NumberFault(const AttributeRule& rule, const std::string& text) const {
  const auto reference = ReferenceWithoutDollar(text);
  const auto found = reference ? index_.find(reference->name) : index_.end();
  if (found != index_.end()) return {&kParameterWithoutDollar};
  const std::vector<std::string_view> words = {rule.word};
  const std::string needed = WithArticle(rule.dimension) + " such as \"" + Example(rule.dimension) + "\"";
  if (rule.word.empty()) return QuantityFault(text, needed);
  if (const std::string near = DidYouMean(text, words); !near.empty()) return {&kWordMisspelt, {near}};
  return QuantityFault(text, needed + ", or " + std::string(rule.word));
}

Scalar ParameterReader::ReadReference(const Tag& tag, const AttributeRule& rule, const std::string& text) {
  const std::optional<ParameterReference> reference = ParseReference(text);
  const auto found = index_.find(reference ? std::string(reference->name) : text.substr(text.find('$') + 1));
  // The name may be what is wrong with the parameter.
  if (found != index_.end() && !sound_[static_cast<std::size_t>(found->second)]) return Unreadable();
  if (!reference) return Fault(tag, rule.name, {&ReferenceFault(text)});
  if (found == index_.end() && lost_names_.contains(reference->name)) return Unreadable();
  if (found == index_.end())
    return Fault(tag, rule.name,
                 {&kParameterUnknown,
                  {std::string(reference->name), faults_.IsShown() ? DidYouMeanOrAll(reference->name, Names()) : ""}});
  const Parameter& parameter = parameters_[static_cast<std::size_t>(found->second)];
  if (parameter.dimension != rule.dimension)
    return Fault(tag, rule.name,
                 {&kParameterOfOtherDimension,
                  {WithArticle(parameter.dimension), std::to_string(parameter.line), WithArticle(rule.dimension)}});
  const double factor = reference->factor;
  const Scalar scalar{.value = factor * parameter.value, .parameter = found->second, .factor = factor};
  CheckRange(tag, rule, scalar);
  return scalar;
}

void ParameterReader::CheckRange(const Tag& tag, const AttributeRule& rule, const Scalar& scalar) const {
  if (const Finding* fault = RangeFault(Least(scalar), Greatest(scalar), rule.sign))
    Fault(tag, rule.name, {fault, {scalar.parameter < 0 ? "" : kOverRange}});
}

std::optional<Scalar> ParameterReader::Bind(const Tag& bind, double literal, const Dimension& dimension) const {
  const std::string owner = AttributeText(*bind.element->Parent()->ToElement(), "name").value_or("");
  const auto found = index_.find(owner);
  const std::optional<double> factor = ParseNumber(Trimmed(bind.Text("factor")));
  if (found == index_.end() || !factor || !sound_[static_cast<std::size_t>(found->second)]) {
    faults_.Follow();
    return std::nullopt;
  }
  const Parameter& parameter = parameters_[static_cast<std::size_t>(found->second)];
  const Scalar scalar{.value = *factor * parameter.value, .parameter = found->second, .factor = *factor};
  const Found fault = BindFault(scalar, parameter.dimension, literal, dimension);
  if (!fault) return scalar;
  if (IsTreeReference(*bind.element)) {
    std::vector<std::string> words = fault.words;
    words.insert(words.begin(), TreeReferenceText(*bind.element));
    faults_.Report(*fault.kind, LineOf(*bind.element), words);
  } else if (IsMade(*bind.element)) {
    faults_.Follow();
  } else {
    Fault(bind, "to", fault);
  }
  return std::nullopt;
}

Found ParameterReader::BindFault(const Scalar& scalar, const Dimension& given, double literal,
                                 const Dimension& wanted) const {
  if (given != wanted) return {&kBindDimension, {WithArticle(wanted), WithArticle(given)}};
  const auto text = [&](double number) { return FormatNumber(number) + " " + SiUnit(wanted); };
  if (!Agrees(literal, scalar.value)) {
    const std::string& name = parameters_[static_cast<std::size_t>(scalar.parameter)].name;
    const std::string factor = scalar.factor == 1 ? "" : scalar.factor == -1 ? "-" : FormatNumber(scalar.factor) + "*";
    return {&kBindValue, {text(literal), name, text(scalar.value), factor + "$" + name}};
  }
  const Sign sign = wanted == kMass ? Sign::kNotNegative : Sign::kAny;
  const Finding* fault = RangeFault(Least(scalar), Greatest(scalar), sign);
  return fault ? Found{fault, {kOverRange}} : Found{};
}

double ParameterReader::Least(const Scalar& scalar) const {
  if (scalar.parameter < 0) return scalar.value;
  const Parameter& parameter = parameters_[static_cast<std::size_t>(scalar.parameter)];
  return std::min({scalar.factor * parameter.lower, scalar.factor * parameter.value, scalar.factor * parameter.upper});
}

double ParameterReader::Greatest(const Scalar& scalar) const {
  Scalar mirrored = scalar;
  mirrored.value = -mirrored.value;
  mirrored.factor = -mirrored.factor;
  return -Least(mirrored);
}

bool ParameterReader::IsBelow(const Scalar& a, const Scalar& b) const {
  if (a.parameter != b.parameter) return Greatest(a) < Least(b);
  return Least({.value = b.value - a.value, .parameter = b.parameter, .factor = b.factor - a.factor}) > 0;
}

void ParameterReader::CheckUse() const {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& parameter = parameters_[i];
    const bool is_first = index_.find(parameter.name)->second == static_cast<int>(i);
    // One that holds the value of another at a setting, which studies use.
    const std::size_t at = parameter.name.find("_at_");
    const bool is_setting = at != std::string::npos && index_.contains(parameter.name.substr(0, at));
    if (sound_[i] && !used_[i] && is_first && !is_setting && !parameter.name.empty())
      faults_.Report(kParameterUnused, parameter.line, {parameter.name, parameter.name});
  }
}

std::vector<double> ParameterReader::Values() const {
  std::vector<double> values;
  for (const Parameter& parameter : parameters_) values.push_back(parameter.value);
  return values;
}

std::vector<std::string> ParameterReader::Names() const {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters_) names.push_back(parameter.name);
  return names;
}

}  // namespace fourpost
