#include "identify/run/fitted_vehicle.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "analysis/files/csv_writer.h"
#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "analysis/text/utf8.h"

namespace fourpost {
namespace {

std::string InFileUnit(double value, const std::string& unit, int digits) {
  return ShortNumber(value / ParseUnit(unit.empty() ? "1" : unit)->si, digits) + (unit.empty() ? "" : " " + unit);
}

/// Empty where none was computed.
std::string DeviationNote(const FittedParameter& parameter) {
  switch (parameter.state) {
    case ParameterState::kNotComputed: return "";
    case ParameterState::kDetermined: return ", sd " + InFileUnit(parameter.sd, parameter.unit, 4);
    case ParameterState::kUndetermined: return ", not determined";
    case ParameterState::kAtBound: return ", at " + std::string(parameter.BoundName()) + " bound";
    case ParameterState::kNoise: return ", derivative is noise";
  }
  return "";
}

}  // namespace

Vehicle WithSources(const LoadedStudy& loaded, std::uint64_t seed, const FitResult& fit) {
  constexpr std::string_view kFitted = "fitted: ";
  Vehicle vehicle = loaded.vehicle;
  for (std::size_t i = 0; i < loaded.free.size(); ++i) {
    Parameter& parameter = vehicle.parameters[loaded.free[i]];
    const FittedParameter& fitted = fit.parameters[i];
    std::string source = std::string(kFitted) + ValidUtf8(loaded.study.file.filename().string()) + ", seed " +
                         std::to_string(seed) + DeviationNote(fitted) + "; was " +
                         InFileUnit(fitted.start, fitted.unit, 6);
    if (!parameter.source.starts_with(kFitted)) source += ", " + parameter.source;
    parameter.source = source;
    // The data are in the value now: known before them, they would count twice.
    parameter.prior_sd.reset();
    parameter.like.reset();
    for (Parameter& other : vehicle.parameters)
      if (other.like && other.like->parameter == parameter.name) other.like.reset();
  }
  return vehicle;
}

std::string ParametersCsv(const Vehicle& vehicle, const std::vector<FittedParameter>& parameters,
                          const std::string& confidence) {
  const auto finite = [](double number) { return std::isfinite(number) ? number : std::nan(""); };
  CsvWriter csv({"parameter", "unit", "start", "fitted", "difference_percent", "sd", "lower_95", "upper_95", "at_bound",
                 "source_of_start", "confidence_of_interval", "interval_cut_at"});
  for (const FittedParameter& p : parameters) {
    const auto told = std::find_if(vehicle.parameters.begin(), vehicle.parameters.end(),
                                   [&](const Parameter& parameter) { return parameter.name == p.name; });
    csv.Add(p.name).Add(SiUnit(p.dimension)).Add(p.start).Add(p.value);
    csv.Add(p.start != 0 ? 100 * (p.value - p.start) / p.start : std::nan(""));
    csv.Add(finite(p.sd)).Add(finite(p.lower_95)).Add(finite(p.upper_95));
    csv.Add(p.at_bound ? "yes" : "no").Add(told == vehicle.parameters.end() ? "" : told->source);
    csv.Add(std::isfinite(p.lower_95) ? confidence : "").Add(std::string(p.CutAt()));
  }
  return csv.text();
}

void CallStarts(const std::map<std::string, double>& starts, FitResult& fit) {
  for (FittedParameter& parameter : fit.parameters)
    if (const auto start = starts.find(parameter.name); start != starts.end()) parameter.start = start->second;
}

}  // namespace fourpost
