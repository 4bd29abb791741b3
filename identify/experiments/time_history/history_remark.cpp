#include "identify/experiments/time_history/history_remark.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/signals/median.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

using Cause = HistoryRemark::Cause;

// A model that is wrong in shape gains less by a shift.
constexpr double kMuch = 0.25;
// What shift and scale leave above it is most of the channel: they explain nothing, however much larger the error is.
constexpr double kMost_percent = 50;

bool GainsByTiming(const HistoryMisfit& misfit) {
  return misfit.gain && *misfit.timed_nmse_percent < std::min(kMuch * misfit.nmse_percent, kMost_percent);
}

using Words = std::vector<std::string>;

/// `words`: behind the names of channel and recording.
HistoryRemark Remark(Cause cause, const HistoryMisfit& misfit, const Finding& kind, const Words& words) {
  Words all = {misfit.name, misfit.recording};
  all.insert(all.end(), words.begin(), words.end());
  return {cause, misfit.recording, misfit.name, {&kind, std::move(all)}};
}

std::string Milliseconds(double delay_s) { return ShortNumber(1e3 * delay_s) + " ms"; }

ChannelSource SourceOf(const HistoryMisfit& misfit) {
  return misfit.source.channels.empty() ? ChannelSource{.channels = {misfit.name}} : misfit.source;
}

/// What the study would have, and what that does to the measured channel.
struct Remedy {
  ChannelSource source;
  double factor = 1;
  double delay_s = 0;
};

Remedy Times(Remedy remedy, double factor) {
  for (SourceChannel& channel : remedy.source.channels) channel.factor *= factor;
  remedy.factor *= factor;
  return remedy;
}

Remedy Earlier(Remedy remedy, double delay_s) {
  for (SourceChannel& channel : remedy.source.channels) channel.delay_s += AtDigits(delay_s, 3);
  remedy.delay_s += AtDigits(delay_s, 3);
  return remedy;
}

/// To the model's scale.
Remedy Scaled(const Remedy& remedy, const HistoryMisfit& misfit) {
  return Times(remedy, AtDigits(1 / std::abs(*misfit.gain * remedy.factor), 3));
}

/// The first that leaves little, or the last: each with the error that it has by itself.
Words WithFirstOf(const std::vector<Remedy>& remedies, const HistoryMisfit& misfit, const RemediedErrors& errors) {
  // A model's own scale is off by up to a fifth, of which the error is 4 %.
  const double little_percent = 2 * *misfit.timed_nmse_percent + 4;
  const auto error = [&](const Remedy& remedy) {
    return errors.Percent(misfit.recording, misfit.name, remedy.factor, remedy.delay_s);
  };
  auto chosen = std::find_if(remedies.begin(), remedies.end(),
                             [&](const Remedy& remedy) { return error(remedy) < little_percent; });
  if (chosen == remedies.end()) --chosen;
  return {ShortNumber(error(*chosen), 2), misfit.name + ": " + SourceText(chosen->source)};
}

/// A scale, a delay or both beside a remedy of unit or sign.
Words WithRemedy(const Remedy& remedy, const HistoryMisfit& misfit, const RemediedErrors& errors) {
  const Remedy scaled = Scaled(remedy, misfit);
  return WithFirstOf({remedy, scaled, Earlier(remedy, *misfit.delay_s), Earlier(scaled, *misfit.delay_s)}, misfit,
                     errors);
}

/// `kind`: what it is late against.
HistoryRemark LateChannel(const HistoryMisfit& misfit, double delay_s, const Finding& kind,
                          const RemediedErrors& errors) {
  const Remedy remedy = Earlier({SourceOf(misfit)}, delay_s);
  Words words = WithFirstOf({remedy, Scaled(remedy, misfit)}, misfit, errors);
  words.insert(words.begin(), Lateness(delay_s));
  return Remark(Cause::kDelay, misfit, kind, words);
}

/// Of channels that come so much later than the model, the posts come earlier.
HistoryRemark Posts(const std::string& recording, double common_s) {
  return {
      Cause::kDelay, recording, "", {&kPostsNotSynchronised, {recording, Lateness(common_s), Milliseconds(-common_s)}}};
}

std::vector<double> DelaysOf(std::span<const HistoryMisfit> misfits) {
  std::vector<double> delays;
  for (const HistoryMisfit& misfit : misfits)
    if (misfit.delay_s) delays.push_back(*misfit.delay_s);
  return delays;
}

