#include "identify/report/run_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/text/diagnostics.h"
#include "analysis/text/units.h"
#include "identify/report/findings.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

bool FlagAt(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_boolean() && object[key].get<bool>();
}

/// Runs of older versions do not hold it; theirs have deviations at bounds, too.
ParameterState StateOf(const Json& parameter, bool has_covariance) {
  const std::string name = TextAt(parameter, "state");
  const auto found = std::find(kParameterStateNames.begin(), kParameterStateNames.end(), name);
  if (found != kParameterStateNames.end()) return static_cast<ParameterState>(found - kParameterStateNames.begin());
  if (!std::isnan(NumberAt(parameter, "sd"))) return ParameterState::kDetermined;
  return has_covariance ? ParameterState::kUndetermined : ParameterState::kNotComputed;
}

constexpr double kReach = 1.96;

/// Half the interval, even in the logarithm of a positive parameter; of one that a bound cuts by its deviation.
double HalfWidth(const ReportedParameter& parameter) {
  if (parameter.lower_95 <= parameter.lower || parameter.upper_95 >= parameter.upper) return kReach * parameter.sd;
  const auto place = [&](double value) { return parameter.lower > 0 ? parameter.value * std::log(value) : value; };
  return (place(parameter.upper_95) - place(parameter.lower_95)) / 2;
}

/// Runs of older versions hold no interval; theirs is that of a normal distribution.
void ReadInterval(const Json& parameter, double si, ReportedParameter& reported) {
  const std::vector<Json> interval = ListAt(parameter, "interval_95");
  reported.limited_by = TextAt(parameter, "limited_by");
  const Json parts = parameter.value("sd_parts", Json());
  reported.held_factor = reported.sd * si / std::hypot(NumberAt(parts, "noise"), NumberAt(parts, "model"));
  const bool is_told = interval.size() == 2 && interval[0].is_number() && interval[1].is_number();
  reported.lower_95 = is_told ? interval[0].get<double>() / si : reported.value - kReach * reported.sd;
  reported.upper_95 = is_told ? interval[1].get<double>() / si : reported.value + kReach * reported.sd;
  reported.noise_factor = HalfWidth(reported) / (kReach * NumberAt(parts, "noise") / si);
}

/// Row `i` of the correlations.
void FindPartner(const Json& correlations, std::size_t i, const std::vector<Json>& parameters,
                 ReportedParameter& reported) {
  if (!correlations.is_array() || i >= correlations.size() || correlations[i].size() != parameters.size()) return;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const Json& entry = correlations[i][j];
    if (j == i || !entry.is_number() || !(std::abs(entry.get<double>()) > std::abs(reported.correlation))) continue;
    reported.correlation = entry;
    reported.partner = TextAt(parameters[j], "name");
  }
}

constexpr const char* kResultName = "result.json";

[[noreturn]] void RefuseText(const std::string& text) {
  if (text.size() <= kLargestResult) Refuse(kResultNotJson, {kResultName});
  Refuse(kResultTooLarge, {kResultName}, {std::to_string(kLargestResult >> 20) + " MiB"});
}

}  // namespace

std::string UnitOf(const Json& parameter, const RunContents& run) {
  const std::string name = TextAt(parameter, "name");
  if (run.vehicle)
    for (const Parameter& known : run.vehicle->parameters)
      if (known.name == name && ParseUnit(known.unit)) return known.unit;
  return TextAt(parameter, "unit");
}

Json FitResultOf(const RunContents& run) {
  const auto file = run.files.find(kResultName);
  if (file == run.files.end()) Refuse(kResultMissing, {kResultName});
  Json result = ParseResult(file->second);
  if (result.is_discarded()) RefuseText(file->second);
  if (!result.is_object() || !result.contains("termination") || !result.contains("parameters"))
    Refuse(kResultNotOfFit, {kResultName});
  return result;
}

void RefuseResult(const std::string& file, const Json::exception& fault) {
  Refuse(kResultNotUnderstood, {file}, {fault.what()});
}

std::vector<ReportedParameter> ReportedParameters(const Json& result, const RunContents& run) {
  const Json identifiability = result.value("identifiability", Json());
  const Json correlations = identifiability.is_object() ? identifiability.value("correlation", Json()) : Json();
  const std::vector<Json> parameters = ListAt(result, "parameters");
  std::vector<ReportedParameter> list;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Json& parameter = parameters[i];
    ReportedParameter reported{.name = TextAt(parameter, "name"), .unit = UnitOf(parameter, run)};
    const std::optional<Unit> unit = ParseUnit(reported.unit);
    const double si = unit ? unit->si : 1;
    reported.value = NumberAt(parameter, "value") / si;
    reported.start = NumberAt(parameter, "start") / si;
    reported.lower = NumberAt(parameter, "lower") / si;
    reported.upper = NumberAt(parameter, "upper") / si;
    reported.state = StateOf(parameter, identifiability.is_object());
    reported.sd = NumberAt(parameter, "sd") / si;
    if (reported.state == ParameterState::kUndetermined && std::isnan(reported.sd))
      reported.sd = std::numeric_limits<double>::infinity();
    ReadInterval(parameter, si, reported);
    // Older versions called it so.
    if (reported.state == ParameterState::kDetermined &&
        (reported.RelativeSd() > kUndeterminedShare ||
         FillsBounds(reported.lower_95, reported.upper_95, reported.lower, reported.upper)))
      reported.state = ParameterState::kUndetermined;
    reported.at_bound = FlagAt(parameter, "at_bound");
    FindPartner(correlations, i, parameters, reported);
    list.push_back(std::move(reported));
  }
  return list;
}

std::vector<std::string> NamesIn(ParameterState state, const std::vector<ReportedParameter>& parameters) {
  std::vector<std::string> names;
  for (const ReportedParameter& parameter : parameters)
    if (parameter.state == state) names.push_back(parameter.name);
  return names;
}

std::string WhyNoDeviations(const std::vector<ReportedParameter>& parameters, const std::string& stated) {
  for (const ReportedParameter& parameter : parameters)
    if (parameter.IsJudged()) return "";
  if (parameters.empty()) return "";
  return stated.empty() ? "The run ended before standard deviations could be computed." : stated;
}

}  // namespace fourpost
