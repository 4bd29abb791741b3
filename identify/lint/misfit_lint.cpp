#include "identify/lint/misfit_lint.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "analysis/short_number.h"
#include "identify/four_post_residuals.h"
#include "identify/lint/channel_warnings.h"
#include "identify/modelled_response.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

/// Standard deviations. A load is so far off once in 16 000 of normal errors; a channel, of which it is the root mean
/// square, all but never.
constexpr double kFarOff = 4;

/// Names, and what is to be said of each.
using Findings = std::map<std::string, std::string>;

std::string MassesAtBounds(const FitResult& fit) {
  std::string names;
  for (const FittedParameter& parameter : fit.parameters)
    if (parameter.at_bound && parameter.dimension == kMass) names += (names.empty() ? "" : ", ") + parameter.name;
  return names.empty() ? "" : " that hold masses (" + names + ")";
}

/// All in one, at the line of the first.
void Warn(const LoadedStudy& study, const ChannelWarnings::Channels& channels, const Findings& findings,
          const std::string& causes, Diagnostics& diagnostics) {
  if (findings.empty()) return;
  std::string message;
  for (const auto& [name, finding] : findings) message += (message.empty() ? "" : ", '" + name + "' ") + finding;
  ChannelWarnings(study.study.file.string(), channels, diagnostics).Add(findings.begin()->first, message + causes);
}

void LintLoads(const LoadedStudy& study, const FitResult& fit, const CondensedModel& model, Diagnostics& diagnostics) {
  Findings found;
  for (const MeasuredLoad& load : study.data.static_loads) {
    const double modelled = model.preloads.tyre[load.tyre];
    const double off = std::abs(modelled - load.load_N) / load.sd_N;
    if (off > kFarOff)
      found[study.vehicle.tyres[load.tyre].name] = "carries " + ShortNumber(modelled, 4) + " N for the measured " +
                                                   ShortNumber(load.load_N, 4) + " N (" + ShortNumber(off, 2) +
                                                   " standard deviations off)";
  }
  Warn(study, study.study.static_loads, found,
       ", at rest after the fit: a load cell not tared, a wheelpan or a load weighed along, bounds" +
           MassesAtBounds(fit) +
           " that leave the answer out, an sd that is too small, or other channels that pull the masses away for what "
           "the model lacks",
       diagnostics);
}

void LintChannels(const LoadedStudy& study, const CondensedModel& model, Diagnostics& diagnostics) {
  const std::vector<MeasuredRun> runs = InBand(study.data.runs, study.study.band_lower_Hz, study.study.band_upper_Hz);
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, study.vehicle.sensors, runs);
  Findings found;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<double> off = ResponseDeviations(runs[r], modelled[r], study.study.model_error);
    for (std::size_t c = 0; c < off.size(); ++c) {
      if (!(off[c] > kFarOff)) continue;
      std::string& where = found[runs[r].channels[c].name];
      where += (where.empty() ? "is off " : " and ") + ("in '" + runs[r].name + "' by " + ShortNumber(off[c], 2));
    }
  }
  Warn(
      study, study.study.channels, found,
      " times what noise and the stated model error explain: check sign, scale, delay and station, and that it is that "
      "channel; else the model lacks what it shows",
      diagnostics);
}

}  // namespace

void LintMisfits(const LoadedStudy& study, const FitResult& fit, Diagnostics& diagnostics) {
  if (fit.values.empty() || (study.data.runs.empty() && study.data.static_loads.empty())) return;
  const CondensedModel model = CondensedVehicle(study.vehicle).At(fit.values);
  LintLoads(study, fit, model, diagnostics);
  LintChannels(study, model, diagnostics);
}

}  // namespace fourpost