/// A fit meets a channel that is late half-way, so that the healthy ones seem early: what they have in common, their
/// median, is nobody's delay, and the odd one out is the one farthest from it.
void AddDelays(std::span<const HistoryMisfit> misfits, double sample_s, const RemediedErrors& errors,
               std::vector<HistoryRemark>& remarks) {
  const std::vector<double> delays = DelaysOf(misfits);
  if (delays.empty()) return;
  if (std::optional<HistoryRemark> posts = PostDelay(misfits, sample_s)) {
    remarks.push_back(*std::move(posts));
    return;
  }
  if (delays.size() > 2) {
    const double common = *CommonDelay(misfits);
    const auto off = [&](const HistoryMisfit& misfit) {
      return misfit.delay_s ? std::abs(*misfit.delay_s - common) : 0.0;
    };
    const HistoryMisfit& odd = *std::max_element(misfits.begin(), misfits.end(),
                                                 [&](const auto& a, const auto& b) { return off(a) < off(b); });
    if (off(odd) > sample_s && GainsByTiming(odd))
      remarks.push_back(LateChannel(odd, *odd.delay_s - common, kChannelLateOfOthers, errors));
    return;
  }
  // Of two it is anybody's guess.
  for (const HistoryMisfit& misfit : misfits)
    if (GainsByTiming(misfit) && std::abs(*misfit.delay_s) > sample_s)
      remarks.push_back(LateChannel(misfit, *misfit.delay_s, kChannelLateOfModel, errors));
}

/// Of what a model's own scale is off by; no two factors of one unit are as near.
constexpr double kNear = 1.5;

/// A unit that a channel may be stated in, another that it may be in, and how much larger it then comes out.
struct Mistaken {
  const char* stated;
  const char* true_unit;
  double factor;
};
constexpr std::array<Mistaken, 6> kMistaken{{{"m", "mm", 1e3},
                                             {"mm", "m", 1e-3},
                                             {"m/s^2", "g", 1 / 9.80665},
                                             {"g", "m/s^2", 9.80665},
                                             {"N", "kN", 1e-3},
                                             {"kN", "N", 1e3}}};

/// The true unit in place of `stated`, where the gain goes with one.
const Mistaken* MistakenUnit(const std::string& stated, double gain) {
  for (const Mistaken& mistaken : kMistaken)
    if (const double ratio = std::abs(gain) / mistaken.factor;
        stated == mistaken.stated && ratio < kNear && ratio > 1 / kNear)
      return &mistaken;
  return nullptr;
}

/// A scale of the study that is the factor itself: what it was meant to do has been done.
bool IsDoneTwice(const ChannelSource& source, double gain) {
  return std::all_of(source.channels.begin(), source.channels.end(), [&](const SourceChannel& channel) {
    const double ratio = std::abs(gain / channel.factor);
    return ratio < kNear && ratio > 1 / kNear;
  });
}

/// Of all channels, as the study has it; that of the model where it leaves it to the file; nothing of several.
std::string StatedUnit(const HistoryMisfit& misfit, const ChannelSource& source) {
  const std::string& first = source.channels.front().unit;
  for (const SourceChannel& channel : source.channels)
    if (channel.unit != first) return "";
  return first.empty() ? misfit.unit : first;
}

HistoryRemark OtherScale(const HistoryMisfit& misfit, const RemediedErrors& errors) {
  const double size = std::abs(*misfit.gain);
  Remedy remedy{SourceOf(misfit)};
  const bool done_twice = IsDoneTwice(remedy.source, size);
  const Mistaken* unit = done_twice ? nullptr : MistakenUnit(StatedUnit(misfit, remedy.source), size);
  if (done_twice) {
    remedy.factor = 1 / std::abs(remedy.source.channels.front().factor);
    for (SourceChannel& channel : remedy.source.channels) channel.factor = std::copysign(1, channel.factor);
  } else if (unit) {
    remedy.factor = 1 / unit->factor;
    for (SourceChannel& channel : remedy.source.channels) channel.unit = unit->true_unit;
  } else {
    remedy = Scaled(remedy, misfit);
  }
  if (*misfit.gain < 0) remedy = Times(remedy, -1);
  Words words = WithRemedy(remedy, misfit, errors);
  if (unit) words.insert(words.begin(), {unit->true_unit, unit->stated});
  words.insert(words.begin(), ShortNumber(std::max(size, 1 / size)));
  return Remark(Cause::kUnit, misfit,
                done_twice ? kChannelScaledTwice
                : unit     ? kChannelUnitMistaken
                           : kChannelUnitDoubtful,
                words);
}

