#include "vehicles/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/nearest.h"
#include "analysis/number.h"
#include "vehicles/attribute_check.h"

namespace fourpost {
namespace {

std::string Quoted(std::string_view attribute, const std::string& text, const Tag& tag) {
  return std::string(attribute) + "=\"" + text + "\" of " + Describe(*tag.element);
}

/// Why this is no quantity.
std::string QuantityFault(std::string_view text) {
  const std::size_t blank = text.find_first_of(" \t");
  if (blank != std::string_view::npos && ParseNumber(text.substr(0, blank)))
    return "has the unknown unit '" + std::string(Trimmed(text.substr(blank))) + "'";
  return "is not a number with a unit, such as \"32 N/mm\"";
}

/// Why a quantity does not have this dimension.
std::string DimensionFault(const Quantity& quantity, std::string_view text, const Dimension& wanted) {
  if (quantity.unit_text.empty())
    return "has no unit: " + WithArticle(wanted) + " is needed, such as \"" + std::string(Trimmed(text)) + " " +
           SiUnit(wanted) + "\"";
  return "is " + WithArticle(quantity.unit.dimension) + ": " + WithArticle(wanted) + " is needed, such as \"1 " +
         SiUnit(wanted) + "\"";
}

std::optional<Quantity> ReadQuantity(const Tag& tag, std::string_view attribute, FileFaults& faults) {
  const std::string text = tag.Text(attribute);
  if (Trimmed(text).empty()) return std::nullopt;
  std::optional<Quantity> quantity = ParseQuantity(Trimmed(text));
  if (!quantity) faults.Error(tag.Line(attribute), Quoted(attribute, text, tag) + " " + QuantityFault(Trimmed(text)));
  return quantity;
}

/// The factor before a '$': "" is 1, "-" is -1, "0.5*" is 0.5.
std::optional<double> ParseFactor(std::string_view text) {
  if (text.empty()) return 1;
  if (text == "-") return -1;
  if (text.back() != '*') return std::nullopt;
  return ParseNumber(Trimmed(text.substr(0, text.size() - 1)));
}

/// Whether a step of the precision leads from one bound to the other, or less far.
bool HasAStep(const Parameter& parameter) {
  // Rounding of the bounds: 0.3 - 0.2 is less than 0.1.
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(parameter.lower), std::abs(parameter.upper));
  return parameter.precision <= parameter.upper - parameter.lower + rounding;
}

}  // namespace

bool Agrees(double literal, double bound) {
  // The digits of a rounded number in a file.
  constexpr double kEqual = 1e-9;
  return std::abs(bound - literal) <= kEqual * std::abs(bound);
}

ParameterReader::ParameterReader(const tinyxml2::XMLElement& robot, FileFaults& faults) : faults_(faults) {
  for (const Tag& tag : TagsOf(robot, "fp:parameter")) {
    const int errors = faults_.errors();
    parameters_.push_back(ReadParameter(tag));
    sound_.push_back(faults_.errors() == errors && AttributeText(*tag.element, "value"));
    // Even if what it binds is wrong, which is told elsewhere.
    used_.push_back(tag.element->FirstChildElement("fp:bind") != nullptr);
    index_.try_emplace(parameters_.back().name, static_cast<int>(parameters_.size()) - 1);
  }
}

Parameter ParameterReader::ReadParameter(const Tag& tag) const {
  Parameter parameter;
  parameter.name = tag.Text("name");
  parameter.source = tag.Text("source");
  parameter.line = tag.Line();
  const auto is_legal = [](char c) { return c != '-' && c != '.'; };
  if (!std::all_of(parameter.name.begin(), parameter.name.end(), is_legal))
    faults_.Error(tag.Line("name"), Quoted("name", parameter.name, tag) + " may hold letters, digits and '_' only");
  if (const std::optional<Quantity> value = ReadQuantity(tag, "value", faults_)) {
    parameter.value = parameter.lower = parameter.upper = value->si;
    parameter.dimension = value->unit.dimension;
    parameter.unit = value->unit_text;
    ReadBounds(tag, parameter);
    ReadPrior(tag, parameter);
  }
  return parameter;
}

void ParameterReader::ReadPrior(const Tag& tag, Parameter& parameter) const {
  if (!AttributeText(*tag.element, "prior_sd")) return;
  const std::optional<Quantity> sd = ReadQuantity(tag, "prior_sd", faults_);
  if (!sd) return;
  const auto fault = [&](const std::string& text) {
    faults_.Error(tag.Line("prior_sd"), Quoted("prior_sd", tag.Text("prior_sd"), tag) + " " + text);
  };
  if (sd->unit.dimension != parameter.dimension)
    return fault(DimensionFault(*sd, tag.Text("prior_sd"), parameter.dimension) + ", as its value");
  if (sd->si <= 0) return fault("must be above zero");
  parameter.prior_sd = sd->si;
}

