#include "vehicles/requests/parameter_setting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/text/known_names.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/description/moved_points.h"
#include "vehicles/requests/findings.h"

namespace fourpost {
namespace {

/// One option's text about a vehicle's parameters.
class SettingReader {
 public:
  SettingReader(const std::string& option, const Vehicle& vehicle, Diagnostics& diagnostics)
      : option_(option), vehicle_(vehicle), diagnostics_(diagnostics) {}

  bool faulty() const { return faulty_; }

  void Fault(const Finding& kind, const std::vector<std::string>& words) {
    faulty_ = true;
    diagnostics_.Report(kind, Place::Option(option_), words);
  }

  std::optional<std::size_t> Parameter(const std::string& name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < vehicle_.parameters.size(); ++i) {
      if (vehicle_.parameters[i].name == name) return i;
      names.push_back(vehicle_.parameters[i].name);
    }
    Fault(kOptionParameter, {name, KnownNames(name, names)});
    return std::nullopt;
  }

  double Value(std::size_t index, const std::string& text) {
    const fourpost::Parameter& parameter = vehicle_.parameters[index];
    const std::optional<Quantity> quantity = ParseQuantity(text);
    if (quantity && quantity->unit.dimension == parameter.dimension) return Judged(parameter, quantity->si);
    if (parameter.unit.empty()) Fault(kSettingNotANumber, {parameter.name, text});
    else Fault(kSettingUnit, {parameter.name, text, parameter.name + "=" + Example(text, parameter)});
    return parameter.value;
  }

 private:
  /// What may be meant: "20kN/m" of "20"; the file's value where the text is no number.
  static std::string Example(const std::string& text, const fourpost::Parameter& parameter) {
    std::string example = ParseNumber(text) ? text + parameter.unit : Shown(parameter.value, parameter);
    std::erase(example, ' ');
    return example;
  }

  static std::string Shown(double si, const fourpost::Parameter& parameter) {
    return FormatQuantity(si, parameter.unit);
  }

  double Judged(const fourpost::Parameter& parameter, double value) {
    const bool has_bounds = parameter.upper > parameter.lower;
    if (has_bounds && value >= parameter.lower && value <= parameter.upper) return value;
    if (const std::string side = MissedSideOfZero(parameter, value); !side.empty())
      Fault(kSettingSign, {parameter.name, Shown(value, parameter), side});
    else if (has_bounds)
      diagnostics_.Report(kSettingOutOfBounds, Place::Option(option_),
                          {parameter.name, Shown(value, parameter), Shown(parameter.lower, parameter),
                           Shown(parameter.upper, parameter)});
    return value;
  }

  const std::string& option_;
  const Vehicle& vehicle_;
  Diagnostics& diagnostics_;
  bool faulty_ = false;
};

std::vector<double> EqualSteps(double first, double last, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(std::lerp(first, last, static_cast<double>(i) / (count - 1)));
  return values;
}

std::vector<double> BoundToBound(const Parameter& parameter, SettingReader& reader) {
  constexpr int kCount = 25;
  if (!(parameter.upper > parameter.lower))
    reader.Fault(kRangeUnbounded,
                 {parameter.name, parameter.name + "=" + FormatQuantity(0.5 * parameter.value, parameter.unit) + ":" +
                                      FormatQuantity(2 * parameter.value, parameter.unit) + ":13"});
  return EqualSteps(parameter.lower, parameter.upper, kCount);
}

/// "20kN/m:80kN/m:13"
std::vector<double> Written(std::size_t index, const std::string& text, SettingReader& reader) {
  constexpr double kMost = 1000;
  const std::size_t first_colon = text.find(':');
  const std::size_t last_colon = text.rfind(':');
  const std::optional<double> count =
      last_colon == first_colon ? std::nullopt : ParseNumber(std::string_view(text).substr(last_colon + 1));
  if (!count || !(*count >= 2 && *count <= kMost && *count == std::floor(*count))) {
    reader.Fault(kRangeMalformed, {text});
    return {};
  }
  const double first = reader.Value(index, text.substr(0, first_colon));
  const double last = reader.Value(index, text.substr(first_colon + 1, last_colon - first_colon - 1));
  if (!reader.faulty() && first == last) reader.Fault(kRangeEmpty, {text});
  return EqualSteps(first, last, static_cast<int>(*count));
}

/// Of "name=..." the name: each may stand once.
void CheckOnce(const std::vector<std::string>& texts, const std::string& option, Diagnostics& diagnostics) {
  std::map<std::string, int> count;
  for (const std::string& text : texts) {
    const std::string name = text.substr(0, text.find('='));
    if (++count[name] == 2) diagnostics.Report(kOptionParameterTwice, Place::Option(option), {name});
  }
}

}  // namespace

std::string MissedSideOfZero(const Parameter& parameter, double value) {
  const bool has_bounds = parameter.lower < parameter.upper;
  if (value == parameter.value || (has_bounds && parameter.lower <= value && value <= parameter.upper)) return "";
  const bool is_zero = parameter.value == 0;
  const bool may_be_above = is_zero ? !has_bounds || parameter.upper > 0 : parameter.value > 0;
  const bool may_be_below = is_zero ? !has_bounds || parameter.lower < 0 : parameter.value < 0;
  if ((value > 0 && may_be_above) || (value < 0 && may_be_below)) return "";
  return may_be_above ? "above" : "below";
}

void SetParameter(const std::string& text, const std::string& option, Vehicle& vehicle, Diagnostics& diagnostics) {
  SettingReader reader(option, vehicle, diagnostics);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    reader.Fault(kSettingIncomplete, {text});
    return;
  }
  const std::optional<std::size_t> index = reader.Parameter(text.substr(0, equals));
  if (!index) return;
  vehicle.parameters[*index].value = reader.Value(*index, text.substr(equals + 1));
  vehicle = WithPointsAt(std::move(vehicle), vehicle.ParameterValues());
}

std::optional<ParameterRange> ReadParameterRange(const std::string& text, const std::string& option,
                                                 const Vehicle& vehicle, Diagnostics& diagnostics) {
  SettingReader reader(option, vehicle, diagnostics);
  const std::size_t equals = text.find('=');
  const std::optional<std::size_t> index = reader.Parameter(text.substr(0, equals));
  if (!index) return std::nullopt;
  std::vector<double> values = equals == std::string::npos ? BoundToBound(vehicle.parameters[*index], reader)
                                                           : Written(*index, text.substr(equals + 1), reader);
  if (reader.faulty()) return std::nullopt;
  return ParameterRange{*index, std::move(values)};
}

void SetParameters(const std::vector<std::string>& texts, Vehicle& vehicle, Diagnostics& diagnostics) {
  CheckOnce(texts, "--set", diagnostics);
  for (const std::string& text : texts) SetParameter(text, "--set", vehicle, diagnostics);
}

std::vector<ParameterRange> ReadParameterRanges(const std::vector<std::string>& texts, const Vehicle& vehicle,
                                                Diagnostics& diagnostics) {
  CheckOnce(texts, "--vary", diagnostics);
  std::vector<ParameterRange> ranges;
  for (const std::string& text : texts)
    if (std::optional<ParameterRange> range = ReadParameterRange(text, "--vary", vehicle, diagnostics))
      ranges.push_back(std::move(*range));
  return ranges;
}

}  // namespace fourpost
