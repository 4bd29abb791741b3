#include "identify/draft/post_match.h"

#include <algorithm>

#include "analysis/text/name_meaning.h"

namespace fourpost {
namespace {

/// Channels of commands, beside those of how the posts moved.
void LeaveOutCommands(FileReading& reading) {
  std::vector<std::string> lengths;
  for (const OfferedChannel& channel : reading.channels)
    if (channel.dimension == kLength) lengths.push_back(channel.name);
  const std::vector<std::string> commands = PostsByName(lengths).commands;
  if (commands.empty()) return;
  std::string names;
  for (const std::string& command : commands) {
    names += (names.empty() ? "" : ", ") + command;
    std::erase_if(reading.channels, [&](const OfferedChannel& channel) { return channel.name == command; });
  }
  reading.missed.push_back("commands of posts are left out, beside channels of how these moved: " + names);
}

/// As stated; of channels of one post all of them.
std::vector<ChannelMatch> StatedPosts(const std::vector<PostChannel>& stated, const FileReading& reading) {
  std::vector<ChannelMatch> posts;
  for (const PostChannel& one : stated) {
    const bool is_there = std::any_of(reading.channels.begin(), reading.channels.end(), [&](const auto& channel) {
      return channel.name == one.channel && channel.dimension == kLength;
    });
    if (!is_there) continue;
    const auto same = std::find_if(posts.begin(), posts.end(),
                                   [&](const ChannelMatch& post) { return post.name == "post_" + one.post; });
    if (same != posts.end()) same->source.channels.emplace_back(one.channel);
    else
      posts.push_back({.name = "post_" + one.post,
                       .source = {.channels = {SourceChannel(one.channel)}},
                       .correlation = {},
                       .rival = {}});
  }
  return posts;
}

}  // namespace

void MatchPosts(const Vehicle& vehicle, const std::vector<PostChannel>& stated, FileReading& reading) {
  reading.posts = StatedPosts(stated, reading);
  if (reading.posts.empty()) {
    LeaveOutCommands(reading);
    reading.posts = MatchChannels(SoughtPosts(vehicle), reading.channels, HasSides(vehicle));
  }
  if (reading.posts.empty() && vehicle.posts.size() == 1) {
    const auto is_post = [](const OfferedChannel& channel) {
      return channel.dimension == kLength && MeaningOf(channel.name).words.contains("post");
    };
    const auto found = std::find_if(reading.channels.begin(), reading.channels.end(), is_post);
    if (found != reading.channels.end())
      reading.posts.push_back({.name = "post_" + vehicle.posts.front().name,
                               .source = {.channels = {SourceChannel(found->name)}},
                               .by = ChannelMatch::By::kLikeName,
                               .correlation = {},
                               .rival = {}});
  }
  for (ChannelMatch& post : reading.posts) {
    post.name = post.name.substr(std::string("post_").size());
    for (const SourceChannel& source : post.source.channels)
      std::erase_if(reading.channels, [&](const OfferedChannel& channel) { return channel.name == source.name; });
  }
}

std::pair<std::string, std::string> MisspeltPost(const FileReading& reading) {
  std::vector<std::string> posts;
  for (const ChannelMatch& post : reading.posts)
    for (const SourceChannel& channel : post.source.channels) posts.push_back(channel.name);
  for (const OfferedChannel& channel : reading.channels) {
    std::string meant = channel.dimension == kLength ? NearlyPost(channel.name, posts) : "";
    if (!meant.empty()) return {channel.name, std::move(meant)};
  }
  return {};
}

std::string WithoutUnit(const FileReading& reading) {
  std::string names;
  std::string example;
  for (const auto& [name, unit] : reading.unread) {
    if (!unit.empty()) continue;
    names += (names.empty() ? "" : ", ") + name;
    if (example.empty()) example = name;
  }
  return names.empty() ? "" : "; without a unit: " + names + ", which --unit states, as --unit " + example + "=mm";
}

std::string PostsMissing(const Vehicle& vehicle, const FileReading& reading) {
  std::string missing;
  std::string example;
  for (const Post& post : vehicle.posts) {
    const bool is_found = std::any_of(reading.posts.begin(), reading.posts.end(),
                                      [&](const ChannelMatch& match) { return match.name == post.name; });
    if (is_found) continue;
    missing += (missing.empty() ? "'" : ", '") + post.name + "'";
    if (example.empty()) example = post.name;
  }
  std::string offered;
  for (const OfferedChannel& channel : reading.channels)
    if (channel.dimension == kLength) offered += (offered.empty() ? "" : ", ") + channel.name;
  const auto& [misspelt, meant] = reading.misspelt_post;
  return "no channel found for post " + missing + ": call its displacement post_" + example + " or the like (" +
         "\"Actuator " + example + "\", \"Stempel " + example +
         "\"; F, R, FL, VL and so on for places); displacements here: " + (offered.empty() ? "none" : offered) +
         (misspelt.empty() ? "" : "; '" + misspelt + "' is nearly '" + meant + "'") +
         "; or state it, as --post CHANNEL=" + example + WithoutUnit(reading);
}

}  // namespace fourpost
