#include "identify/experiments/four_post/recording_lint.h"

#include <algorithm>
#include <string>
#include <utility>

#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/pattern_lint.h"
#include "identify/experiments/four_post/sign_lint.h"
#include "identify/experiments/four_post/station_lint.h"
#include "identify/study_file/channel_warnings.h"

namespace fourpost {
namespace {

int LineOfRecording(const FourPostPlan& plan, const std::string& recording) {
  const auto stated = std::find_if(plan.recordings.begin(), plan.recordings.end(),
                                   [&](const StudyRecording& other) { return other.name == recording; });
  return stated == plan.recordings.end() ? 0 : stated->line;
}

}  // namespace

std::vector<MeasuredRun> LintRuns(const RunLint& lint, const std::vector<MeasuredRun>& runs, Diagnostics& diagnostics) {
  const FourPostPlan& plan = lint.plan;
  const Vehicle& vehicle = lint.vehicle;
  ChannelWarnings warnings(plan.file, plan.channels, diagnostics);
  LintStations(vehicle, runs, warnings);
  // In the others a wrong sign and a wrong motion of the posts look alike.
  std::vector<MeasuredRun> sure;
  for (const MeasuredRun& run : runs) {
    const Found doubt = PatternDoubt(vehicle, lint.model, run);
    const Place place{.file = plan.file, .line = LineOfRecording(plan, run.name)};
    if (!doubt) sure.push_back(run);
    else if (lint.wrong_posts == Severity::kError) diagnostics.Report(*doubt.kind, place, doubt.words);
    else diagnostics.ReportAsWarning(*doubt.kind, place, doubt.words);
  }
  const std::vector<MeasuredRun> in_band = InBand(sure, plan.band_lower_Hz, plan.band_upper_Hz);
  LintSigns(vehicle, in_band, ModelledResponses(lint.model, vehicle.sensors, in_band), warnings);
  return sure;
}

}  // namespace fourpost
