#include "analysis/measured_response/rig_recording.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/time_recording.h"
#include "analysis/measured_response/findings.h"
#include "analysis/text/nearest.h"

namespace fourpost {
namespace {

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// "FL" of "post_FL", "front" of "Post front"; nothing for other names.
std::optional<std::string> PostNamed(const std::string& name) {
  constexpr std::string_view kPost = "post";
  if (!Lower(name).starts_with(kPost)) return std::nullopt;
  const std::size_t rest = name.find_first_not_of("_- .:", kPost.size());
  return rest == std::string::npos ? name : name.substr(rest);
}

bool IsCorner(const std::string& name) {
  constexpr std::array<std::string_view, 8> kCorners = {"fl", "fr", "rl", "rr", "front", "rear", "left", "right"};
  return std::find(kCorners.begin(), kCorners.end(), Lower(name)) != kCorners.end();
}

std::optional<Unit> UnitOf(const RecordedTable& table, std::size_t column) {
  return ParseRecordedUnit(table.unit(column));
}

std::vector<std::string> Lengths(const RecordedTable& table) {
  std::vector<std::string> names;
  for (std::size_t column = 0; column < table.names().size(); ++column)
    if (const auto unit = UnitOf(table, column); unit && unit->dimension == kLength)
      names.push_back(table.names()[column]);
  return names;
}

/// Of an angle over time, not a count of cycles.
bool IsAngularVelocity(const Unit& unit, std::string_view text) {
  const std::string bare = WithoutBrackets(text);
  return unit.dimension == kFrequency &&
         (bare.starts_with("rad") || bare.starts_with("deg") || bare.starts_with("\xC2\xB0"));
}

/// Empty for what is no response of a vehicle.
std::string ResponseUnit(const RecordedTable& table, std::size_t column) {
  const std::optional<Unit> unit = UnitOf(table, column);
  if (!unit) return {};
  if (unit->dimension == kLength) return "m";
  if (unit->dimension == kForce) return "N";
  if (unit->dimension == kAcceleration) return "m/s^2";
  return IsAngularVelocity(*unit, table.unit(column)) ? "rad/s" : "";
}

/// A column of numbers with its unit, where that is not known: "'oil' (foo)"; else empty.
std::string UnknownUnit(const RecordedTable& table, std::size_t column) {
  if (UnitOf(table, column) || table.HoldsText(column)) return "";
  const std::optional<double> first = table.rows(column) > 0 ? table.Number(0, column) : std::nullopt;
  if (!first || std::isnan(*first)) return "";
  const std::string& unit = table.unit(column);
  return "'" + table.names()[column] + "' (" + (unit.empty() ? "no unit" : unit) + ")";
}

std::string ListOr(const std::vector<std::string>& names, const std::string& none) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? none : text;
}

bool CheckPosts(const RecordedTable& table, std::span<const PostChannel> posts, Diagnostics& diagnostics) {
  const std::vector<std::string> lengths = Lengths(table);
  bool good = true;
  for (const PostChannel& post : posts) {
    if (std::find(lengths.begin(), lengths.end(), post.channel) != lengths.end()) continue;
    diagnostics.Report(kResponsePostMissing, {table.file(), table.names_line()},
                       {post.channel, post.post, DidYouMean(post.channel, lengths)});
    good = false;
  }
  if (!posts.empty()) return good;
  diagnostics.Report(kResponsePostsUnknown, {table.file(), table.names_line()}, {ListOr(lengths, "none")});
  return false;
}

}  // namespace

RigSignals RigRecording::Signals() const {
  RigSignals signals{.rate_Hz = rate_Hz, .posts = {}, .channels = {}};
  for (const std::vector<double>& height : heights) signals.posts.emplace_back(height);
  for (const std::vector<double>& channel : channels) signals.channels.emplace_back(channel);
  return signals;
}

double RigRecording::duration_s() const { return static_cast<double>(heights.front().size()) / rate_Hz; }

std::vector<PostChannel> PostsByName(const RecordedTable& table) {
  std::vector<PostChannel> posts;
  std::vector<PostChannel> corners;
  for (const std::string& name : Lengths(table)) {
    if (const std::optional<std::string> post = PostNamed(name)) posts.push_back({name, *post});
    else if (IsCorner(name)) corners.push_back({name, name});
  }
  return posts.empty() ? corners : posts;
}

std::optional<RigRecording> ReadRigRecording(const std::filesystem::path& file, std::span<const PostChannel> posts,
                                             Diagnostics& diagnostics, const TimePreparation& preparation) {
  const std::optional<RecordedTable> table = ReadRecordedTable(file, diagnostics);
  if (!table) return std::nullopt;
  const std::vector<PostChannel> known =
      posts.empty() ? PostsByName(*table) : std::vector<PostChannel>(posts.begin(), posts.end());
  if (!CheckPosts(*table, known, diagnostics)) return std::nullopt;
  const std::string time = TimesColumn(*table);
  RigRecording out;
  std::vector<RecordedChannel> wanted;
  for (const PostChannel& post : known) {
    out.posts.push_back(post.post);
    wanted.push_back({.names = {post.channel}, .dimension = kLength, .what = "the displacement of a post"});
  }
  for (std::size_t column = 0; column < table->names().size(); ++column) {
    const std::string& name = table->names()[column];
    const auto is_post = [&](const PostChannel& post) { return post.channel == name; };
    if (name == time || std::any_of(known.begin(), known.end(), is_post)) continue;
    const std::string unit = ResponseUnit(*table, column);
    if (unit.empty() || table->HoldsText(column)) {
      out.left_out.push_back(name);
      if (const std::string text = UnknownUnit(*table, column); !text.empty()) out.unit_unknown.push_back(text);
      continue;
    }
    out.names.push_back(name);
    out.units.push_back(unit);
    wanted.push_back({.names = {name}, .dimension = UnitOf(*table, column)->dimension, .what = "a channel"});
  }
  if (out.names.empty()) {
    diagnostics.Report(kResponseNoChannel, {table->file(), table->names_line()});
    return std::nullopt;
  }
  RecordedChannel times = kTimeColumn;
  if (!time.empty()) times.names = {time};
  std::optional<TimeRecording> recording = ReadTimeRecording(*table, wanted, diagnostics, times, preparation);
  if (!recording) return std::nullopt;
  out.rate_Hz = recording->rate_Hz();
  const auto first = std::make_move_iterator(recording->channels.begin());
  const auto middle = first + static_cast<std::ptrdiff_t>(known.size());
  out.heights.assign(first, middle);
  out.channels.assign(middle, std::make_move_iterator(recording->channels.end()));
  return out;
}

}  // namespace fourpost
