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

/// Once in 16 000 of normal errors.
constexpr double kFarOff = 4;

std::string MassesAtBounds(const FitResult& fit) {
  std::string names;
  for (const FittedParameter& parameter : fit.parameters)
    if (parameter.at_bound && parameter.dimension == kMass) names += (names.empty() ? "" : ", ") + parameter.name;
  return names.empty() ? "" : " that hold masses (" + names + ")";
}

void LintLoads(const LoadedStudy& study, const FitResult& fit, const CondensedModel& model, Diagnostics& diagnostics) {
  ChannelWarnings warnings(study.study.file.string(), study.study.static_loads, diagnostics);
  for (const MeasuredLoad& load : study.data.static_loads) {
    const double modelled = model.preloads.tyre[load.tyre];
    const double off = std::abs(modelled - load.load_N) / load.sd_N;
    if (!(off > kFarOff)) continue;
    warnings.Add(study.vehicle.tyres[load.tyre].name,
                 "carries " + ShortNumber(modelled, 4) + " N at rest after the fit, measured are " +
                     ShortNumber(load.load_N, 4) + " N, " + ShortNumber(off, 2) +
                     " of its standard deviations off: a load cell not tared, a wheelpan or a load weighed along, "
                     "bounds" +
                     MassesAtBounds(fit) +
                     " that leave the answer out, an sd that is too small, or other channels that pull the masses away "
                     "for what the model lacks");
  }
}

void LintChannels(const LoadedStudy& study, const CondensedModel& model, Diagnostics& diagnostics) {
  ChannelWarnings warnings(study.study.file.string(), study.study.channels, diagnostics);
  const std::vector<MeasuredRun> runs = InBand(study.data.runs, study.study.band_lower_Hz, study.study.band_upper_Hz);
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, study.vehicle.sensors, runs);
  std::map<std::string, std::string> found;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<double> off = ResponseDeviations(runs[r], modelled[r], study.study.model_error);
    for (std::size_t c = 0; c < off.size(); ++c) {
      if (!(off[c] > kFarOff)) continue;
      std::string& where = found[runs[r].channels[c].name];
      where += (where.empty() ? "" : " and ") + ("in '" + runs[r].name + "' by " + ShortNumber(off[c], 2));
    }
  }
  for (const auto& [channel, where] : found)
    warnings.Add(channel, "is off " + where +
                              " times what noise and the stated model error explain: check its sign, scale, delay and "
                              "station, and that it is that channel; else the model lacks what it shows");
}

}  // namespace

void LintMisfits(const LoadedStudy& study, const FitResult& fit, Diagnostics& diagnostics) {
  if (fit.values.empty() || (study.data.runs.empty() && study.data.static_loads.empty())) return;
  const CondensedModel model = CondensedVehicle(study.vehicle).At(fit.values);
  LintLoads(study, fit, model, diagnostics);
  LintChannels(study, model, diagnostics);
}

}  // namespace fourpost
