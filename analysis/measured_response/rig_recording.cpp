#include "analysis/measured_response/rig_recording.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/time_recording.h"
#include "analysis/measured_response/findings.h"
#include "analysis/text/nearest.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

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
std::string ResponseUnit(const std::string& text) {
  const std::optional<Unit> unit = ParseRecordedUnit(text);
  if (!unit) return {};
  if (unit->dimension == kLength) return "m";
  if (unit->dimension == kForce) return "N";
  if (unit->dimension == kAcceleration) return "m/s^2";
  return IsAngularVelocity(*unit, text) ? "rad/s" : "";
}

/// A column of numbers with its unit, where that is not known: "'oil' (foo)"; else empty.
std::string UnknownUnit(const RecordedTable& table, std::size_t column) {
  if (UnitOf(table, column) || table.HoldsText(column)) return "";
  const std::optional<double> first = table.rows(column) > 0 ? table.Number(0, column) : std::nullopt;
  if (!first || std::isnan(*first)) return "";
  const std::string& unit = table.unit(column);
  return "'" + table.names()[column] + "' (" + (unit.empty() ? "no unit" : unit) + ")";
}

std::string ListOr(const std::vector<std::string>& names, const std::string& none, const std::string& between = ", ") {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : between) + name;
  return text.empty() ? none : text;
}

/// Reads one recording, with the files beside it.
class RigReader {
 public:
  RigReader(const std::filesystem::path& file, const RigPreparation& preparation, Diagnostics& diagnostics)
      : file_(file), preparation_(preparation), diagnostics_(diagnostics) {}

  std::optional<RigRecording> Read(std::span<const PostChannel> posts) {
    if (!ReadTables()) return std::nullopt;
    std::vector<PostChannel> known(posts.begin(), posts.end());
    for (std::size_t i = 0; i < tables_.size() && known.empty(); ++i) known = PostsOf(tables_[i]);
    if (!CheckPosts(known)) return std::nullopt;
    RecordedChannel times = preparation_.time.value_or(kTimeColumn);
    if (const std::string time = TimesColumn(tables_.front()); !preparation_.time && !time.empty())
      times.names = {time};
    for (const PostChannel& post : known) {
      out_.posts.push_back(post.post);
      Want({.names = {post.channel}, .dimension = kLength, .what = "the displacement of a post"});
    }
    for (const RecordedTable& table : tables_) {
      std::vector<std::string> no_channels = times.names;
      no_channels.push_back(TimesColumn(table));
      no_channels.insert(no_channels.end(), named_.commands.begin(), named_.commands.end());
      WantChannels(table, no_channels);
    }
    if (out_.names.empty()) {
      diagnostics_.Report(kResponseNoChannel, {tables_.front().file(), tables_.front().names_line()});
      return std::nullopt;
    }
    std::optional<TimeRecording> recording =
        tables_.size() > 1 ? ReadTimeRecording(file_, wanted_, diagnostics_, times, preparation_.times)
                           : ReadTimeRecording(tables_.front(), wanted_, diagnostics_, times, preparation_.times);
    if (!recording || !Cut(*recording)) return std::nullopt;
    out_.rate_Hz = recording->rate_Hz();
    out_.preparations = std::move(recording->preparations);
    if (const std::string posts_by = named_.InWords(); !posts_by.empty())
      out_.preparations.insert(out_.preparations.begin(), posts_by);
    const auto first = std::make_move_iterator(recording->channels.begin());
    const auto middle = first + static_cast<std::ptrdiff_t>(known.size());
    out_.heights.assign(first, middle);
    out_.channels.assign(middle, std::make_move_iterator(recording->channels.end()));
    return std::move(out_);
  }

 private:
  bool ReadTables() {
    std::vector<std::filesystem::path> files = {file_};
    for (const OtherFile& other : preparation_.times.others) files.push_back(other.path);
    for (const std::filesystem::path& file : files) {
      std::optional<RecordedTable> table = ReadRecordedTable(file, diagnostics_);
      if (!table) return false;
      tables_.push_back(*std::move(table));
    }
    return true;
  }

  std::vector<PostChannel> PostsOf(const RecordedTable& table) {
    named_ = PostsByName(Lengths(table));
    return named_.posts;
  }

  /// Null of a channel of which nothing is stated.
  const RecordedChannel* Stated(const std::string& name) const {
    for (const RecordedChannel& channel : preparation_.channels)
      if (channel.names.front() == name) return &channel;
    return nullptr;
  }

