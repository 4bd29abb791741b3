#include "identify/lint/recording_lint.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "identify/lint/channel_warnings.h"
#include "identify/lint/pattern_lint.h"
#include "identify/lint/scale_lint.h"
#include "identify/lint/sign_lint.h"
#include "identify/lint/station_lint.h"
#include "identify/lint/weight_lint.h"
#include "identify/lint/wheelpan_lint.h"
#include "identify/modelled_response.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

int LineOf(const Study& study, const std::string& recording) {
  const auto told = std::find_if(study.recordings.begin(), study.recordings.end(),
                                 [&](const StudyRecording& other) { return other.name == recording; });
  return told == study.recordings.end() ? 0 : told->line;
}

}  // namespace

std::vector<MeasuredRun> LintRuns(const RunLint& lint, const std::vector<MeasuredRun>& runs, Diagnostics& diagnostics) {
  const Study& study = lint.study;
  const Vehicle& vehicle = lint.vehicle;
  ChannelWarnings warnings(study.file.string(), study.channels, diagnostics);
  LintStations(vehicle, runs, warnings);
  // Of the others signs could not be told from the motion of the posts.
  std::vector<MeasuredRun> sure;
  for (const MeasuredRun& run : runs) {
    const std::optional<PatternFault> fault = PatternDoubt(vehicle, lint.model, run);
    if (!fault) sure.push_back(run);
    else if (fault->is_certain && lint.wrong_posts == Severity::kError)
      diagnostics.Error(study.file.string(), LineOf(study, run.name), fault->text);
    else diagnostics.Warning(study.file.string(), LineOf(study, run.name), fault->text);
  }
  const std::vector<MeasuredRun> in_band = InBand(sure, study.band_lower_Hz, study.band_upper_Hz);
  LintSigns(vehicle, in_band, ModelledResponses(lint.model, vehicle.sensors, in_band), warnings);
  return sure;
}

void LintRecordings(const LoadedStudy& study, Diagnostics& diagnostics, Severity wrong_posts) {
  LintScale(study, diagnostics);
  if (study.data.runs.empty() && study.data.static_loads.empty()) return;
  const CondensedVehicle condensed(study.vehicle);
  LintWeights(study, condensed, diagnostics);
  const CondensedModel model = condensed.At(study.vehicle.ParameterValues());
  const std::vector<MeasuredRun> runs =
      LintRuns({study.study, study.vehicle, model, wrong_posts}, study.data.runs, diagnostics);
  ChannelWarnings warnings(study.study.file.string(), study.study.channels, diagnostics);
  LintWheelpans(study.vehicle, runs, ModelledResponses(model, study.vehicle.sensors, runs), warnings);
}

}  // namespace fourpost
