#include <fourpost/frf.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "analysis/measured_response/measured_response_files.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "identify/api/errors.h"
#include "identify/api/vectors.h"
#include "identify/inspection/measured_files.h"

namespace fourpost::api {
namespace {

/// In the order of ExcitationKind.
constexpr std::array<std::string_view, 4> kExcitations = {"stepped", "sweep", "random", "multisine"};

ExcitationKind ExcitationNamed(const std::string& name) {
  const auto found = std::find(kExcitations.begin(), kExcitations.end(), name);
  if (found == kExcitations.end()) RefuseName("kind of motion", name, {kExcitations.begin(), kExcitations.end()});
  return static_cast<ExcitationKind>(found - kExcitations.begin());
}

ResponseRequest RequestOf(const std::vector<std::filesystem::path>& files, const FrfOptions& options) {
  ResponseRequest request{.files = files, .reference = options.reference, .frequencies_Hz = options.frequency_Hz};
  if (files.empty()) throw std::invalid_argument("no file is given");
  RequireFinite("frequency_Hz", options.frequency_Hz);
  for (std::size_t i = 0; i < options.frequency_Hz.size(); ++i)
    if (!(options.frequency_Hz[i] > (i == 0 ? 0 : options.frequency_Hz[i - 1])))
      throw std::invalid_argument("frequencies must be above 0 Hz and rise");
  for (const auto& [post, channel] : options.posts) request.posts.push_back({channel, post});
  if (!options.kind.empty()) request.kind = ExcitationNamed(options.kind);
  if (options.filter) {
    if (options.filter->order < 1 || options.filter->order > 16 || !(options.filter->cutoff_Hz > 0))
      throw std::invalid_argument("the filter needs an order from 1 to 16 and a cut-off above 0 Hz");
    request.filter = AcquisitionFilter{options.filter->order, options.filter->cutoff_Hz};
  }
  for (const auto& [file, delay_s] : options.beside) {
    RequireFinite("the delay of " + file.string(), {&delay_s, 1});
    request.preparation.times.others.push_back({.path = file, .delay_s = delay_s});
  }
  return request;
}

MeasuredChannel MeasuredChannelOf(const fourpost::ChannelResponse& channel, const ChannelQuality& quality) {
  return {.name = channel.name,
          .unit = channel.unit,
          .frf = VectorOf(channel.response),
          .gain_sd = VectorOf(channel.gain_sd),
          .phase_sd_rad = VectorOf(channel.phase_sd_rad),
          .mean = VectorOf(channel.mean),
          .mean_sd = VectorOf(channel.mean_sd),
          .second_harmonic = VectorOf(channel.second_harmonic),
          .coherence = VectorOf(quality.coherence_at)};
}

/// A pattern by its name, or the shares of the posts.
std::string PostsOf(const MeasuredResponses& measured, const MeasuredResponse& response) {
  if (response.pattern) return *response.pattern;
  std::string shares;
  for (std::size_t p = 0; p < measured.posts.size(); ++p)
    shares += (p > 0 ? "," : "") + measured.posts[p] + "=" + FormatNumber(response.shares.share[p]);
  return shares;
}

MeasuredPattern MeasuredPatternOf(const MeasuredResponses& measured, const MeasuredResponse& response) {
  MeasuredPattern pattern{.name = response.name,
                          .posts = PostsOf(measured, response),
                          .reference = measured.posts[response.shares.reference],
                          .off_pattern = response.shares.rest,
                          .frequency_Hz = response.response.frequency_Hz,
                          .amplitude_m = response.response.amplitude_m,
                          .repeats = response.repeats};
  for (std::size_t c = 0; c < response.channels.size(); ++c)
    pattern.channels.push_back(MeasuredChannelOf(response.response.channels[c], response.channels[c]));
  return pattern;
}

}  // namespace

FrfMeasurement MeasureFrf(const std::vector<std::filesystem::path>& files, const FrfOptions& options) {
  return Guarded([&] {
    const ResponseRequest request = RequestOf(files, options);
    Diagnostics findings;
    RequireRecordings(request, findings);
    const bool is_written = !options.output.empty();
    if (is_written) RequireMeasuredFolder(request, options.output);
    const MeasuredResponses measured = MeasureFiles(request, findings);
    FrfMeasurement frfs{.kind = std::string(kExcitations[static_cast<std::size_t>(measured.kind)]),
                        .rate_Hz = measured.rate_Hz,
                        .duration_s = measured.duration_s,
                        .left_out = measured.left_out,
                        .json = MeasuredFilesJson(measured, findings),
                        .text = MeasuredText(measured),
                        .study_section = StudySection(measured),
                        .warnings = FindingsOf(findings)};
    for (const MeasuredResponse& response : measured.responses)
      frfs.patterns.push_back(MeasuredPatternOf(measured, response));
    if (is_written) WriteMeasured(options.output, frfs.json, measured);
    return frfs;
  });
}

}  // namespace fourpost::api
