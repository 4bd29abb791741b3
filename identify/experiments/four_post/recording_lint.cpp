#include "identify/experiments/four_post/recording_lint.h"

#include <algorithm>
#include <optional>
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
  const auto told = std::find_if(plan.recordings.begin(), plan.recordings.end(),
                                 [&](const StudyRecording& other) { return other.name == recording; });
  return told == plan.recordings.end() ? 0 : told->line;
}

}  // namespace

std::vector<MeasuredRun> LintRuns(const RunLint& lint, const std::vector<MeasuredRun>& runs, Diagnostics& diagnostics) {
  const FourPostPlan& plan = lint.plan;
  const Vehicle& vehicle = lint.vehicle;
  ChannelWarnings warnings(plan.file, plan.channels, diagnostics);
  LintStations(vehicle, runs, warnings);
  // Of the others signs could not be told from the motion of the posts.
  std::vector<MeasuredRun> sure;
  for (const MeasuredRun& run : runs) {
    const std::optional<PatternFault> fault = PatternDoubt(vehicle, lint.model, run);
    if (!fault) sure.push_back(run);
    else if (fault->is_certain && lint.wrong_posts == Severity::kError)
      diagnostics.Error(plan.file, LineOfRecording(plan, run.name), fault->text);
    else diagnostics.Warning(plan.file, LineOfRecording(plan, run.name), fault->text);
  }
  const std::vector<MeasuredRun> in_band = InBand(sure, plan.band_lower_Hz, plan.band_upper_Hz);
  LintSigns(vehicle, in_band, ModelledResponses(lint.model, vehicle.sensors, in_band), warnings);
  return sure;
}

}  // namespace fourpost