void ParameterReader::ReadBounds(const Tag& tag, Parameter& parameter) const {
  const std::vector<std::pair<std::string_view, double*>> places = {
      {"lower", &parameter.lower}, {"upper", &parameter.upper}, {"precision", &parameter.precision}};
  std::size_t given = 0;
  const int errors = faults_.errors();
  for (const auto& [attribute, place] : places) {
    if (!AttributeText(*tag.element, attribute)) continue;
    ++given;
    const std::optional<Quantity> quantity = ReadQuantity(tag, attribute, faults_);
    if (!quantity) continue;
    *place = quantity->si;
    if (parameter.unit.empty() && !quantity->unit_text.empty()) {
      faults_.Error(tag.Line("value"), Quoted("value", tag.Text("value"), tag) + " has no unit, but " +
                                           std::string(attribute) + " has: write \"" + tag.Text("value") + " " +
                                           quantity->unit_text + "\"");
      return;
    }
    if (quantity->unit.dimension != parameter.dimension)
      faults_.Error(tag.Line(attribute), Quoted(attribute, tag.Text(attribute), tag) + " " +
                                             DimensionFault(*quantity, tag.Text(attribute), parameter.dimension) +
                                             ", as its value");
  }
  if (given == 0) return;
  if (given != places.size())
    faults_.Error(tag.Line(), Describe(*tag.element) + " needs all of lower, upper and precision, or none to be fixed");
  if (faults_.errors() > errors) return;
  if (parameter.precision <= 0)
    faults_.Error(tag.Line("precision"), Quoted("precision", tag.Text("precision"), tag) + " must be above zero");
  if (parameter.lower > parameter.value || parameter.value > parameter.upper)
    faults_.Error(tag.Line("value"), Quoted("value", tag.Text("value"), tag) + " must lie between lower=\"" +
                                         tag.Text("lower") + "\" and upper=\"" + tag.Text("upper") + "\"");
  else if (!HasAStep(parameter))
    faults_.Error(tag.Line("precision"),
                  Quoted("precision", tag.Text("precision"), tag) +
                      " must not exceed upper - lower; to fix the parameter, leave out all three");
}

Scalar ParameterReader::ReadScalar(const Tag& tag, std::string_view attribute) {
  const AttributeRule& rule = *FindAttribute(*tag.rule, attribute);
  const std::string text = tag.Text(attribute);
  if (text.find('$') != std::string::npos) return ReadReference(tag, rule, Trimmed(text));
  const std::optional<Quantity> quantity = ReadQuantity(tag, attribute, faults_);
  if (!quantity) return {};
  if (quantity->unit.dimension != rule.dimension) {
    faults_.Error(tag.Line(attribute),
                  Quoted(attribute, text, tag) + " " + DimensionFault(*quantity, text, rule.dimension));
    return {};
  }
  const Scalar scalar{.value = quantity->si};
  CheckSign(tag, rule, text, scalar);
  return scalar;
}

Scalar ParameterReader::ReadReference(const Tag& tag, const AttributeRule& rule, std::string_view text) {
  const auto fault = [&](const std::string& message) {
    faults_.Error(tag.Line(rule.name), Quoted(rule.name, std::string(text), tag) + " " + message);
    return Scalar();
  };
  const std::size_t dollar = text.find('$');
  const std::optional<double> factor = ParseFactor(Trimmed(text.substr(0, dollar)));
  if (!factor) return fault("must be a number with a unit, or a parameter as in \"$k\", \"-$k\" or \"0.5*$k\"");
  const std::string_view name = text.substr(dollar + 1);
  const auto found = index_.find(name);
  if (found == index_.end())
    return fault("refers to an unknown parameter '" + std::string(name) + "'" + DidYouMean(name, Names()));
  const Parameter& parameter = parameters_[static_cast<std::size_t>(found->second)];
  used_[static_cast<std::size_t>(found->second)] = true;
  if (!sound_[static_cast<std::size_t>(found->second)]) return {};
  if (parameter.dimension != rule.dimension)
    return fault("refers to " + WithArticle(parameter.dimension) + ": " + WithArticle(rule.dimension) + " is needed");
  const Scalar scalar{.value = *factor * parameter.value, .parameter = found->second, .factor = *factor};
  CheckSign(tag, rule, std::string(text), scalar);
  return scalar;
}

void ParameterReader::CheckSign(const Tag& tag, const AttributeRule& rule, const std::string& text,
                                const Scalar& scalar) const {
  if (Obeys(Least(scalar), rule.sign)) return;
  const std::string within = scalar.parameter < 0 ? "" : " over the whole range of the parameter";
  faults_.Error(tag.Line(rule.name), Quoted(rule.name, text, tag) + " " + SignDemand(rule.sign) + within);
}

std::optional<Scalar> ParameterReader::Bind(const Tag& bind, double literal, const Dimension& dimension) const {
  const std::string owner = AttributeText(*bind.element->Parent()->ToElement(), "name").value_or("");
  const auto found = index_.find(owner);
  const std::optional<double> factor = ParseNumber(Trimmed(bind.Text("factor")));
  if (found == index_.end() || !factor || !sound_[static_cast<std::size_t>(found->second)]) return std::nullopt;
  const Parameter& parameter = parameters_[static_cast<std::size_t>(found->second)];
  const Scalar scalar{.value = *factor * parameter.value, .parameter = found->second, .factor = *factor};
  const std::string fault = BindFault(scalar, parameter.dimension, literal, dimension);
  if (fault.empty()) return scalar;
  faults_.Error(bind.Line("to"), Quoted("to", bind.Text("to"), bind) + " " + fault);
  return std::nullopt;
}

std::string ParameterReader::BindFault(const Scalar& scalar, const Dimension& given, double literal,
                                       const Dimension& wanted) const {
  if (given != wanted) return "is " + WithArticle(wanted) + ", but the parameter is " + WithArticle(given);
  if (!Agrees(literal, scalar.value))
    return "is " + FormatNumber(literal) + " " + SiUnit(wanted) + " in the tree, but factor times value is " +
           FormatNumber(scalar.value) + " " + SiUnit(wanted) + ": make them equal";
  if (wanted == kMass && !Obeys(Least(scalar), Sign::kNotNegative))
    return SignDemand(Sign::kNotNegative) + " over the whole range of the parameter";
  return "";
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

void ParameterReader::CheckUse() const {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& parameter = parameters_[i];
    if (!used_[i])
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
