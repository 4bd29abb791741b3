#include "analysis/measured_response/rig_recording.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/recording_window.h"
#include "analysis/files/time_recording.h"
#include "analysis/measured_response/findings.h"
#include "analysis/text/nearest.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

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
std::string UnknownUnit(const RecordedTable& table, std::size_t column, const std::string& unit) {
  if (ParseRecordedUnit(unit) || table.HoldsText(column)) return "";
  const std::optional<double> first = table.rows(column) > 0 ? table.Number(0, column) : std::nullopt;
  if (!first || std::isnan(*first)) return "";
  return "'" + table.names()[column] + "' (" + (unit.empty() ? "no unit" : unit + RecordedUnitHint(unit)) + ")";
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
      : file_(file), preparation_(preparation), diagnostics_(diagnostics), stated_(preparation.channels) {}

  std::optional<RigRecording> Read(std::span<const PostChannel> posts) {
    if (!ReadTables() || !TakeUnits()) return std::nullopt;
    std::vector<PostChannel> known(posts.begin(), posts.end());
    for (std::size_t i = 0; i < tables_.size() && known.empty(); ++i) known = PostsOf(tables_[i]);
    if (!CheckPosts(known)) return std::nullopt;
    RecordedChannel times = preparation_.time.value_or(kTimeColumn);
    if (const std::string time = TimesColumn(tables_.front()); !preparation_.time && !time.empty())
      times.names = {time};
    if (const RecordedChannel* const stated = Stated(times.names.front()); stated != nullptr && times.unit.empty())
      times.unit = stated->unit;
    for (const PostChannel& post : known) {
      out_.posts.push_back(post.post);
      out_.post_channels.push_back(post.channel);
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

  /// Adds stated units to what else is stated of channels; false where one names no channel.
  bool TakeUnits() {
    std::vector<std::string> all;
    for (const RecordedTable& table : tables_) all.insert(all.end(), table.names().begin(), table.names().end());
    bool good = true;
    for (const StatedUnit& stated : preparation_.units) {
      bool is_used = false;
      for (const std::string& name : all) {
        if (!stated.Names(name)) continue;
        is_used = true;
        const auto is_it = [&](const RecordedChannel& channel) { return channel.names.front() == name; };
        auto place = std::find_if(stated_.begin(), stated_.end(), is_it);
        if (place == stated_.end())
          place = stated_.insert(stated_.end(), {.names = {name}, .dimension = {}, .what = ""});
        place->unit = stated.unit;
      }
      if (is_used) continue;
      diagnostics_.Report(kResponseUnitOfNone, {tables_.front().file(), tables_.front().names_line()},
                          {stated.channel, DidYouMeanOrAll(stated.channel, all)});
      good = false;
    }
    return good;
  }

  /// As stated, else as the file has it.
  std::string UnitText(const RecordedTable& table, std::size_t column) const {
    const RecordedChannel* const stated = Stated(table.names()[column]);
    return stated != nullptr && !stated->unit.empty() ? stated->unit : table.unit(column);
  }

  std::vector<std::string> Lengths(const RecordedTable& table) const {
    std::vector<std::string> names;
    for (std::size_t column = 0; column < table.names().size(); ++column)
      if (const auto unit = ParseRecordedUnit(UnitText(table, column)); unit && unit->dimension == kLength)
        names.push_back(table.names()[column]);
    return names;
  }

  /// Of numbers, but for the times.
  std::vector<std::string> WithoutUnit(const RecordedTable& table) const {
    std::vector<std::string> names;
    for (std::size_t column = 0; column < table.names().size(); ++column) {
      const std::string& name = table.names()[column];
      const bool is_of_numbers = !table.HoldsText(column) && table.rows(column) > 0 && table.Number(0, column);
      if (is_of_numbers && name != TimesColumn(table) && !ParseRecordedUnit(UnitText(table, column)))
        names.push_back(name);
    }
    return names;
  }

  /// Null of a channel of which nothing is stated.
  const RecordedChannel* Stated(const std::string& name) const {
    for (const RecordedChannel& channel : stated_)
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
      good = false;
      if (const std::string unit = OtherUnitOf(post.channel); !unit.empty()) {
        diagnostics_.Report(kResponsePostUnit, {table.file(), table.names_line()},
                            {post.channel, post.post, unit, post.channel, post.post, post.channel});
        continue;
      }
      diagnostics_.Report(kResponsePostMissing, {table.file(), table.names_line()},
                          {post.channel, post.post, DidYouMeanOrAll(post.channel, lengths)});
    }
    if (!posts.empty()) return good;
    ReportNoPosts(lengths);
    return false;
  }

  /// "no unit" or "the unit 'V'" of a channel that is there; else empty.
  std::string OtherUnitOf(const std::string& channel) const {
    for (const RecordedTable& table : tables_)
      if (const std::optional<std::size_t> column = table.FindColumn(channel)) {
        const std::string unit = UnitText(table, *column);
        return unit.empty() ? "no unit" : "the unit '" + unit + "', not one of a length";
      }
    return "";
  }

  void ReportNoPosts(const std::vector<std::string>& lengths) {
    std::vector<std::string> without;
    for (const RecordedTable& one : tables_) {
      const std::vector<std::string> here = WithoutUnit(one);
      without.insert(without.end(), here.begin(), here.end());
    }
    const RecordedTable& table = tables_.front();
    const std::vector<PostChannel> posts = PostsByName(without).posts;
    std::vector<std::string> channels;
    for (const PostChannel& post : posts) channels.push_back(post.channel);
    if (!posts.empty())
      diagnostics_.Report(kResponsePostsWithoutUnit, {table.file(), table.names_line()},
                          {ListOr(channels, ""), channels.front(), posts.front().post, channels.front()});
    else
      diagnostics_.Report(kResponsePostsUnknown, {table.file(), table.names_line()},
                          {ListOr(lengths, "none"), without.empty() ? "" : "; without a unit: " + ListOr(without, "")});
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
      const std::string text = UnitText(table, column);
      std::string unit = ResponseUnit(text);
      std::optional<Unit> parsed = ParseRecordedUnit(text);
      if (stated != nullptr && stated->integrated_above_Hz && parsed) {
        unit = "m";
        parsed->dimension = kLength;
      }
      if (unit.empty() || table.HoldsText(column)) {
        out_.left_out.push_back(name);
        if (const std::string unknown = UnknownUnit(table, column, text); !unknown.empty())
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
    if (CutToWindow({.start_s = preparation_.start_s, .end_s = preparation_.end_s}, recording)) return true;
    diagnostics_.Report(kResponseWindowEmpty, {file_.string()},
                        {Rounded(recording.start_s, 3), Rounded(recording.end_s, 3)});
    return false;
  }

  const std::filesystem::path& file_;
  const RigPreparation& preparation_;
  Diagnostics& diagnostics_;
  /// Of channels.
  std::vector<RecordedChannel> stated_;
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
