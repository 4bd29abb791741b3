#include "identify/lint/history_remark.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/short_number.h"
#include "identify/channel_source_text.h"

namespace fourpost {
namespace {

using Cause = HistoryRemark::Cause;

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// A model that is wrong in shape gains less by a shift.
constexpr double kMuch = 0.25;

bool GainsByTiming(const HistoryMisfit& misfit) {
  return misfit.gain && *misfit.timed_nmse_percent < kMuch * misfit.nmse_percent;
}

std::string Called(const HistoryMisfit& misfit) { return "'" + misfit.name + "' of '" + misfit.recording + "'"; }

HistoryRemark Remark(Cause cause, const HistoryMisfit& misfit, const std::string& message) {
  return {cause, misfit.recording, misfit.name, message};
}

std::string Milliseconds(double delay_s) { return ShortNumber(1e3 * delay_s) + " ms"; }

ChannelSource SourceOf(const HistoryMisfit& misfit) {
  return misfit.source.channels.empty() ? ChannelSource{.channels = {misfit.name}} : misfit.source;
}

/// What the study would have after `change` of each channel.
template <typename Change>
std::string Remedy(const HistoryMisfit& misfit, const Change& change) {
  ChannelSource source = SourceOf(misfit);
  for (SourceChannel& channel : source.channels) change(channel);
  return SourceText(source);
}

std::string WithRemedy(const HistoryMisfit& misfit, const std::string& remedy) {
  return ": its error would be " + ShortNumber(*misfit.timed_nmse_percent, 2) + " % with '" + misfit.name + ": " +
         remedy + "' in the study";
}

HistoryRemark LateChannel(const HistoryMisfit& misfit, double delay_s, const std::string& against) {
  return Remark(
      Cause::kDelay, misfit,
      Called(misfit) + " comes " + Lateness(delay_s) + against + WithRemedy(misfit, DelayRemedy(misfit, delay_s)));
}

/// Of channels that come so much later than the model, the posts come earlier.
HistoryRemark Posts(const std::string& recording, double common_s) {
  return {Cause::kDelay, recording, "",
          "all channels of '" + recording + "' come " + Lateness(common_s) +
              " than the model, as if the height of its post were not synchronised with them: add 'delay: " +
              Milliseconds(-common_s) + "' to the channels of its 'posts' in the study"};
}

std::vector<double> DelaysOf(std::span<const HistoryMisfit> misfits) {
  std::vector<double> delays;
  for (const HistoryMisfit& misfit : misfits)
    if (misfit.delay_s) delays.push_back(*misfit.delay_s);
  return delays;
}

/// A fit meets a channel that is late half-way, so that the healthy ones seem early: what they have in common, their
/// median, is nobody's delay, and the odd one out is the one farthest from it.
void AddDelays(std::span<const HistoryMisfit> misfits, double sample_s, std::vector<HistoryRemark>& remarks) {
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
      remarks.push_back(LateChannel(odd, *odd.delay_s - common,
                                    " than the other channels do against the model, as if it were not synchronised"));
    return;
  }
  // Of two it is anybody's guess.
  for (const HistoryMisfit& misfit : misfits)
    if (GainsByTiming(misfit) && std::abs(*misfit.delay_s) > sample_s)
      remarks.push_back(LateChannel(misfit, *misfit.delay_s,
                                    " than the model, as if it, or the height of its post, were not synchronised"));
}

/// A unit that a channel may be told in, another that it may be in, and how much larger it then comes out.
struct Mistaken {
  const char* told;
  const char* true_unit;
  double factor;
};
constexpr std::array<Mistaken, 6> kMistaken{{{"m", "mm", 1e3},
                                             {"mm", "m", 1e-3},
                                             {"m/s^2", "g", 1 / 9.80665},
                                             {"g", "m/s^2", 9.80665},
                                             {"N", "kN", 1e-3},
                                             {"kN", "N", 1e3}}};

/// The unit of which the other of the pair has that dimension too; `si`: that of the model's channel.
const Mistaken* MistakenUnit(const std::string& si, double gain) {
  // Of what a model's own scale is off by.
  constexpr double kNear = 1.5;
  for (std::size_t i = 0; i < kMistaken.size(); i += 2)
    for (std::size_t j = i; j < i + 2 && kMistaken[i].told == si; ++j)
      if (const double ratio = std::abs(gain) / kMistaken[j].factor; ratio < kNear && ratio > 1 / kNear)
        return &kMistaken[j];
  return nullptr;
}

HistoryRemark OtherScale(const HistoryMisfit& misfit) {
  const double ratio = std::max(std::abs(*misfit.gain), 1 / std::abs(*misfit.gain));
  const bool turned = *misfit.gain < 0;
  const Mistaken* unit = MistakenUnit(misfit.unit, *misfit.gain);
  const std::string remedy = Remedy(misfit, [&](SourceChannel& channel) {
    if (unit) channel.unit = unit->true_unit;
    channel.factor *= (turned ? -1 : 1) * (unit ? 1 : AtDigits(1 / std::abs(*misfit.gain), 3));
  });
  return Remark(
      Cause::kUnit, misfit,
      Called(misfit) + " and the model differ by a factor of " + ShortNumber(ratio) + ", as if its unit were wrong (" +
          (unit ? std::string(unit->true_unit) + " told as " + unit->told : "1000: mm for m, 9.81: g for m/s^2") + ")" +
          WithRemedy(misfit, remedy));
}

/// Unit, sign and place of a channel.
void AddScale(const HistoryMisfit& misfit, std::vector<HistoryRemark>& remarks) {
  // Less than g; no model that has the shape right is so far off.
  constexpr double kOtherUnit = 5;
  if (misfit.swapped_with) {
    remarks.push_back(
        Remark(Cause::kSwapped, misfit,
               Called(misfit) + " is measured like the model's '" + *misfit.swapped_with +
                   "', and the other way round, as if the two channels were swapped: exchange them in the study"));
    return;
  }
  if (!GainsByTiming(misfit)) return;
  const double size = std::abs(*misfit.gain);
  if (std::max(size, 1 / size) > kOtherUnit) remarks.push_back(OtherScale(misfit));
  else if (*misfit.gain < 0)
    remarks.push_back(Remark(
        Cause::kSign, misfit,
        Called(misfit) + " goes against the model, as if its sign were wrong" +
            WithRemedy(misfit, Remedy(misfit, [](SourceChannel& channel) { channel.factor = -channel.factor; }))));
}

}  // namespace

