#include "analysis/measured_response/response_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/measured_response/findings.h"
#include "analysis/signals/low_pass.h"
#include "analysis/signals/median.h"
#include "analysis/text/named.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Accelerations per acceleration are made such per displacement.
Complex ByReference(Complex response, const std::string& unit, double frequency_Hz) {
  const double w = 2 * std::numbers::pi * frequency_Hz;
  return unit == "m/s^2" ? response / (-w * w) : response;
}

}  // namespace

void AddResponse(Complex response, double variance, double frequency_Hz, ChannelResponse& channel) {
  const Complex by_reference = ByReference(response, channel.unit, frequency_Hz);
  const double scale = std::abs(by_reference) / std::abs(response);
  channel.response.push_back(by_reference);
  // Noise is as large along the phasor as across it.
  channel.gain_sd.push_back(std::sqrt(variance / 2) * scale);
  channel.phase_sd_rad.push_back(std::sqrt(variance / 2) / std::abs(response));
}

double MedianDeviation(const ChannelResponse& channel) {
  return channel.phase_sd_rad.empty() ? kNaN : Median(channel.phase_sd_rad);
}

ChannelQuality QualityOf(const ChannelResponse& channel) {
  return {.name = channel.name,
          .distortion = kNaN,
          .distortion_Hz = kNaN,
          .coherence = kNaN,
          .coherence_Hz = kNaN,
          .noise = kNaN,
          .deviation = MedianDeviation(channel)};
}

void ResponseWork::Fault(const Finding& finding, const std::filesystem::path& file,
                         const std::vector<std::string>& words) {
  diagnostics.Report(finding, {file.string()}, words);
}

double ResponseWork::Passed(double frequency_Hz) const {
  if (!request.filter) return 1;
  // Where the filter leaves next to nothing, its inverse would raise noise.
  constexpr double kLeast = 0.02;
  const LowPass filter(request.filter->order, request.filter->cutoff_Hz, out.rate_Hz);
  return std::max(kLeast, std::abs(filter.Response(std::min(0.49, frequency_Hz / out.rate_Hz))));
}

MeasuredResponse ResponseWork::Blank(const PostShares& shares) const {
  MeasuredResponse blank{.name = {}, .shares = shares, .pattern = PatternOf(shares, out.posts), .response = {}};
  for (std::size_t c = 0; c < names.size(); ++c) {
    ChannelResponse& channel = blank.response.channels.emplace_back();
    channel.name = names[c];
    channel.unit = units[c];
  }
  return blank;
}

std::string ResponseWork::NameFor(const MeasuredResponse& response) const {
  const std::string base = response.pattern.value_or("posts");
  std::string name = base;
  for (int number = 2; IndexOf(name, NamesOf(out.responses)); ++number) name = base + "_" + std::to_string(number);
  return name;
}

void ResponseWork::CheckPosts(double rest, const MeasuredResponse& response) {
  constexpr double kOff = 0.1;
  if (rest > kOff)
    Fault(kResponsePostsOff, request.files.front(),
          {Rounded(100 * rest, 2), response.name, response.pattern.value_or("found")});
}

}  // namespace fourpost
