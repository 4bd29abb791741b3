#include "analysis/measured_response/measured_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/frequency_response/local_response.h"
#include "analysis/frequency_response/multisine.h"
#include "analysis/frequency_response/stepped_sine.h"
#include "analysis/measured_response/dwell_groups.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/moved_band.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/low_pass.h"
#include "analysis/signals/median.h"
#include "analysis/text/named.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A response per displacement of the reference, as FrequencyResponse has it: accelerations per acceleration.
Complex ByReference(Complex response, const std::string& unit, double frequency_Hz) {
  const double w = 2 * std::numbers::pi * frequency_Hz;
  return unit == "m/s^2" ? response / (-w * w) : response;
}

void Add(Complex response, double variance, double frequency_Hz, ChannelResponse& channel) {
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

std::string NameOf(const MeasuredResponse& response, const std::vector<MeasuredResponse>& others) {
  const std::string base = response.pattern.value_or("posts");
  std::string name = base;
  for (int number = 2; IndexOf(name, NamesOf(others)); ++number) name = base + "_" + std::to_string(number);
  return name;
}

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

std::size_t LargestPost(const std::vector<std::vector<double>>& heights) {
  std::vector<double> sizes;
  for (const std::vector<double>& height : heights) sizes.push_back(DeviationOf(height));
  return static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

/// One file, read and looked at.
struct LookedAt {
  std::filesystem::path file;
  RigRecording recording;
  std::size_t largest_post = 0;
  std::vector<TonePoint> track = {};
  std::vector<Dwell> dwells = {};
  ExcitationKind kind = ExcitationKind::kStepped;
};

class ResponseMaker {
 public:
  ResponseMaker(const ResponseRequest& request, Diagnostics& diagnostics)
      : request_(request), diagnostics_(diagnostics) {}

  std::optional<MeasuredResponses> Make() {
    for (const std::filesystem::path& file : request_.files) {
      std::optional<LookedAt> looked = Look(file);
      if (!looked || !Joins(*looked)) continue;
      if (looked->kind == ExcitationKind::kStepped) AddDwells(*looked);
      else AddSpectra(*looked);
    }
    if (diagnostics_.HasErrors()) return std::nullopt;
    if (out_.kind == ExcitationKind::kStepped) FinishDwells();
    else FinishSpectra();
    if (diagnostics_.HasErrors()) return std::nullopt;
    FindLikePosts();
    return std::move(out_);
  }

 private:
  void Fault(const Finding& finding, const std::filesystem::path& file, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(finding, {file.string()}, words);
  }

  std::optional<LookedAt> Look(const std::filesystem::path& file) {
    std::optional<RigRecording> recording = ReadRigRecording(file, request_.posts, diagnostics_, request_.preparation);
    if (!recording) return std::nullopt;
    DropSilent(file, *recording);
    LookedAt looked{.file = file, .recording = *std::move(recording)};
    const std::vector<std::vector<double>>& heights = looked.recording.heights;
    looked.largest_post = LargestPost(heights);
    if (!request_.reference.empty()) {
      const std::optional<std::size_t> named = IndexOf(request_.reference, looked.recording.posts);
      if (!named) {
        Fault(kResponseReferenceUnknown, file, {request_.reference, Joined(looked.recording.posts)});
        return std::nullopt;
      }
      reference_ = *named;
    }
    const std::vector<double>& post = heights[looked.largest_post];
    if (!(DeviationOf(post) > 0)) {
      Fault(kResponsePostsStill, file);
      return std::nullopt;
    }
    const bool is_stepped = request_.kind == ExcitationKind::kStepped;
    if (!request_.kind || is_stepped || request_.kind == ExcitationKind::kSweep) looked.track = TrackTone(post);
    if (!request_.kind || is_stepped) looked.dwells = FindDwells(looked.track);
    looked.kind = request_.kind ? *request_.kind : KindOf(post, looked.track, looked.dwells);
    return looked;
  }

  /// Sensors that do not move have no response.
  void DropSilent(const std::filesystem::path& file, RigRecording& recording) {
    for (std::size_t c = recording.names.size(); c-- > 0;) {
      if (DeviationOf(recording.channels[c]) > 0) continue;
      Fault(kResponseChannelSilent, file, {recording.names[c]});
      const auto place = static_cast<std::ptrdiff_t>(c);
      recording.left_out.push_back(recording.names[c]);
      recording.names.erase(recording.names.begin() + place);
      recording.units.erase(recording.units.begin() + place);
      recording.channels.erase(recording.channels.begin() + place);
    }
  }

  static std::string Joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
  }

  /// Whether a file goes with those before it.
  bool Joins(const LookedAt& looked) {
    const RigRecording& recording = looked.recording;
    out_.duration_s += recording.duration_s();
    if (names_.empty()) {
      out_.kind = looked.kind;
      out_.posts = recording.posts;
      out_.rate_Hz = recording.rate_Hz;
      out_.left_out = recording.left_out;
      out_.unit_unknown = recording.unit_unknown;
      names_ = recording.names;
      units_ = recording.units;
      return true;
    }
    if (looked.kind != out_.kind) {
      Fault(kResponseKindsDiffer, looked.file, {KindInWords(looked.kind), KindInWords(out_.kind)});
      return false;
    }
    for (const std::string& name : names_)
      if (!IndexOf(name, recording.names)) Fault(kResponseChannelsDiffer, looked.file, {name});
    for (const std::string& name : recording.names)
      if (!IndexOf(name, names_)) Fault(kResponseChannelsDiffer, request_.files.front(), {name});
    return recording.names == names_;
  }

  /// A displacement that has the same share of the posts' motion from below the body's modes to beyond those of the
  /// wheels: no part of a vehicle does.
  void FindLikePosts() {
    constexpr double kBelow_Hz = 3;
    constexpr double kBeyond_Hz = 7.5;
    const FrequencyResponse& response = out_.responses.front().response;
    if (response.frequency_Hz.front() > kBelow_Hz || response.frequency_Hz.back() < kBeyond_Hz) return;
    for (const ChannelResponse& channel : response.channels)
      if (channel.unit == "m" && IsConstant(channel)) out_.like_posts.push_back(channel.name);
  }

  static bool IsConstant(const ChannelResponse& channel) {
    constexpr double kShare = 0.01;
    constexpr double kDeviations = 4;
    const double gain = channel.response.front().real();
    for (std::size_t i = 0; i < channel.response.size(); ++i)
      if (!(std::abs(channel.response[i] - gain) < kShare * std::abs(gain) + kDeviations * channel.gain_sd[i]))
        return false;
    return std::abs(gain) > kShare;
  }

  // Stepped sines.

  void AddDwells(const LookedAt& looked) {
    const RigSignals signals = looked.recording.Signals();
    std::vector<DwellResponse> responses = RespondInDwells(signals, looked.dwells, reference_);
    if (responses.empty()) {
      Fault(kResponseNoDwell, looked.file, {looked.recording.posts[looked.largest_post]});
      return;
    }
    const std::vector<double> rest = LevelsAtRest(signals, looked.dwells);
    has_rest_ = has_rest_ && !rest.empty();
    for (DwellResponse& response : responses) {
      for (std::size_t c = 0; c < rest.size(); ++c) response.channels[c].mean -= rest[c];
      UndoFilter(response);
      ++out_.dwells;
      cycles_.push_back(response.cycles);
      if (!response.is_settled && out_.unsettled++ == 0) unsettled_Hz_ = response.frequency_Hz;
      dwells_.push_back(std::move(response));
    }
  }

  /// Of ratios nothing is left of a filter that all channels have passed; of amplitudes there is.
  void UndoFilter(DwellResponse& response) const {
    if (!request_.filter) return;
    response.amplitude /= Passed(response.frequency_Hz);
    for (DwellChannel& channel : response.channels)
      for (std::size_t h = 0; h < channel.harmonics.size(); ++h)
        channel.harmonics[h] /= Passed(static_cast<double>(h + 1) * response.frequency_Hz);
  }

  double Passed(double frequency_Hz) const {
    if (!request_.filter) return 1;
    // Where the filter leaves next to nothing, its inverse would raise noise.
    constexpr double kLeast = 0.02;
    const LowPass filter(request_.filter->order, request_.filter->cutoff_Hz, out_.rate_Hz);
    return std::max(kLeast, std::abs(filter.Response(std::min(0.49, frequency_Hz / out_.rate_Hz))));
  }

  void FinishDwells() {
    const std::filesystem::path& file = request_.files.front();
    out_.median_cycles = Median(cycles_);
    out_.has_rest = has_rest_;
    if (out_.unsettled > 0)
      Fault(kResponseNotSettled, file,
            {std::to_string(out_.unsettled), std::to_string(out_.dwells), Rounded(unsettled_Hz_, 3)});
    for (const DwellGroup& group : GroupsOf(dwells_)) out_.responses.push_back(ResponseOf(group));
    CheckFilter(file);
  }

  MeasuredResponse ResponseOf(const DwellGroup& group) {
    MeasuredResponse out{
        .name = {}, .shares = group.shares, .pattern = PatternOf(group.shares, out_.posts), .response = {}};
    out.name = NameOf(out, out_.responses);
    for (std::size_t c = 0; c < names_.size(); ++c) {
      ChannelResponse& channel = out.response.channels.emplace_back();
      channel.name = names_[c];
      channel.unit = units_[c];
    }
    std::vector<double> rests;
    std::vector<DwellResponse> means;
    for (const std::vector<DwellResponse>& repeats : group.frequencies) {
      means.push_back(MeanOf(repeats));
      const DwellResponse& mean = means.back();
      rests.push_back(mean.shares.rest);
      out.repeats.push_back(static_cast<int>(repeats.size()));
      out.response.frequency_Hz.push_back(mean.frequency_Hz);
      out.response.amplitude_m.push_back(mean.amplitude);
      for (std::size_t c = 0; c < names_.size(); ++c) AddDwell(mean, c, out.response.channels[c]);
    }
    for (std::size_t c = 0; c < names_.size(); ++c) AddQuality(means, c, out);
    CheckPosts(Median(rests), out);
    return out;
  }

  void AddDwell(const DwellResponse& dwell, std::size_t c, ChannelResponse& channel) const {
    const DwellChannel& measured = dwell.channels[c];
    Add(measured.response, measured.variance, dwell.frequency_Hz, channel);
    if (has_rest_) channel.mean.push_back(measured.mean);
    channel.second_harmonic.push_back(measured.harmonics.size() > 1 ? measured.harmonics[1] : 0);
  }

  void AddQuality(const std::vector<DwellResponse>& means, std::size_t c, MeasuredResponse& out) const {
    ChannelQuality quality = QualityOf(out.response.channels[c]);
    quality.distortion = 0;
    for (const DwellResponse& mean : means) {
      const DwellChannel& channel = mean.channels[c];
      // Next to a node anything is large.
      constexpr double kNode = 0.2;
      if (channel.harmonics.front() < kNode * LoudestLike(c, mean)) continue;
      // Noise has harmonics, too: four of them.
      const double noise = std::sqrt(4 * channel.variance) / std::abs(channel.response);
      const double distortion = std::sqrt(std::max(0.0, std::pow(channel.Distortion(), 2) - noise * noise));
      if (distortion <= quality.distortion) continue;
      quality.distortion = distortion;
      quality.distortion_Hz = mean.frequency_Hz;
    }
    out.channels.push_back(std::move(quality));
  }

  /// The largest fundamental of all channels of the unit of this one.
  double LoudestLike(std::size_t c, const DwellResponse& mean) const {
    double loudest = 0;
    for (std::size_t other = 0; other < units_.size(); ++other)
      if (units_[other] == units_[c]) loudest = std::max(loudest, mean.channels[other].harmonics.front());
    return loudest;
  }

  /// The largest of all channels is reported.
  void NoteDistortion(std::vector<std::string> words, double distortion) {
    if (distortion <= most_distorted_) return;
    most_distorted_ = distortion;
    distortion_words_ = std::move(words);
  }

  void CheckPosts(double rest, const MeasuredResponse& response) {
    constexpr double kOff = 0.1;
    if (rest > kOff)
      Fault(kResponsePostsOff, request_.files.front(),
            {Rounded(100 * rest, 2), response.name, response.pattern.value_or("found")});
  }

  void CheckFilter(const std::filesystem::path& file) {
    constexpr double kLittle = 0.1;
    for (const MeasuredResponse& response : out_.responses) {
      const double highest = response.response.frequency_Hz.back();
      if (const double passed = Passed(highest); passed < kLittle) {
        Fault(kResponseFilterTooLow, file, {Rounded(100 * passed, 2), Rounded(highest, 3)});
        return;
      }
    }
  }

  // Sweeps, random motions and multisines.

  void AddSpectra(const LookedAt& looked) {
    const std::vector<std::vector<double>>& heights = looked.recording.heights;
    MeasuredResponse out{
        .name = {}, .shares = SharesOf(ProductsOf(heights), reference_), .pattern = {}, .response = {}};
    constexpr double kApart = 0.4;
    if (out.shares.rest > kApart) {
      Fault(kResponsePostsApart, looked.file, {Rounded(100 * out.shares.rest, 2)});
      return;
    }
    out.pattern = PatternOf(out.shares, out_.posts);
    for (std::size_t c = 0; c < names_.size(); ++c) {
      ChannelResponse& channel = out.response.channels.emplace_back();
      channel.name = names_[c];
      channel.unit = units_[c];
    }
    const std::vector<double> motion = MotionOf(heights, out.shares);
    const bool is_made =
        looked.kind == ExcitationKind::kMultisine ? AddMultisine(looked, motion, out) : AddLocal(looked, motion, out);
    if (is_made) parts_.push_back(std::move(out));
  }

  bool AddLocal(const LookedAt& looked, const std::vector<double>& motion, MeasuredResponse& out) {
    const RigRecording& recording = looked.recording;
    const std::vector<double> frequencies =
        request_.frequencies_Hz.empty()
            ? (parts_.empty() ? FrequenciesOf(looked, motion) : parts_.front().response.frequency_Hz)
            : request_.frequencies_Hz;
    // Thirteen lines above zero.
    const double least_Hz = frequencies.empty() ? 1 / recording.duration_s() : frequencies.front();
    if (frequencies.empty() || 14 / recording.duration_s() > 2 * least_Hz ||
        frequencies.back() + 14 / recording.duration_s() > 0.45 * recording.rate_Hz) {
      Fault(kResponseTooShort, looked.file, {Rounded(recording.duration_s(), 3), Rounded(least_Hz, 3)});
      return false;
    }
    const std::vector<LocalResponse> responses =
        LocalResponses(motion, recording.Signals().channels, recording.rate_Hz, frequencies);
    out_.least_averages = std::numeric_limits<double>::infinity();
    for (const LocalResponse& at : responses) {
      out_.least_averages = std::min(out_.least_averages, at.averages);
      out_.most_averages = std::max(out_.most_averages, at.averages);
      out.response.frequency_Hz.push_back(at.frequency_Hz);
      out.response.amplitude_m.push_back(looked.kind == ExcitationKind::kSweep
                                             ? SweptAmplitude(looked.track, at.frequency_Hz / recording.rate_Hz) /
                                                   Passed(at.frequency_Hz)
                                             : std::numbers::sqrt2 * DeviationOf(motion));
      for (std::size_t c = 0; c < names_.size(); ++c)
        Add(at.channels[c].response, at.channels[c].variance, at.frequency_Hz, out.response.channels[c]);
    }
    for (std::size_t c = 0; c < names_.size(); ++c) {
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

  static std::vector<double> FrequenciesOf(const LookedAt& looked, const std::vector<double>& motion) {
    const double rate_Hz = looked.recording.rate_Hz;
    return looked.kind == ExcitationKind::kSweep
               ? SweptFrequencies(looked.track, rate_Hz, looked.recording.duration_s())
               : MovedFrequencies(motion, rate_Hz);
  }

  bool AddMultisine(const LookedAt& looked, const std::vector<double>& motion, MeasuredResponse& out) {
    const RigRecording& recording = looked.recording;
    const std::optional<std::size_t> period = PeriodOf(motion);
    const std::optional<MultisineResponse> measured =
        period ? RespondToMultisine(motion, recording.Signals().channels, *period) : std::nullopt;
    if (!measured) {
      Fault(kResponseNoPeriod, looked.file, {recording.posts[looked.largest_post]});
      return false;
    }
    out_.period_s = static_cast<double>(*period) / recording.rate_Hz;
    out_.periods += static_cast<int>(measured->periods);
    if (!measured->is_settled) Fault(kResponseNotSettled, looked.file, {"1", "1", Rounded(1 / out_.period_s, 3)});
    for (const std::size_t line : measured->lines)
      out.response.frequency_Hz.push_back(static_cast<double>(line) / out_.period_s);
    out.response.amplitude_m.assign(measured->lines.size(), std::numbers::sqrt2 * DeviationOf(motion));
    for (std::size_t c = 0; c < names_.size(); ++c) {
      const LineResponse& lines = measured->channels[c];
      for (std::size_t i = 0; i < measured->lines.size(); ++i)
        Add(lines.response[i], lines.variance[i], out.response.frequency_Hz[i], out.response.channels[c]);
      ChannelQuality quality = QualityOf(out.response.channels[c]);
      quality.noise = lines.noise;
      quality.distortion = std::fmax(lines.odd_distortion, lines.even_distortion);
      constexpr double kMuch = 0.03;
      if (quality.distortion > kMuch && quality.distortion > 2 * lines.noise)
        NoteDistortion({Rounded(100 * quality.distortion, 2), names_[c], Rounded(100 * quality.noise, 2)},
                       quality.distortion);
      out.channels.push_back(std::move(quality));
    }
    return true;
  }

  void FinishSpectra() {
    for (MeasuredResponse& part : parts_) {
      const auto same = std::find_if(out_.responses.begin(), out_.responses.end(), [&](const MeasuredResponse& other) {
        return other.shares == part.shares && other.response.frequency_Hz == part.response.frequency_Hz;
      });
      if (same != out_.responses.end()) {
        Join(part, *same);
        continue;
      }
      part.name = NameOf(part, out_.responses);
      CheckPosts(part.shares.rest, part);
      out_.responses.push_back(std::move(part));
    }
    for (const MeasuredResponse& response : out_.responses) CheckCoherence(response);
    if (!distortion_words_.empty()) Fault(kResponseMultisineNonlinear, request_.files.front(), distortion_words_);
  }

  /// Another file of the same motion: weighted by the inverse of variances.
  static void Join(const MeasuredResponse& part, MeasuredResponse& whole) {
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

  /// The largest incoherent share of a channel where it moves by a tenth of its most, once.
  void CheckCoherence(const MeasuredResponse& response) {
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
    if (!words.empty()) Fault(kResponseRandomNonlinear, request_.files.front(), words);
  }

  const ResponseRequest& request_;
  Diagnostics& diagnostics_;
  MeasuredResponses out_;
  std::optional<std::size_t> reference_;
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::vector<DwellResponse> dwells_;
  std::vector<double> cycles_;
  bool has_rest_ = true;
  double unsettled_Hz_ = 0;
  double most_distorted_ = 0;
  std::vector<std::string> distortion_words_;
  std::vector<MeasuredResponse> parts_;
};

}  // namespace

std::string KindInWords(ExcitationKind kind) {
  constexpr std::array<const char*, 4> kWords = {"stepped sine", "sweep", "random motion", "multisine"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::optional<MeasuredResponses> MeasureResponses(const ResponseRequest& request, Diagnostics& diagnostics) {
  return ResponseMaker(request, diagnostics).Make();
}

}  // namespace fourpost