/// From where the vehicle was let go if the channels that go with the model have the right sign, and if they have not.
std::array<std::string, 2> Releases(MisfitsOfOne recording) {
  for (const HistoryMisfit& misfit : recording)
    if (const std::optional<double> from = misfit.released_from_m) {
      const std::string size = ShortNumber(1e3 * std::abs(*from)) + " mm ";
      return *from > 0 ? std::array{"from " + size + "above rest", "from " + size + "below rest"}
                       : std::array{"from " + size + "below rest", "from " + size + "above rest"};
    }
  return {"from where `released from` of the results says", "from the other side of rest"};
}

/// A release fits with either sign: the model's is that of the channels that weigh most.
HistoryRemark OtherSign(const HistoryMisfit& misfit, MisfitsOfOne recording, const RemediedErrors& errors) {
  const Words remedy = WithRemedy(Times({SourceOf(misfit)}, -1), misfit, errors);
  std::string others;
  std::string of_others;
  for (const HistoryMisfit& other : recording) {
    if (misfit.drive != HistoryMisfit::Drive::kRelease || !other.gain || *other.gain < 0) continue;
    others += (others.empty() ? "'" : ", '") + other.name + "'";
    of_others += (of_others.empty() ? "" : ", ") + other.name + ": " + SourceText(Times({SourceOf(other)}, -1).source);
  }
  if (others.empty()) return Remark(Cause::kSign, misfit, kChannelInverted, remedy);
  const auto [stated, mirrored] = Releases(recording);
  return Remark(Cause::kSign, misfit, kReleaseSignsDisagree, {others, remedy[1], stated, of_others, mirrored});
}

/// Unit, sign and place of a channel.
void AddScale(const HistoryMisfit& misfit, MisfitsOfOne recording, const RemediedErrors& errors,
              std::vector<HistoryRemark>& remarks) {
  // Less than g; no model that has the shape right is so far off.
  constexpr double kOtherUnit = 5;
  if (misfit.swapped_with) {
    remarks.push_back(Remark(Cause::kSwapped, misfit, kHistoryChannelsSwapped, {*misfit.swapped_with}));
    return;
  }
  if (!GainsByTiming(misfit)) return;
  const double size = std::abs(*misfit.gain);
  if (std::max(size, 1 / size) > kOtherUnit) remarks.push_back(OtherScale(misfit, errors));
  else if (*misfit.gain < 0) remarks.push_back(OtherSign(misfit, recording, errors));
}

}  // namespace

std::string Lateness(double delay_s) { return Milliseconds(std::abs(delay_s)) + (delay_s > 0 ? " later" : " earlier"); }

std::string DelayRemedy(const HistoryMisfit& misfit, double delay_s) {
  return SourceText(Earlier({SourceOf(misfit)}, delay_s).source);
}

std::optional<double> CommonDelay(std::span<const HistoryMisfit> misfits) {
  std::vector<double> delays = DelaysOf(misfits);
  if (delays.empty()) return std::nullopt;
  return Median(std::move(delays));
}

std::optional<HistoryRemark> PostDelay(std::span<const HistoryMisfit> misfits, double sample_s) {
  constexpr std::ptrdiff_t kFewest = 3;
  const std::optional<double> common = CommonDelay(misfits);
  if (!common || std::abs(*common) <= sample_s || misfits.front().drive != HistoryMisfit::Drive::kPosts)
    return std::nullopt;
  const auto agreeing = std::count_if(misfits.begin(), misfits.end(), [&](const HistoryMisfit& misfit) {
    return GainsByTiming(misfit) && std::abs(*misfit.delay_s - *common) < 0.5 * std::abs(*common);
  });
  // One in five may be a slow channel, of which parameters turn the phase by as much.
  const auto all = std::ssize(misfits);
  if (agreeing < kFewest || 5 * (all - agreeing) > all) return std::nullopt;
  return Posts(misfits.front().recording, *common);
}

std::vector<std::span<const HistoryMisfit>> ByRecording(const std::vector<HistoryMisfit>& misfits) {
  std::vector<std::span<const HistoryMisfit>> recordings;
  for (auto first = misfits.begin(); first != misfits.end();) {
    const auto last = std::find_if(first, misfits.end(),
                                   [&](const HistoryMisfit& misfit) { return misfit.recording != first->recording; });
    recordings.emplace_back(first, last);
    first = last;
  }
  return recordings;
}

std::vector<HistoryRemark> RemarksOn(const std::vector<HistoryMisfit>& misfits, double sample_s,
                                     const RemediedErrors& errors) {
  std::vector<HistoryRemark> remarks;
  for (const std::span<const HistoryMisfit> recording : ByRecording(misfits)) {
    const std::size_t before = remarks.size();
    for (const HistoryMisfit& misfit : recording) AddScale(misfit, recording, errors, remarks);
    if (remarks.size() == before) AddDelays(recording, sample_s, errors, remarks);
  }
  return remarks;
}

}  // namespace fourpost
