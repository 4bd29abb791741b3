#include "identify/draft/drafted_channels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/text/text_table.h"
#include "vehicles/tags/attribute_check.h"

namespace fourpost {
namespace {

bool IsOf(const ChannelMatch& match, const std::string& channel) {
  const std::vector<SourceChannel>& channels = match.source.channels;
  return std::any_of(channels.begin(), channels.end(), [&](const SourceChannel& one) { return one.name == channel; });
}

/// `not_compared`: why no motion of theirs was compared; empty: it was, or there is none to compare with.
void AddMatched(const std::vector<ChannelMatch>& matches, const std::string& before, const std::string& behind,
                const std::string& not_compared, std::vector<DraftedChannel>& list) {
  for (const ChannelMatch& match : matches)
    for (const SourceChannel& channel : match.source.channels) {
      const bool is_by_name_alone = match.IsSure() && !match.correlation && !not_compared.empty();
      list.push_back({.name = channel.name,
                      .of = before + match.name + behind,
                      .state = match.IsSure() ? DraftedChannel::State::kSure : DraftedChannel::State::kLookAt,
                      .why = is_by_name_alone ? "by name, not checked by motion: " + not_compared : DoubtOf(match)});
    }
}

bool HasChannel(const std::vector<ChannelMatch>& matches, const std::string& name) {
  return std::any_of(matches.begin(), matches.end(), [&](const ChannelMatch& match) { return match.name == name; });
}

/// What would make a channel match.
std::string WhyUnmatched(const OfferedChannel& channel, const std::vector<ChannelMatch>& matches,
                         const std::vector<SoughtChannel>& sought, const CorrelationOf& correlation) {
  const SoughtChannel* best = nullptr;
  double most = -1;
  std::string taken;
  for (const SoughtChannel& one : sought) {
    if (!(one.dimension == channel.dimension)) continue;
    if (HasChannel(matches, one.name)) {
      taken += (taken.empty() ? "" : ", ") + one.name;
      continue;
    }
    const double likeness = correlation ? std::abs(correlation(one.name, channel.name).value_or(0)) : 0;
    if (likeness <= most) continue;
    best = &one;
    most = likeness;
  }
  if (best == nullptr)
    return taken.empty() ? "nothing in the vehicle file is measured as " + WithArticle(channel.dimension) +
                               "; add an fp:sensor to use it"
                         : "all that it may be has a channel (" + taken + ")";
  return "name it like " + best->name + ", or write `" + best->name + ": " + channel.name + "` under `channels`" +
         (most > 0 ? "; its motion correlates by " + Rounded(most, 2) + ", at least 0.9 is needed" : "");
}

}  // namespace

const char* StateName(DraftedChannel::State state) {
  switch (state) {
    case DraftedChannel::State::kSure: return "sure";
    case DraftedChannel::State::kLookAt: return "look at";
    case DraftedChannel::State::kUnmatched: return "unmatched";
  }
  return "";
}

std::string DoubtOf(const ChannelMatch& match) {
  if (match.IsSure()) return "";
  if (match.is_motionless) return "does not move in this recording, so a fit leaves it out";
  std::string doubt;
  const auto add = [&](const std::string& text) { doubt += (doubt.empty() ? "" : "; ") + text; };
  if (match.by == ChannelMatch::By::kMotion) add("by its motion alone");
  if (match.by == ChannelMatch::By::kPlace) add("by its place alone, for its name does not say post");
  if (match.by == ChannelMatch::By::kKind) add("as the last channel of its kind that was left");
  if (match.by == ChannelMatch::By::kLast) add("as the last that was left to be measured so");
  const bool is_named = match.by == ChannelMatch::By::kName || match.by == ChannelMatch::By::kLikeName;
  if (match.source.channels.front().factor < 0) add("moves against the vehicle, so its sign is turned");
  else if (is_named && match.rival.empty()) add("moves otherwise than the vehicle");
  if (match.correlation) add("correlation " + Rounded(*match.correlation, 2));
  if (!match.rival.empty()) add("or " + match.rival);
  return doubt;
}

std::vector<DraftedChannel> ChannelsOf(const FileReading& reading, const std::vector<ChannelMatch>& matches,
                                       const std::vector<SoughtChannel>& sought, const CorrelationOf& correlation) {
  std::vector<DraftedChannel> list;
  AddMatched(reading.posts, "post '", "'", "", list);
  AddMatched(reading.actuators, "actuator '", "'", "", list);
  AddMatched(matches, "", "", reading.not_compared, list);
  for (const OfferedChannel& channel : reading.channels)
    if (std::none_of(matches.begin(), matches.end(),
                     [&](const ChannelMatch& match) { return IsOf(match, channel.name); }))
      list.push_back({.name = channel.name, .why = WhyUnmatched(channel, matches, sought, correlation)});
  for (const auto& [name, unit] : reading.unread)
    list.push_back({.name = name,
                    .why = (unit.empty() ? "it has no unit" : "its unit '" + unit + "' is not known") +
                           "; where it is needed, state one: {channel: " + name + ", unit: ...}"});
  return list;
}

std::vector<std::string> WithoutChannel(const std::vector<ChannelMatch>& matches,
                                        const std::vector<SoughtChannel>& sought) {
  std::vector<std::string> list;
  for (const SoughtChannel& one : sought)
    if (!HasChannel(matches, one.name)) list.push_back(one.name + " (" + WithArticle(one.dimension) + ")");
  return list;
}

}  // namespace fourpost
