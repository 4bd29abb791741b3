#include "analysis/measured_response/spectral_responses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/frequency_response/local_response.h"
#include "analysis/frequency_response/multisine.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/moved_band.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/median.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Products of posts over time, each about its mean.
std::vector<std::vector<Complex>> ProductsOf(const std::vector<std::vector<double>>& heights) {
  std::vector<double> means;
  for (const std::vector<double>& height : heights) means.push_back(Mean(height));
  std::vector<std::vector<Complex>> products(heights.size(), std::vector<Complex>(heights.size()));
  for (std::size_t a = 0; a < heights.size(); ++a)
    for (std::size_t b = a; b < heights.size(); ++b) {
      double sum = 0;
      for (std::size_t k = 0; k < heights[a].size(); ++k)
        sum += (heights[a][k] - means[a]) * (heights[b][k] - means[b]);
      products[a][b] = products[b][a] = sum;
    }
  return products;
}

/// The motion of all posts that the shares describe.
std::vector<double> MotionOf(const std::vector<std::vector<double>>& heights, const PostShares& shares) {
  double square = 0;
  for (const double share : shares.share) square += share * share;
  std::vector<double> motion(heights.front().size(), 0.0);
  for (std::size_t p = 0; p < heights.size(); ++p)
    for (std::size_t k = 0; k < motion.size(); ++k) motion[k] += shares.share[p] / square * heights[p][k];
  return motion;
}

std::vector<double> FrequenciesOf(const LookedAt& looked, const std::vector<double>& motion) {
  const double rate_Hz = looked.recording.rate_Hz;
  return looked.kind == ExcitationKind::kSweep ? SweptFrequencies(looked.track, rate_Hz, looked.recording.duration_s())
                                               : MovedFrequencies(motion, rate_Hz);
}

/// Another file of the same motion: weighted by the inverse of variances.
void Join(const MeasuredResponse& part, MeasuredResponse& whole) {
  for (std::size_t c = 0; c < whole.response.channels.size(); ++c) {
    ChannelResponse& sum = whole.response.channels[c];
    const ChannelResponse& more = part.response.channels[c];
    for (std::size_t i = 0; i < sum.response.size(); ++i) {
      const double own = 1 / std::pow(sum.gain_sd[i], 2);
      const double added = 1 / std::pow(more.gain_sd[i], 2);
      sum.response[i] = (own * sum.response[i] + added * more.response[i]) / (own + added);
      sum.gain_sd[i] = 1 / std::sqrt(own + added);
      sum.phase_sd_rad[i] = sum.gain_sd[i] / std::abs(sum.response[i]);
    }
    ChannelQuality& quality = whole.channels[c];
    quality.deviation = MedianDeviation(sum);
    if (part.channels[c].coherence < quality.coherence) {
      quality.coherence = part.channels[c].coherence;
      quality.coherence_Hz = part.channels[c].coherence_Hz;
    }
  }
}

}  // namespace

void SpectralResponses::Add(const LookedAt& looked) {
  const std::vector<std::vector<double>>& heights = looked.recording.heights;
  const PostShares shares = SharesOf(ProductsOf(heights), work_.reference);
  constexpr double kApart = 0.4;
  if (shares.rest > kApart) {
    work_.Fault(kResponsePostsApart, looked.file, {Rounded(100 * shares.rest, 2)});
    return;
  }
  MeasuredResponse out = work_.Blank(shares);
  const std::vector<double> motion = MotionOf(heights, out.shares);
  const bool is_made =
      looked.kind == ExcitationKind::kMultisine ? AddMultisine(looked, motion, out) : AddLocal(looked, motion, out);
  if (is_made) parts_.push_back(std::move(out));
}

bool SpectralResponses::AddLocal(const LookedAt& looked, const std::vector<double>& motion, MeasuredResponse& out) {
  const RigRecording& recording = looked.recording;
  const std::vector<double> frequencies =
      work_.request.frequencies_Hz.empty()
          ? (parts_.empty() ? FrequenciesOf(looked, motion) : parts_.front().response.frequency_Hz)
          : work_.request.frequencies_Hz;
  // Thirteen lines above zero.
  const double least_Hz = frequencies.empty() ? 1 / recording.duration_s() : frequencies.front();
  if (frequencies.empty() || 14 / recording.duration_s() > 2 * least_Hz ||
      frequencies.back() + 14 / recording.duration_s() > 0.45 * recording.rate_Hz) {
    work_.Fault(kResponseTooShort, looked.file, {Rounded(recording.duration_s(), 3), Rounded(least_Hz, 3)});
    return false;
  }
  const std::vector<LocalResponse> responses =
      LocalResponses(motion, recording.Signals().channels, recording.rate_Hz, frequencies);
  work_.out.least_averages = std::numeric_limits<double>::infinity();
  for (const LocalResponse& at : responses) {
    work_.out.least_averages = std::min(work_.out.least_averages, at.averages);
    work_.out.most_averages = std::max(work_.out.most_averages, at.averages);
    out.response.frequency_Hz.push_back(at.frequency_Hz);
    out.response.amplitude_m.push_back(looked.kind == ExcitationKind::kSweep
                                           ? SweptAmplitude(looked.track, at.frequency_Hz / recording.rate_Hz) /
                                                 work_.Passed(at.frequency_Hz)
                                           : std::numbers::sqrt2 * DeviationOf(motion));
    for (std::size_t c = 0; c < work_.names.size(); ++c)
      AddResponse(at.channels[c].response, at.channels[c].variance, at.frequency_Hz, out.response.channels[c]);
  }
  for (std::size_t c = 0; c < work_.names.size(); ++c) {
    ChannelQuality quality = QualityOf(out.response.channels[c]);
    quality.coherence = 1;
    for (const LocalResponse& at : responses) {
      const double coherence = at.channels[c].coherence;
      quality.coherence_at.push_back(coherence);
      if (coherence > quality.coherence) continue;
      quality.coherence = coherence;
      quality.coherence_Hz = at.frequency_Hz;
    }
    out.channels.push_back(std::move(quality));
  }
  return true;
}

