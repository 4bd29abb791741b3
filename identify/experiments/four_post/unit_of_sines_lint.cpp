#include "identify/experiments/four_post/unit_of_sines_lint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "analysis/measured_response/plausible_amplitude.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/study_recording.h"
#include "identify/study_file/channel_source_text.h"
#include "identify/study_file/thousandfold.h"

namespace fourpost {
namespace {

void ReportWith(Severity severity, const Finding& finding, const Place& place, const std::vector<std::string>& words,
                Diagnostics& diagnostics) {
  if (severity == Severity::kError) diagnostics.Report(finding, place, words);
  else diagnostics.ReportAsWarning(finding, place, words);
}

const StudyRecording* StatedAs(const FourPostPlan& plan, const std::string& name) {
  const auto found = std::find_if(plan.recordings.begin(), plan.recordings.end(),
                                  [&](const StudyRecording& one) { return one.name == name; });
  return found == plan.recordings.end() ? nullptr : &*found;
}

void AddFilesOf(const StudyRecording& stated, std::vector<std::filesystem::path>& files) {
  files.push_back(stated.file);
  for (const OtherFile& other : stated.preparation.others) files.push_back(other.path);
}

/// What to write where the amplitude is a thousand times too large, `direction` 1, or too small.
std::string AmplitudeRemedy(const StudyRecording* stated, double amplitude_m, int direction) {
  const std::string millimetres = ShortNumber(1e3 * amplitude_m * (direction > 0 ? 1e-3 : 1e3), 3) + " mm";
  if (stated == nullptr) return "amplitudes in m";
  if (stated->amplitude_m) return "amplitude: " + millimetres;
  if (!IsOverTime(*stated))
    return "post_amplitude_m in m, from rest to peak, into the table (here perhaps " + millimetres + ")";
  std::vector<std::filesystem::path> files;
  AddFilesOf(*stated, files);
  std::string line;
  for (std::size_t p = 0; p < stated->post_channels.size(); ++p)
    line += (line.empty() ? "post_channels: {" : ", ") + stated->post_channels[p].post + ": " +
            SourceText(WithUnitMeant({.channels = {stated->post_sources[p]}}, direction, files));
  return line.empty() ? "post_channels: {POST: {channel: NAME, unit: " + std::string(direction > 0 ? "mm" : "m") + "}}"
                      : line + "}";
}

/// A table of responses takes no unit from the study, but a scale.
ChannelSource SourceMeant(const FourPostPlan& plan, ChannelSource source, int direction) {
  std::vector<std::filesystem::path> files;
  for (const StudyRecording& recording : plan.Stated()) AddFilesOf(recording, files);
  if (std::all_of(plan.Stated().begin(), plan.Stated().end(), IsOverTime))
    return WithUnitMeant(std::move(source), direction, files);
  for (SourceChannel& channel : source.channels) channel.factor *= direction > 0 ? 1e-3 : 1e3;
  return source;
}

double SumOfSquares(const std::vector<std::complex<double>>& values, const std::vector<std::complex<double>>& other) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(other[i].real()) && std::isfinite(values[i].real())) sum += std::norm(values[i]);
  return sum;
}

}  // namespace

bool LintAmplitudes(const FourPostPlan& plan, const std::vector<MeasuredRun>& runs, Severity severity,
                    Diagnostics& diagnostics) {
  bool good = true;
  for (const MeasuredRun& run : runs) {
    const std::vector<double>& amplitudes = run.excitation.amplitude_m;
    const double most =
        amplitudes.empty() ? kLeastAmplitude_m : *std::max_element(amplitudes.begin(), amplitudes.end());
    if (most >= kLeastAmplitude_m && most <= kMostAmplitude_m) continue;
    const bool is_sure = most > kMostAmplitude_m || most < kSurelyNoAmplitude_m;
    good = good && !is_sure;
    const StudyRecording* const stated = StatedAs(plan, run.name);
    ReportWith(is_sure ? severity : Severity::kWarning, kRigAmplitude,
               {.file = plan.file, .line = stated == nullptr ? 0 : stated->line},
               {run.name, ShortNumber(1e3 * most, 3), AmplitudeRemedy(stated, most, most > kMostAmplitude_m ? 1 : -1)},
               diagnostics);
  }
  return good;
}

void LintSineUnits(const FourPostPlan& plan, const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, Severity severity, Diagnostics& diagnostics) {
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    double measured = 0;
    double model = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (const MeasuredChannel& channel : runs[r].channels) {
        if (channel.sensor != s || channel.has_opposed_members) continue;
        const std::vector<std::complex<double>>& of_model = modelled[r].channels[s].response;
        measured += SumOfSquares(channel.response, of_model);
        model += SumOfSquares(of_model, channel.response);
      }
    const double ratio = model > 0 ? std::sqrt(measured / model) : 1;
    const int direction = ThousandfoldOf(ratio);
    const std::string& name = vehicle.sensors[s].name;
    const auto source =
        std::find_if(plan.channels.begin(), plan.channels.end(), [&](const auto& one) { return one.first == name; });
    if (direction == 0 || source == plan.channels.end()) continue;
    ReportWith(severity, kSineThousandfold, {.file = plan.file, .line = source->second.line},
               {name, ShortNumber(ratio, 2), name + ": " + SourceText(SourceMeant(plan, source->second, direction))},
               diagnostics);
  }
}

}  // namespace fourpost
