#include "analysis/measured_response/measured_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/frequency_response/stated_dwells.h"
#include "analysis/measured_response/dwell_responses.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/spectral_responses.h"
#include "analysis/signals/deviation.h"
#include "analysis/text/named.h"

namespace fourpost {
namespace {

std::size_t LargestPost(const std::vector<std::vector<double>>& heights) {
  std::vector<double> sizes;
  for (const std::vector<double>& height : heights) sizes.push_back(DeviationOf(height));
  return static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

class ResponseMaker {
 public:
  ResponseMaker(const ResponseRequest& request, Diagnostics& diagnostics)
      : work_{request, diagnostics}, dwells_(work_), spectra_(work_) {}

  std::optional<MeasuredResponses> Make() {
    for (const std::filesystem::path& file : work_.request.files) {
      std::optional<LookedAt> looked = Look(file);
      if (!looked || !Joins(*looked)) continue;
      if (looked->kind == ExcitationKind::kStepped) dwells_.Add(*looked);
      else spectra_.Add(*looked);
    }
    if (work_.diagnostics.HasErrors()) return std::nullopt;
    if (work_.out.kind == ExcitationKind::kStepped) dwells_.Finish();
    else spectra_.Finish();
    if (work_.diagnostics.HasErrors()) return std::nullopt;
    FindLikePosts();
    return std::move(work_.out);
  }

 private:
  std::optional<LookedAt> Look(const std::filesystem::path& file) {
    std::optional<RigRecording> recording =
        ReadRigRecording(file, work_.request.posts, work_.diagnostics, work_.request.preparation);
    if (!recording) return std::nullopt;
    DropSilent(file, *recording);
    LookedAt looked{.file = file, .recording = *std::move(recording)};
    const std::vector<std::vector<double>>& heights = looked.recording.heights;
    looked.largest_post = LargestPost(heights);
    if (!work_.request.reference.empty()) {
      const std::optional<std::size_t> named = IndexOf(work_.request.reference, looked.recording.posts);
      if (!named) {
        work_.Fault(kResponseReferenceUnknown, file, {work_.request.reference, Joined(looked.recording.posts)});
        return std::nullopt;
      }
      work_.reference = *named;
    }
    const std::vector<double>& post = heights[looked.largest_post];
    if (!(DeviationOf(post) > 0)) {
      work_.Fault(kResponsePostsStill, file);
      return std::nullopt;
    }
    const bool is_stepped = work_.request.kind == ExcitationKind::kStepped;
    if (!work_.request.kind || is_stepped || work_.request.kind == ExcitationKind::kSweep)
      looked.track = TrackTone(post);
    if (!work_.request.kind || is_stepped) looked.dwells = FindDwells(post, looked.track);
    looked.kind = work_.request.kind ? *work_.request.kind : KindOf(post, looked.track, looked.dwells);
    if (looked.kind == ExcitationKind::kStepped && !work_.request.frequencies_Hz.empty())
      looked.dwells = DwellsOfFrequencies(post, looked.track, looked.dwells, StatedPerSample(looked.recording.rate_Hz));
    return looked;
  }

  std::vector<double> StatedPerSample(double rate_Hz) const {
    std::vector<double> stated = work_.request.frequencies_Hz;
    for (double& frequency : stated) frequency /= rate_Hz;
    return stated;
  }

  /// Sensors that do not move have no response.
  void DropSilent(const std::filesystem::path& file, RigRecording& recording) {
    for (std::size_t c = recording.names.size(); c-- > 0;) {
      if (DeviationOf(recording.channels[c]) > 0) continue;
      work_.Fault(kResponseChannelSilent, file, {recording.names[c]});
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
    work_.out.duration_s += recording.duration_s();
    for (const std::string& done : recording.preparations)
      work_.out.preparations.push_back((work_.request.files.size() > 1 ? looked.file.filename().string() + ", " : "") +
                                       done);
    if (work_.names.empty()) {
      work_.out.kind = looked.kind;
      work_.out.posts = recording.posts;
      work_.out.post_channels = recording.post_channels;
      work_.out.rate_Hz = recording.rate_Hz;
      work_.out.left_out = recording.left_out;
      work_.out.unit_unknown = recording.unit_unknown;
      work_.names = recording.names;
      work_.units = recording.units;
      return true;
    }
    if (looked.kind != work_.out.kind) {
      work_.Fault(kResponseKindsDiffer, looked.file, {KindInWords(looked.kind), KindInWords(work_.out.kind)});
      return false;
    }
    for (const std::string& name : work_.names)
      if (!IndexOf(name, recording.names)) work_.Fault(kResponseChannelsDiffer, looked.file, {name});
    for (const std::string& name : recording.names)
      if (!IndexOf(name, work_.names)) work_.Fault(kResponseChannelsDiffer, work_.request.files.front(), {name});
    return recording.names == work_.names;
  }

  /// A displacement that has the same share of the posts' motion from below the body's modes to beyond those of the
  /// wheels: no part of a vehicle does.
  void FindLikePosts() {
    constexpr double kBelow_Hz = 3;
    constexpr double kBeyond_Hz = 7.5;
    const FrequencyResponse& response = work_.out.responses.front().response;
    if (response.frequency_Hz.front() > kBelow_Hz || response.frequency_Hz.back() < kBeyond_Hz) return;
    for (const ChannelResponse& channel : response.channels)
      if (channel.unit == "m" && IsConstant(channel)) {
        work_.out.like_posts.push_back(channel.name);
        work_.out.nearly_posts.push_back(NearlyPost(channel.name, work_.out.post_channels));
      }
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

  ResponseWork work_;
  DwellResponses dwells_;
  SpectralResponses spectra_;
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