std::string Lateness(double delay_s) { return Milliseconds(std::abs(delay_s)) + (delay_s > 0 ? " later" : " earlier"); }

std::string DelayRemedy(const HistoryMisfit& misfit, double delay_s) {
  return Remedy(misfit, [&](SourceChannel& channel) { channel.delay_s += AtDigits(delay_s, 3); });
}

std::optional<double> CommonDelay(std::span<const HistoryMisfit> misfits) {
  std::vector<double> delays = DelaysOf(misfits);
  if (delays.empty()) return std::nullopt;
  return Median(std::move(delays));
}

std::optional<HistoryRemark> PostDelay(std::span<const HistoryMisfit> misfits, double sample_s) {
  constexpr std::ptrdiff_t kFewest = 3;
  const std::optional<double> common = CommonDelay(misfits);
  if (!common || std::abs(*common) <= sample_s) return std::nullopt;
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

std::vector<HistoryRemark> RemarksOn(const std::vector<HistoryMisfit>& misfits, double sample_s) {
  std::vector<HistoryRemark> remarks;
  for (const std::span<const HistoryMisfit> recording : ByRecording(misfits)) {
    const std::size_t before = remarks.size();
    for (const HistoryMisfit& misfit : recording) AddScale(misfit, remarks);
    if (remarks.size() == before) AddDelays(recording, sample_s, remarks);
  }
  return remarks;
}

}  // namespace fourpost