  bool CheckPosts(const std::vector<PostChannel>& posts) {
    std::vector<std::string> lengths;
    std::vector<std::string> all;
    for (const RecordedTable& table : tables_) {
      const std::vector<std::string> here = Lengths(table);
      lengths.insert(lengths.end(), here.begin(), here.end());
      all.insert(all.end(), table.names().begin(), table.names().end());
    }
    const RecordedTable& table = tables_.front();
    bool good = true;
    for (const std::vector<std::string>& alike : named_.alike) {
      diagnostics_.Report(kResponsePostTwice, {table.file(), table.names_line()},
                          {"'" + ListOr(alike, "", "', '") + "'", alike.front()});
      good = false;
    }
    for (const PostChannel& post : posts) {
      // What is no length is read as one where a unit or an integral is stated.
      const RecordedChannel* const stated = Stated(post.channel);
      const bool is_made = stated != nullptr && (!stated->unit.empty() || stated->integrated_above_Hz);
      const std::vector<std::string>& such = is_made ? all : lengths;
      if (std::find(such.begin(), such.end(), post.channel) != such.end()) continue;
      diagnostics_.Report(kResponsePostMissing, {table.file(), table.names_line()},
                          {post.channel, post.post, DidYouMean(post.channel, lengths)});
      good = false;
    }
    if (!posts.empty()) return good;
    diagnostics_.Report(kResponsePostsUnknown, {table.file(), table.names_line()}, {ListOr(lengths, "none")});
    return false;
  }

  void Want(RecordedChannel channel) {
    if (const RecordedChannel* const stated = Stated(channel.names.front())) {
      const RecordedChannel plain = std::move(channel);
      channel = *stated;
      channel.names = plain.names;
      channel.dimension = plain.dimension;
      channel.what = plain.what;
    }
    wanted_.push_back(std::move(channel));
  }

  void WantChannels(const RecordedTable& table, const std::vector<std::string>& times) {
    for (std::size_t column = 0; column < table.names().size(); ++column) {
      const std::string& name = table.names()[column];
      const bool is_wanted = std::any_of(wanted_.begin(), wanted_.end(),
                                         [&](const RecordedChannel& other) { return other.names.front() == name; });
      if (is_wanted || std::find(times.begin(), times.end(), name) != times.end()) continue;
      const RecordedChannel* const stated = Stated(name);
      const std::string text = stated == nullptr || stated->unit.empty() ? table.unit(column) : stated->unit;
      std::string unit = ResponseUnit(text);
      std::optional<Unit> parsed = ParseRecordedUnit(text);
      if (stated != nullptr && stated->integrated_above_Hz && parsed) {
        unit = "m";
        parsed->dimension = kLength;
      }
      if (unit.empty() || table.HoldsText(column)) {
        out_.left_out.push_back(name);
        if (const std::string unknown = UnknownUnit(table, column); !unknown.empty())
          out_.unit_unknown.push_back(unknown);
        continue;
      }
      out_.names.push_back(name);
      out_.units.push_back(unit);
      Want({.names = {name}, .dimension = parsed->dimension, .what = "a channel"});
    }
  }

  /// To the stated window; false where nothing is left of it.
  bool Cut(TimeRecording& recording) {
    const auto sample = [&](double t) { return (t - recording.start_s) * recording.rate_Hz(); };
    const auto last = static_cast<double>(recording.samples()) - 1;
    const double begin =
        preparation_.start_s ? std::clamp(std::ceil(sample(*preparation_.start_s) - 1e-6), 0.0, last + 1) : 0;
    const double end =
        preparation_.end_s ? std::clamp(std::floor(sample(*preparation_.end_s) + 1e-6), -1.0, last) : last;
    constexpr double kLeast = 16;
    if (end - begin + 1 < kLeast && end - begin < last) {
      diagnostics_.Report(kResponseWindowEmpty, {file_.string()},
                          {Rounded(recording.start_s, 3), Rounded(recording.end_s, 3)});
      return false;
    }
    if (begin > 0 || end < last)
      recording.preparations.push_back(
          CutTo(recording.time_s(static_cast<std::size_t>(begin)), recording.time_s(static_cast<std::size_t>(end))));
    for (std::vector<double>& channel : recording.channels) {
      channel.erase(channel.begin() + static_cast<std::ptrdiff_t>(end) + 1, channel.end());
      channel.erase(channel.begin(), channel.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    return true;
  }

  const std::filesystem::path& file_;
  const RigPreparation& preparation_;
  Diagnostics& diagnostics_;
  /// The first is that of the file.
  std::vector<RecordedTable> tables_;
  std::vector<RecordedChannel> wanted_;
  /// Nothing where posts are stated.
  NamedPosts named_;
  RigRecording out_;
};

}  // namespace

RigSignals RigRecording::Signals() const {
  RigSignals signals{.rate_Hz = rate_Hz, .posts = {}, .channels = {}};
  for (const std::vector<double>& height : heights) signals.posts.emplace_back(height);
  for (const std::vector<double>& channel : channels) signals.channels.emplace_back(channel);
  return signals;
}

double RigRecording::duration_s() const { return static_cast<double>(heights.front().size()) / rate_Hz; }

std::optional<RigRecording> ReadRigRecording(const std::filesystem::path& file, std::span<const PostChannel> posts,
                                             Diagnostics& diagnostics, const RigPreparation& preparation) {
  return RigReader(file, preparation, diagnostics).Read(posts);
}

}  // namespace fourpost
