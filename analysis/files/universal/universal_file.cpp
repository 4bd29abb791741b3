#include "analysis/files/universal/universal_file.h"

#include <algorithm>

#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/unique_names.h"
#include "analysis/files/universal/findings.h"
#include "analysis/files/universal/universal_index.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

/// Of times as stored.
double SecondsOf(const UniversalAxis& abscissa) {
  const std::optional<Unit> unit = ParseUnit(abscissa.unit);
  return unit && unit->dimension == kTime ? unit->si : 1;
}

/// The ID lines that say something, unless it is the name alone.
std::string IdOf(const UniversalFunction& function) {
  std::string text;
  for (const std::string& line : function.id)
    if (!line.empty() && line != "NONE") text += (text.empty() ? "" : "; ") + line;
  return text == NameOf(function) ? "" : text;
}

std::string TypesOf(const std::vector<UniversalFunction>& functions) {
  std::string types;
  for (const UniversalFunction& function : functions) {
    const std::string type = "function of type " + std::to_string(function.type);
    if (types.find(type) == std::string::npos) types += (types.empty() ? "" : ", ") + type;
  }
  return types;
}

}  // namespace

std::string NameOf(const UniversalFunction& function) {
  if (!function.response.entity.empty()) return function.response.entity;
  if (function.response.node > 0) return function.response.Text();
  return function.ordinate.label.empty() ? function.id[0] : function.ordinate.label;
}

UniversalFile::UniversalFile(const std::filesystem::path& file) : bytes_(file, "universal") {
  UniversalIndex index = ReadUniversalIndex(bytes_);
  std::vector<UniversalFunction> others;
  for (UniversalFunction& function : index.functions)
    (function.IsOverTime()            ? histories_
     : function.IsFrequencyResponse() ? responses_
                                      : others)
        .push_back(std::move(function));
  if (histories_.empty() && responses_.empty()) {
    const std::string types = TypesOf(others);
    throw RecordingFault(kUniversalNothing, {types.empty() ? index.others.empty() ? "none" : index.others : types});
  }
  if (!histories_.empty()) std::move(responses_.begin(), responses_.end(), std::back_inserter(others));
  if (!histories_.empty()) responses_.clear();
  if (!others.empty()) remarks_.push_back({&kChannelsLeftOut, {TypesOf(others)}});
  header_ = {.format = "UFF", .description = std::move(index.description)};
  for (const UniversalFunction& function : histories_) {
    RecordingChannel channel = {.name = NameOf(function),
                                .unit = function.ordinate.unit,
                                .point = function.response.Text(),
                                .description = IdOf(function),
                                .samples = function.samples};
    const double second = SecondsOf(function.abscissa);
    channel.start_s = function.start * second;
    if (!function.is_even) channel.clock = header_.channels.size();
    else if (function.step > 0) channel.step_s = function.step * second;
    header_.channels.push_back(std::move(channel));
  }
  MakeNamesUnique(header_);
}

std::vector<double> UniversalFile::Values(std::size_t channel) const {
  const UniversalFunction& function = histories_[channel];
  const UniversalNumbers numbers = Numbers(function);
  std::vector<double> values;
  values.reserve(numbers.values.size());
  for (const std::complex<double>& value : numbers.values) values.push_back(value.real() * function.ordinate.factor);
  return values;
}

std::vector<double> UniversalFile::ClockTimes(std::size_t channel) const {
  std::vector<double> times = Numbers(histories_[channel]).abscissa;
  for (double& time : times) time *= SecondsOf(histories_[channel].abscissa);
  return times;
}

}  // namespace fourpost
