#include "identify/report/judged_channel.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "analysis/report/shown_number.h"
#include "identify/report/run_result.h"
#include "identify/uncertainty/misfit_limits.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

// Where a chassis engineer stops calling two response curves the same, and where they are different stories.
constexpr double kClose_dB = 1;
constexpr double kClose_deg = 10;
constexpr double kFar_dB = 2;
constexpr double kFar_deg = 20;
// Of time histories, NMSE: model and measurement look alike, and do not.
constexpr double kClose_percent = 5;
constexpr double kFar_percent = 20;

Follows Judge(double score_close, double score_far) {
  if (score_close <= 1) return Follows::kWell;
  return score_far <= 1 ? Follows::kRoughly : Follows::kNot;
}

/// By what noise and stated model error explain, where the run holds it.
void JudgeByMisfit(const Json& channel, JudgedChannel& judged) {
  judged.misfit = NumberAt(channel, "misfit");
  if (!std::isfinite(judged.misfit)) return;
  judged.numbers = ShownNumber(judged.misfit, 2) + " times noise and stated model error; " + judged.numbers;
  const bool looks_alike = judged.score <= 1;
  judged.score = judged.misfit / kLargeMisfit;
  judged.follows = Judge(judged.score, looks_alike ? 0 : judged.misfit / kFarMisfit);
}

/// None of an older run.
std::optional<WorstPlace> PlaceOf(const Json& channel) {
  const Json worst = channel.is_object() ? channel.value("worst", Json()) : Json();
  const std::vector<Json> band = ListAt(worst, "band_Hz");
  if (band.size() != 2 || !band[0].is_number() || !band[1].is_number()) return std::nullopt;
  return WorstPlace{TextAt(worst, "recording"), band[0], band[1], NumberAt(worst, "misfit")};
}

std::optional<JudgedChannel> JudgeChannel(const Json& channel) {
  JudgedChannel judged{.name = TextAt(channel, "name"), .worst = PlaceOf(channel)};
  judged.recording = TextAt(channel, "recording");
  const double dB = NumberAt(channel, "rms_dB");
  const double deg = NumberAt(channel, "rms_deg");
  const double nmse = NumberAt(channel, "nmse_percent");
  if (std::isfinite(nmse) && !std::isfinite(dB)) {
    judged.numbers = ShownNumber(nmse, 2) + " % NMSE";
    judged.is_history = true;
    judged.score = nmse / kClose_percent;
    judged.follows = Judge(nmse / kClose_percent, nmse / kFar_percent);
    JudgeByMisfit(channel, judged);
    return judged;
  }
  if (!std::isfinite(dB) || !std::isfinite(deg)) return std::nullopt;
  judged.numbers = ShownNumber(dB, 2) + " dB, " + ShownNumber(deg, 2) + "\u00b0";
  judged.score = std::max(dB / kClose_dB, deg / kClose_deg);
  judged.follows = Judge(judged.score, std::max(dB / kFar_dB, deg / kFar_deg));
  JudgeByMisfit(channel, judged);
  return judged;
}

}  // namespace

std::vector<JudgedChannel> JudgeChannels(const std::vector<Json>& channels) {
  std::vector<JudgedChannel> judged;
  for (const Json& channel : channels)
    if (std::optional<JudgedChannel> one = JudgeChannel(channel)) judged.push_back(std::move(*one));
  std::set<std::string> names;
  std::set<std::string> recordings;
  for (const JudgedChannel& channel : judged) {
    names.insert(channel.name);
    recordings.insert(channel.recording);
  }
  for (JudgedChannel& channel : judged) {
    if (channel.recording.empty() || recordings.size() == 1) continue;
    channel.name = names.size() == 1 ? channel.recording : channel.name + " in " + channel.recording;
  }
  std::stable_sort(judged.begin(), judged.end(), [](const auto& a, const auto& b) {
    return a.follows != b.follows ? a.follows < b.follows : a.score < b.score;
  });
  return judged;
}

std::string ShownLimits(const std::vector<JudgedChannel>& channels) {
  const auto is_history = [](const JudgedChannel& channel) { return channel.is_history; };
  const auto has_misfit = [](const JudgedChannel& channel) { return std::isfinite(channel.misfit); };
  std::vector<std::string> limits;
  if (std::any_of(channels.begin(), channels.end(), has_misfit))
    limits.push_back(ShownNumber(kLargeMisfit, 2) + " times noise and stated model error");
  const auto by_size = [&](bool over_time) {
    return std::any_of(channels.begin(), channels.end(), [&](const JudgedChannel& channel) {
      return !has_misfit(channel) && is_history(channel) == over_time;
    });
  };
  if (by_size(false))
    limits.push_back(ShownNumber(kClose_dB, 1) + " dB and " + ShownNumber(kClose_deg, 2) + "\u00b0 rms");
  if (by_size(true)) limits.push_back(ShownNumber(kClose_percent, 1) + " % NMSE");
  std::string text;
  for (const std::string& limit : limits) text += (text.empty() ? "" : ", or ") + limit;
  return text;
}

}  // namespace fourpost
