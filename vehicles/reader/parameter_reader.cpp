#include "vehicles/reader/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/tags/attribute_check.h"

namespace fourpost {
namespace {

const Scalar kUnreadable{.value = std::numeric_limits<double>::quiet_NaN()};

std::string Quoted(std::string_view attribute, const Tag& tag) {
  return std::string(attribute) + "=\"" + tag.Text(attribute) + "\" of " + Describe(*tag.element);
}

/// Why this is no quantity.
std::string QuantityFault(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  if (end < text.size() && ParseNumber(text.substr(0, end)))
    return text[end] == ',' ? "has a comma: write a point"
                            : "has the unknown unit '" + std::string(Trimmed(text.substr(end))) + "'";
  return "is not a number with a unit";
}

std::string Example(const Dimension& dimension) { return "\"1 " + SiUnit(dimension) + "\""; }

/// Why a quantity does not have this dimension.
std::string DimensionFault(const Quantity& quantity, std::string_view text, const Dimension& wanted) {
  if (quantity.unit_text.empty())
    return "has no unit: " + WithArticle(wanted) + " is needed, such as \"" + std::string(Trimmed(text)) + " " +
           LikelyUnit(wanted, quantity.si) + "\"";
  return "is " + WithArticle(quantity.unit.dimension) + ": " + WithArticle(wanted) + " is needed, such as " +
         Example(wanted);
}

/// Why a text with '$' is no reference.
std::string ReferenceFault(std::string_view text) {
  const std::string remedy = "; write a number with a unit, or a parameter as in \"$k\", \"-$k\" or \"0.5*$k\"";
  const auto is_operator = [&](std::size_t i) {
    return (text[i] == '+' || text[i] == '-') && text[i - 1] != 'e' && text[i - 1] != 'E';
  };
  bool is_sum = false;
  for (std::size_t i = 1; i < text.size(); ++i) is_sum = is_sum || is_operator(i);
  if (is_sum) return "is a sum, which is not supported" + remedy;
  if (std::count(text.begin(), text.end(), '$') > 1) return "combines parameters, which is not supported" + remedy;
  return "cannot be read" + remedy;
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
  JudgeByUses(robot);
}

Parameter ParameterReader::ReadParameter(const Tag& tag) const {
  Parameter parameter;
  parameter.name = tag.Text("name");
  parameter.source = tag.Text("source");
  parameter.line = tag.Line();
  const auto is_legal = [](char c) { return c != '-' && c != '.'; };
  if (!std::all_of(parameter.name.begin(), parameter.name.end(), is_legal))
    Fault(tag, "name", "may hold letters, digits and '_' only");
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
    const std::string fault =
        quantity ? RangeFault(quantity->si, quantity->si, Sign::kAny) : QuantityFault(text) + ", such as \"32 N/mm\"";
    if (!fault.empty()) Fault(tag, attribute, fault);
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
    Fault(tag, "value",
          parameter.unit.empty()
              ? "has no unit, but " + name + " has: write \"" + tag.Text("value") + " " + quantity.unit_text + "\""
              : "is " + WithArticle(parameter.dimension) + ", but " + NamesOf(others) +
                    (others.size() > 1 ? " are " + Plural(quantity.unit.dimension)
                                       : " is " + WithArticle(quantity.unit.dimension)));
    return;
  }
  for (const auto& other : others)
    if (contradicts(other))
      Fault(tag, other.first,
            DimensionFault(other.second, tag.Text(other.first), parameter.dimension) + ", as its value");
}

void ParameterReader::ReadPrior(const Tag& tag, Parameter& parameter) const {
  const std::optional<Quantity> sd = QuantityIn(tag, "prior_sd");
  if (sd && sd->si <= 0) Fault(tag, "prior_sd", "must be above zero");
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
  if (given > 0)
    faults_.Error(tag.Line(), Describe(*tag.element) + " needs all of lower, upper and precision, or none to be fixed");
}

void ParameterReader::CheckBounds(const Tag& tag, const Parameter& parameter) const {
  const auto given = [&](const char* attribute) { return std::string(attribute) + "=\"" + tag.Text(attribute) + "\""; };
  if (parameter.precision <= 0) Fault(tag, "precision", "must be above zero");
  if (parameter.lower > parameter.upper) Fault(tag, "lower", "is above " + given("upper") + ": swap them");
  else if (parameter.value < parameter.lower)
    Fault(tag, "value", "is below " + given("lower") + ": it must lie between the bounds");
  else if (parameter.value > parameter.upper)
    Fault(tag, "value", "is above " + given("upper") + ": it must lie between the bounds");
  else if (!HasAStep(parameter))
    Fault(tag, "precision", "must not exceed upper - lower; to fix the parameter, leave out all three");
  else if (parameter.precision > 0 && !HasCountableSteps(parameter))
    Fault(tag, "precision",
          "splits the range into more than 2^53 steps; give the digits that matter, such as a "
          "thousandth of the range");
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

/// A misspelt name is told where it is used, and counts as a use of what it probably means.
void ParameterReader::NoteMisspelt(const std::string& name) {
  // Of so many, not all are told.
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
  // Of a single use nobody can tell which of the two is wrong.
  if (needed.size() < 2 || !std::all_of(needed.begin(), needed.end(), contradicts)) return true;
  faults_.Error(parameter.line, "fp:parameter '" + parameter.name + "' is " + WithArticle(parameter.dimension) +
                                    ", but where it is used, " + LinesText(lines) + ", " + WithArticle(needed.front()) +
                                    " is needed, such as " + Example(needed.front()));
  return false;
}

Scalar ParameterReader::Fault(const Tag& tag, std::string_view attribute, const std::string& message) const {
  faults_.Error(tag.Line(attribute), Quoted(attribute, tag) + " " + message);
  return kUnreadable;
}

/// For a number whose fault is told already.
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
std::string ParameterReader::NumberFault(const AttributeRule& rule, const std::string& text) const {
  const auto reference = ReferenceWithoutDollar(text);
  const auto found = reference ? index_.find(reference->name) : index_.end();
  if (found != index_.end()) return "is not a number; for the parameter write '$' before its name";
  const std::vector<std::string_view> words = {rule.word};
  const std::string needed = ": " + WithArticle(rule.dimension) + " is needed, such as " + Example(rule.dimension);
  if (rule.word.empty()) return QuantityFault(text) + needed;
  const std::string near = DidYouMean(text, words);
  return QuantityFault(text) + (near.empty() ? needed + ", or " + std::string(rule.word) : near);
}

Scalar ParameterReader::ReadReference(const Tag& tag, const AttributeRule& rule, const std::string& text) {
  const std::optional<ParameterReference> reference = ParseReference(text);
  const auto found = index_.find(reference ? std::string(reference->name) : text.substr(text.find('$') + 1));
  // The name may be what is wrong with the parameter.
  if (found != index_.end() && !sound_[static_cast<std::size_t>(found->second)]) return Unreadable();
  if (!reference) return Fault(tag, rule.name, ReferenceFault(text));
  if (found == index_.end() && lost_names_.contains(reference->name)) return Unreadable();
  if (found == index_.end())
    return Fault(tag, rule.name,
                 "refers to an unknown parameter '" + std::string(reference->name) + "'" +
                     (faults_.IsShown() ? DidYouMeanOrAll(reference->name, Names()) : ""));
  const Parameter& parameter = parameters_[static_cast<std::size_t>(found->second)];
  if (parameter.dimension != rule.dimension)
    return Fault(tag, rule.name,
                 "refers to " + WithArticle(parameter.dimension) + ": " + WithArticle(rule.dimension) +
                     " is needed; the parameter stands in line " + std::to_string(parameter.line));
  const double factor = reference->factor;
  const Scalar scalar{.value = factor * parameter.value, .parameter = found->second, .factor = factor};
  CheckRange(tag, rule, scalar);
  return scalar;
}

void ParameterReader::CheckRange(const Tag& tag, const AttributeRule& rule, const Scalar& scalar) const {
  const std::string fault = RangeFault(Least(scalar), Greatest(scalar), rule.sign);
  if (!fault.empty())
    Fault(tag, rule.name, fault + (scalar.parameter < 0 ? "" : " over the whole range of the parameter"));
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
  const std::string fault = BindFault(scalar, parameter.dimension, literal, dimension);
  if (fault.empty()) return scalar;
  if (IsMade(*bind.element)) faults_.Follow();
  else faults_.Error(bind.Line("to"), Quoted("to", bind) + " " + fault);
  return std::nullopt;
}

std::string ParameterReader::BindFault(const Scalar& scalar, const Dimension& given, double literal,
                                       const Dimension& wanted) const {
  if (given != wanted) return "is " + WithArticle(wanted) + ", but the parameter is " + WithArticle(given);
  if (!Agrees(literal, scalar.value))
    return "is " + FormatNumber(literal) + " " + SiUnit(wanted) + " in the tree, but factor times value is " +
           FormatNumber(scalar.value) + " " + SiUnit(wanted) + ": make them equal";
  const Sign sign = wanted == kMass ? Sign::kNotNegative : Sign::kAny;
  const std::string fault = RangeFault(Least(scalar), Greatest(scalar), sign);
  return fault.empty() ? "" : fault + " over the whole range of the parameter";
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
    if (sound_[i] && !used_[i] && is_first && !parameter.name.empty())
      faults_.Error(parameter.line, "fp:parameter '" + parameter.name + "' is not used: bind it or refer to it as \"$" +
                                        parameter.name + "\"");
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
