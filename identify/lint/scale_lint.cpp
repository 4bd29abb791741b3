#include "identify/lint/scale_lint.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "analysis/units.h"

namespace fourpost {
namespace {

template <typename Channels>
bool HasForce(const Channels& channels) {
  return std::any_of(channels.begin(), channels.end(),
                     [](const auto& channel) { return ParseUnit(channel.unit)->dimension == kForce; });
}

/// Any of its data or priors tells it.
bool IsTold(const LoadedStudy& study) {
  const auto& [runs, loads] = study.data;
  return study.bench || !loads.empty() ||
         std::any_of(runs.begin(), runs.end(), [](const MeasuredRun& run) { return HasForce(run.channels); }) ||
         std::any_of(study.histories.begin(), study.histories.end(),
                     [](const MeasuredHistory& history) { return HasForce(history.signals); }) ||
         std::any_of(study.free.begin(), study.free.end(), [&](std::size_t index) {
           const Parameter& parameter = study.vehicle.parameters[index];
           return parameter.prior_sd && parameter.dimension.kilogram != 0;
         });
}

/// "m_wheel, I_body and 3 more"; empty for none.
std::string Held(const LoadedStudy& study) {
  constexpr std::size_t kMost = 4;
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < study.vehicle.parameters.size(); ++i) {
    const Parameter& parameter = study.vehicle.parameters[i];
    const bool is_free = std::find(study.free.begin(), study.free.end(), i) != study.free.end();
    if (is_free || parameter.dimension.kilogram == 0) continue;
    if (++count <= kMost) text += (text.empty() ? "" : ", ") + parameter.name;
  }
  return count > kMost ? text + " and " + std::to_string(count - kMost) + " more" : text;
}

}  // namespace

void LintScale(const LoadedStudy& study, Diagnostics& diagnostics) {
  const bool has_scale = std::any_of(study.free.begin(), study.free.end(), [&](std::size_t index) {
    return study.vehicle.parameters[index].dimension.kilogram != 0;
  });
  if (!has_scale || IsTold(study)) return;
  const std::string held = Held(study);
  diagnostics.Warning(study.study.file.string(), study.study.free_line,
                      "no force or load is fitted, so masses, rates and dampings are told up to a common factor, "
                      "which rests on what is held (" +
                          (held.empty() ? "numbers of the vehicle file, if any" : held) + ")" +
                          ": 1 % there is 1 % in all of them, and in no deviation; fit a tyre force or `static_loads`, "
                          "or make sure of what is held");
}

}  // namespace fourpost
