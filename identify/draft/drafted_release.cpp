#include "identify/draft/drafted_release.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/files/recorded_unit.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

/// Not later, to 0.01 ms: a study takes the next sample.
std::string Seconds(double time_s) { return FormatNumber(std::floor(1e5 * time_s + 1e-3), -5) + " s"; }

/// Of a displacement above its rest before a release [mm]; nothing of other channels, and within noise.
std::optional<double> Above_mm(const DraftedPreparation& preparation, const SourceChannel& channel,
                               std::size_t number) {
  const ColumnSummary* const column = preparation.Find(channel.name);
  if (column == nullptr || number >= column->above_rest.size() || column->above_rest[number] == 0) return std::nullopt;
  const std::optional<Unit> unit = ParseRecordedUnit(channel.unit.empty() ? column->unit : channel.unit);
  if (!unit || !(unit->dimension == kLength)) return std::nullopt;
  return 1e3 * unit->si * channel.factor * column->above_rest[number];
}

/// "SP Axle Front 40.1 mm, SP Body Rear -2.3 mm above rest; ..." of what `release` could state.
std::string WhatStoodAbove(const DraftedPreparation& preparation, const std::vector<ChannelMatch>& matches,
                           std::size_t number) {
  std::string all;
  std::string held;
  double most_mm = 0;
  for (const ChannelMatch& match : matches)
    for (const SourceChannel& channel : match.source.channels) {
      const std::optional<double> above_mm = Above_mm(preparation, channel, number);
      if (!above_mm) continue;
      all += (all.empty() ? "before it " : ", ") + channel.name + " " + ShortNumber(*above_mm, 3) + " mm";
      if (match.source.channels.size() > 1 || std::abs(*above_mm) <= std::abs(most_mm)) continue;
      most_mm = *above_mm;
      held = match.name;
    }
  if (all.empty()) return "";
  all += " above rest";
  return held.empty() ? all
                      : all + "; if it was held there alone, which fits far faster: {" + held + ": " +
                            ShortNumber(most_mm, 3) + " mm}";
}

}  // namespace

std::string ReleaseLines(const DraftedPreparation& preparation, const std::vector<ChannelMatch>& matches,
                         std::size_t number) {
  const std::vector<RecordedRelease>& releases = preparation.summary.releases;
  if (number >= releases.size())
    return "    release: estimated  # look at: no post moves, and the vehicle comes to rest; set `start` to the "
           "release\n";
  const RecordedRelease& release = releases[number];
  const bool was_at_rest = release.let_go_s > release.rest_from_s;
  std::string lines;
  if (was_at_rest)
    lines += "    start: " + Seconds(release.let_go_s) + "  # look at: the first sample that leaves its rest\n";
  // What is left of the motion then is noise, and the pose of rest is what friction shows.
  constexpr double kBehind_s = 0.5;
  const double end_s = std::ceil(10 * (release.rest_s + kBehind_s)) / 10;
  if (end_s < release.end_s || number + 1 < releases.size())
    lines += "    end: " + Seconds(std::min(end_s, release.end_s)) + "  # the motion has died away by " +
             Seconds(release.rest_s) + "\n";
  const std::string above = was_at_rest ? WhatStoodAbove(preparation, matches, number) : "";
  const std::string look = !was_at_rest    ? "no post moves, and the record begins in motion"
                           : above.empty() ? "no post moves, and nothing moves before"
                                           : above;
  return lines + "    release: " + (was_at_rest ? "at rest" : "estimated") + "  # look at: " + look + "\n";
}

}  // namespace fourpost