bool SpectralResponses::AddMultisine(const LookedAt& looked, const std::vector<double>& motion, MeasuredResponse& out) {
  const RigRecording& recording = looked.recording;
  const std::optional<std::size_t> period = PeriodOf(motion);
  const std::optional<MultisineResponse> measured =
      period ? RespondToMultisine(motion, recording.Signals().channels, *period) : std::nullopt;
  if (!measured) {
    work_.Fault(kResponseNoPeriod, looked.file, {recording.posts[looked.largest_post]});
    return false;
  }
  work_.out.period_s = static_cast<double>(*period) / recording.rate_Hz;
  work_.out.periods += static_cast<int>(measured->periods);
  if (!measured->is_settled)
    work_.Fault(kResponseNotSettled, looked.file, {"1", "1", Rounded(1 / work_.out.period_s, 3)});
  for (const std::size_t line : measured->lines)
    out.response.frequency_Hz.push_back(static_cast<double>(line) / work_.out.period_s);
  out.response.amplitude_m.assign(measured->lines.size(), std::numbers::sqrt2 * DeviationOf(motion));
  for (std::size_t c = 0; c < work_.names.size(); ++c) {
    const LineResponse& lines = measured->channels[c];
    for (std::size_t i = 0; i < measured->lines.size(); ++i)
      AddResponse(lines.response[i], lines.variance[i], out.response.frequency_Hz[i], out.response.channels[c]);
    ChannelQuality quality = QualityOf(out.response.channels[c]);
    quality.noise = lines.noise;
    quality.distortion = std::fmax(lines.odd_distortion, lines.even_distortion);
    constexpr double kMuch = 0.03;
    if (quality.distortion > kMuch && quality.distortion > 2 * lines.noise)
      NoteDistortion({Rounded(100 * quality.distortion, 2), work_.names[c], Rounded(100 * quality.noise, 2)},
                     quality.distortion);
    out.channels.push_back(std::move(quality));
  }
  return true;
}

void SpectralResponses::Finish() {
  for (MeasuredResponse& part : parts_) {
    const auto same =
        std::find_if(work_.out.responses.begin(), work_.out.responses.end(), [&](const MeasuredResponse& other) {
          return other.shares == part.shares && other.response.frequency_Hz == part.response.frequency_Hz;
        });
    if (same != work_.out.responses.end()) {
      Join(part, *same);
      continue;
    }
    part.name = work_.NameFor(part);
    work_.CheckPosts(part.shares.rest, part);
    work_.out.responses.push_back(std::move(part));
  }
  for (const MeasuredResponse& response : work_.out.responses) CheckCoherence(response);
  if (!distortion_words_.empty())
    work_.Fault(kResponseMultisineNonlinear, work_.request.files.front(), distortion_words_);
}

void SpectralResponses::CheckCoherence(const MeasuredResponse& response) {
  constexpr double kLow = 0.95;
  double lowest = kLow;
  std::vector<std::string> words;
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    const ChannelQuality& quality = response.channels[c];
    const ChannelResponse& channel = response.response.channels[c];
    double loudest = 0;
    for (const Complex& value : channel.response) loudest = std::max(loudest, std::abs(value));
    for (std::size_t i = 0; i < quality.coherence_at.size(); ++i) {
      if (!(quality.coherence_at[i] < lowest) || std::abs(channel.response[i]) < 0.1 * loudest) continue;
      lowest = quality.coherence_at[i];
      words = {Rounded(100 * (1 - lowest), 2), quality.name, Rounded(response.response.frequency_Hz[i], 3),
               Rounded(lowest, 3)};
    }
  }
  if (!words.empty()) work_.Fault(kResponseRandomNonlinear, work_.request.files.front(), words);
}

void SpectralResponses::NoteDistortion(std::vector<std::string> words, double distortion) {
  if (distortion <= most_distorted_) return;
  most_distorted_ = distortion;
  distortion_words_ = std::move(words);
}

}  // namespace fourpost
