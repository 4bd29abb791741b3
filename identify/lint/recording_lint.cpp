#include "identify/lint/recording_lint.h"

#include <vector>

#include "identify/lint/channel_warnings.h"
#include "identify/lint/sign_lint.h"
#include "identify/lint/station_lint.h"
#include "identify/lint/weight_lint.h"
#include "identify/lint/wheelpan_lint.h"
#include "identify/modelled_response.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

void LintRecordings(const LoadedStudy& study, Diagnostics& diagnostics) {
  if (study.data.runs.empty() && study.data.static_loads.empty()) return;
  ChannelWarnings warnings(study.study.file.string(), study.study.channels, diagnostics);
  const CondensedVehicle condensed(study.vehicle);
  LintWeights(study, condensed, diagnostics);
  LintStations(study.vehicle, study.data.runs, warnings);
  const CondensedModel model = condensed.At(study.vehicle.ParameterValues());
  LintWheelpans(study.vehicle, study.data.runs, ModelledResponses(model, study.vehicle.sensors, study.data.runs),
                warnings);
  const std::vector<MeasuredRun> runs = InBand(study.data.runs, study.study.band_lower_Hz, study.study.band_upper_Hz);
  LintSigns(study.vehicle, runs, ModelledResponses(model, study.vehicle.sensors, runs), warnings);
}

}  // namespace fourpost
