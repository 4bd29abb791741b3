#include "identify/draft/study_draft.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "analysis/text/named.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "identify/draft/bench_draft.h"
#include "identify/draft/draft_statements.h"
#include "identify/draft/drafted_release.h"
#include "identify/draft/file_reading.h"
#include "identify/draft/motion_evidence.h"
#include "identify/experiments/subject.h"
#include "identify/study/loaded_study.h"
#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

using Kind = FileReading::Kind;

bool IsNamedSo(const ChannelMatch& match) {
  return match.by == ChannelMatch::By::kName && match.source.channels.front() == SourceChannel(match.name);
}

/// A post's channel that a study finds by its name.
bool IsPostNamedSo(const ChannelMatch& post) {
  const std::vector<SourceChannel>& channels = post.source.channels;
  return channels.size() == 1 && !channels.front().has_trend && channels.front().unit.empty() &&
         (channels.front().name == post.name || channels.front().name == "post_" + post.name);
}

bool AreSame(const std::vector<ChannelMatch>& one, const std::vector<ChannelMatch>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
    return a.name == b.name && SourceText(a.source) == SourceText(b.source);
  });
}

/// "look at: ..." of a match that is not sure; else empty.
std::string LookAt(const ChannelMatch& match) {
  const std::string doubt = DoubtOf(match);
  return doubt.empty() ? "" : "look at: " + doubt;
}

/// Lines `name: channel`, those that names do not say; `others: by name` where there are such as well.
std::string ChannelLines(const std::vector<ChannelMatch>& matches, const std::string& indent) {
  std::string lines;
  bool has_named = false;
  for (const ChannelMatch& match : matches) {
    has_named = has_named || IsNamedSo(match);
    if (IsNamedSo(match) && match.IsSure()) continue;
    const std::string doubt = LookAt(match);
    const bool drifts = std::any_of(match.source.channels.begin(), match.source.channels.end(),
                                    [](const SourceChannel& channel) { return channel.has_trend; });
    const std::string why = doubt.empty() && drifts ? "drifts more than it moves" : doubt;
    lines += indent + match.name + ": " + SourceText(match.source) + (why.empty() ? "" : "  # " + why) + '\n';
  }
  return lines.empty() || !has_named ? lines : lines + indent + "others: by name\n";
}

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

class Drafter {
 public:
  Drafter(const std::vector<fs::path>& files, const Vehicle& vehicle, const fs::path& study,
          const DraftStatements& stated, const WorkHooks& hooks)
      : vehicle_(vehicle), study_(study), stated_(stated), hooks_(hooks) {
    CheckStatedPosts(stated, vehicle);
    for (const fs::path& file : files) {
      hooks_.Show("reading " + file.filename().string() + ", file " + std::to_string(readings_.size() + 1) + " of " +
                  std::to_string(files.size()));
      readings_.push_back(ReadForDraft(file, vehicle, stated));
    }
    JoinFiles();
  }

  StudyDraft Draft() {
    std::vector<std::string> columns;
    for (const FileReading& one : readings_) columns.insert(columns.end(), one.columns.begin(), one.columns.end());
    CheckStatements(stated_, columns);
    const std::vector<std::size_t> none;
    const Subject subject(vehicle_, none, study_);
    std::optional<CondensedModel> model;
    if (!vehicle_.posts.empty()) model = subject.Condensed()->At(vehicle_.ParameterValues());
    MotionEvidence evidence(vehicle_, model ? &*model : nullptr);
    for (FileReading& reading : readings_) evidence.Add(reading);
    for (const FileReading& reading : readings_) Match(reading, evidence);
    text_ = "vehicle: " + Relative(vehicle_.file) + "\n";
    AddRecordings();
    AddHistories();
    AddLoads();
    AddBench();
    StudyDraft draft{.text = text_, .files = drafted_, .findings = {}};
    Check(draft);
    draft.text = Head(draft) + draft.text;
    return draft;
  }

 private:
  /// Files without posts belong to the one recording with posts over the same time.
  void JoinFiles() {
    std::map<std::size_t, std::vector<fs::path>> beside;
    for (FileReading& lone : readings_) {
      if (!lone.is_without_posts) continue;
      std::vector<std::size_t> partners;
      for (std::size_t i = 0; i < readings_.size(); ++i)
        if (IsOverPosts(readings_[i]) && AreOfOneTime(readings_[i], lone)) partners.push_back(i);
      if (partners.size() != 1) continue;
      beside[partners.front()].push_back(lone.path);
      lone.kind = Kind::kUnread;
      lone.reason = "recorded beside " + readings_[partners.front()].path.filename().string();
    }
    for (const auto& [place, others] : beside) {
      readings_[place] = ReadForDraft(readings_[place].path, vehicle_, stated_, others);
      readings_[place].preparation.why_beside = "recorded over the same time; look at: whether on one clock";
    }
  }

  static bool IsOverPosts(const FileReading& reading) {
    return (reading.kind == Kind::kHistory || reading.kind == Kind::kDwells) && !reading.is_without_posts;
  }

  /// What both have is nearly all of either.
  static bool AreOfOneTime(const FileReading& one, const FileReading& other) {
    const std::optional<TimeSummary>& a = one.preparation.summary.time;
    const std::optional<TimeSummary>& b = other.preparation.summary.time;
    if (!a || !b) return false;
    constexpr double kNearlyAll = 0.9;
    const double common = std::min(a->end_s, b->end_s) - std::max(a->start_s, b->start_s);
    return common > kNearlyAll * std::max(a->end_s - a->start_s, b->end_s - b->start_s);
  }

  std::string TimesOf(const FileReading& reading) const {
    std::vector<std::string> others;
    for (const OtherFile& other : reading.preparation.times.others) others.push_back(Relative(other.path));
    return TimesLines(reading.preparation, others);
  }

  std::string Relative(const fs::path& file) const {
    const fs::path folder = fs::weakly_canonical(fs::absolute(study_)).parent_path();
    const fs::path target = fs::weakly_canonical(fs::absolute(file));
    // Of two folders that have nothing in common but the root a relative path is no help.
    const auto first = [](const fs::path& path) {
      const fs::path behind_root = path.relative_path();
      return behind_root.empty() ? fs::path() : *behind_root.begin();
    };
    const bool is_far = first(target) != first(folder);
    return YamlText((is_far ? target : target.lexically_relative(folder)).generic_string());
  }

  void Match(const FileReading& reading, const MotionEvidence& evidence) {
    DraftedFile drafted{.path = reading.path, .use = reading.reason};
    drafted.has_misspelt_post = !reading.misspelt_post.first.empty();
    const bool is_loads = reading.kind == Kind::kLoads;
    const std::vector<SoughtChannel> sought = is_loads ? SoughtTyres(vehicle_) : SoughtSensors(vehicle_);
    if (reading.kind != Kind::kUnread) {
      drafted.is_used = true;
      const CorrelationOf correlation = [&](const std::string& name, const std::string& channel) {
        return evidence.Of(name, channel);
      };
      drafted.matches = MatchChannels(sought, reading.channels, HasSides(vehicle_), correlation);
      for (ChannelMatch& match : drafted.matches) {
        RemoveDrifts(reading.preparation, match);
        StateUnits(stated_.units, match.source);
        match.is_motionless = reading.kind == Kind::kHistory && IsMotionless(reading.preparation, match.source);
      }
      for (const SoughtChannel& one : sought)
        if (std::none_of(drafted.matches.begin(), drafted.matches.end(),
                         [&](const ChannelMatch& match) { return match.name == one.name; }))
          drafted.sensors_left.push_back(one.name);
      for (const OfferedChannel& channel : reading.channels)
        if (!IsMatched(channel.name, drafted.matches)) drafted.channels_left.push_back(channel.name);
      drafted.channels = ChannelsOf(reading, drafted.matches, sought, correlation);
      drafted.without_channel = WithoutChannel(drafted.matches, sought);
    }
    for (const DraftedFile& other : drafted_)
      if (drafted.same_as.empty() && other.channels == drafted.channels &&
          other.without_channel == drafted.without_channel)
        drafted.same_as = other.path.filename().string();
    drafted_.push_back(std::move(drafted));
  }

  static bool IsMatched(const std::string& channel, const std::vector<ChannelMatch>& matches) {
    return std::any_of(matches.begin(), matches.end(), [&](const ChannelMatch& match) {
      const std::vector<SourceChannel>& channels = match.source.channels;
      return std::any_of(channels.begin(), channels.end(), [&](const auto& one) { return one.name == channel; });
    });
  }

  bool IsSine(std::size_t i) const { return readings_[i].kind == Kind::kSines || readings_[i].kind == Kind::kDwells; }

  /// `recordings`, the `channels` of the first of them, which all share, and `band`.
  void AddRecordings() {
    std::string list;
    double lower_Hz = std::numeric_limits<double>::infinity();
    double upper_Hz = 0;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      if (!IsSine(i)) continue;
      drafted_[i].use = "recordings";
      if (list.empty()) shared_ = i;
      list += RecordingEntry(readings_[i]);
      for (const DraftedMotion& motion : readings_[i].motions) {
        lower_Hz = std::min(lower_Hz, motion.response.frequency_Hz.front());
        upper_Hz = std::max(upper_Hz, motion.response.frequency_Hz.back());
      }
    }
    if (list.empty()) return;
    text_ += "\nrecordings:\n" + list;
    const std::string lines = ChannelLines(drafted_[*shared_].matches, "  ");
    if (!lines.empty()) text_ += "\n# sensor of the vehicle: channel\nchannels:\n" + lines;
    has_channels_ = !lines.empty();
    text_ += "\n# All frequencies of the recordings; leave out what the model does not have.\nband: [" +
             FormatNumber(std::floor(1e3 * lower_Hz) / 1e3) + " Hz, " + FormatNumber(std::ceil(1e3 * upper_Hz) / 1e3) +
             " Hz]\n";
  }

  std::string RecordingEntry(const FileReading& reading) const {
    const std::vector<double> shape = reading.motions.empty() ? std::vector<double>() : reading.motions.front().shape;
    const std::optional<std::string> pattern = shape.empty() ? std::nullopt : PatternOfShape(vehicle_, shape);
    std::string entry = "  - file: " + Relative(reading.path) + "\n    posts: ";
    if (pattern) entry += *pattern + "\n";
    else if (shape.empty()) entry += "heave  # look at: nothing says how the posts moved\n";
    else entry += Shares(shape) + "\n";
    return entry + TimesOf(reading) + PostLines(reading, "    post_channels: ", false);
  }

  std::string Shares(const std::vector<double>& shape) const {
    std::string text;
    for (std::size_t p = 0; p < shape.size(); ++p)
      text += (p > 0 ? ", " : "") + vehicle_.posts[p].name + ": " + ShortNumber(shape[p], 3);
    return "{" + text + "}";
  }

  /// Where names do not say which channels the posts' are. `recordings` take one channel of each.
  static std::string PostLines(const FileReading& reading, const std::string& key, bool takes_several) {
    if (!reading.actuators.empty()) {
      std::string list;
      for (const ChannelMatch& actuator : reading.actuators)
        list += (list.empty() ? "" : ", ") + actuator.name + ": " + SourceText(actuator.source);
      return "    actuators: {" + list + "}  # look at: tension is positive; posts rest\n";
    }
    if (std::all_of(reading.posts.begin(), reading.posts.end(), IsPostNamedSo)) return "";
    std::string text;
    for (const ChannelMatch& post : reading.posts)
      text += (text.empty() ? "" : ", ") + post.name + ": " +
              SourceText(takes_several ? post.source : ChannelSource{.channels = {post.source.channels.front()}});
    std::string doubts;
    for (const ChannelMatch& post : reading.posts)
      if (!post.IsSure()) doubts += (doubts.empty() ? "  # look at: " : "; ") + post.name + ": " + DoubtOf(post);
    return key + "{" + text + "}" + doubts + "\n";
  }

  void AddHistories() {
    std::string list;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      if (readings_[i].kind != Kind::kHistory) continue;
      drafted_[i].use = "histories";
      // A file may hold several drops.
      const std::size_t releases = readings_[i].is_release ? readings_[i].preparation.summary.releases.size() : 0;
      for (std::size_t number = 0; number < std::max<std::size_t>(1, releases); ++number)
        list += HistoryEntry(i, number, releases > 1);
    }
    if (list.empty()) return;
    text_ +=
        "\n# State the low-pass that the rig sent all channels through, if there was one: filter: {order: 4, "
        "cutoff: 30 Hz}\nhistories:\n" +
        list;
  }

  std::string HistoryEntry(std::size_t i, std::size_t number, bool has_number) const {
    const FileReading& reading = readings_[i];
    const std::vector<ChannelMatch>& matches = drafted_[i].matches;
    std::string entry = "  - file: " + Relative(reading.path) + "\n";
    if (has_number)
      entry += "    name: " + YamlText(reading.path.stem().string() + "_" + std::to_string(number + 1)) + "\n";
    entry += (shared_ ? "    use: validation  # stepped sines are fitted\n" : "") + TimesOf(reading) +
             (reading.is_release ? ReleaseLines(reading.preparation, matches, number)
                                 : PostLines(reading, "    posts: ", true)) +
             NoiseLines(reading.preparation, matches);
    const bool is_shared = shared_ && AreSame(matches, drafted_[*shared_].matches);
    const std::string lines = ChannelLines(matches, "      ");
    if (is_shared || (lines.empty() && !has_channels_)) return entry;
    return entry + "    channels:\n" + (lines.empty() ? "      others: by name\n" : lines);
  }

  void AddLoads() {
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      if (readings_[i].kind != Kind::kLoads) continue;
      std::string lines;
      for (const ChannelMatch& match : drafted_[i].matches)
        lines += "    " + match.name + ": " + SourceText(match.source) + '\n';
      drafted_[i].use = lines.empty() ? "no loads found for the tyres" : "static_loads";
      drafted_[i].is_used = !lines.empty();
      if (!lines.empty()) text_ += "\nstatic_loads:\n  file: " + Relative(readings_[i].path) + "\n  tyres:\n" + lines;
      return;
    }
  }

  /// Of a vehicle without posts, a damper between clamps.
  void AddBench() {
    BenchDraft bench(NamesOf(vehicle_.dampers));
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      if (readings_[i].kind != Kind::kBench) continue;
      drafted_[i].use = "bench";
      drafted_[i].channels_left.clear();
      drafted_[i].channels.clear();
      bench.Add(readings_[i], Relative(readings_[i].path), TimesOf(readings_[i]));
    }
    text_ += bench.Text();
  }

  void Check(StudyDraft& draft) const {
    if (std::none_of(drafted_.begin(), drafted_.end(), [](const DraftedFile& file) {
          return file.use == "recordings" || file.use == "histories" || file.use == "bench";
        }))
      return;
    const std::optional<LoadedStudy> loaded = LoadStudyText(draft.text, study_, draft.findings);
    if (!loaded) return;
    // Of releases it takes some seconds each.
    const bool has_release =
        std::any_of(readings_.begin(), readings_.end(), [](const FileReading& reading) { return reading.is_release; });
    if (has_release) hooks_.Note("checking the recordings: the start of each release is estimated, some seconds each");
    else hooks_.Show("checking the recordings against the vehicle");
    try {
      CheckRecordings(*loaded, Severity::kWarning, draft.findings);
    } catch (const FaultyInput& fault) {
      draft.findings.Add(fault.diagnostics());
    }
  }

  /// Of each channel whether its match is sure, and what would make it so.
  static std::string ChannelComments(const DraftedFile& file) {
    if (file.channels.empty()) return "";
    if (!file.same_as.empty())
      return "# " + file.path.filename().string() + ", channel by channel: as " + file.same_as + '\n';
    std::string text = "# " + file.path.filename().string() + ", channel by channel:\n";
    for (const DraftedChannel& channel : file.channels)
      text += "#   " + channel.name + (channel.of.empty() ? "" : " = " + channel.of) + ": " + StateName(channel.state) +
              (channel.why.empty() ? "" : "; " + channel.why) + '\n';
    if (!file.without_channel.empty()) text += "#   without a channel: " + Listed(file.without_channel) + '\n';
    return text;
  }

  /// What a user should know before the first line.
  std::string Head(const StudyDraft& draft) const {
    std::string text = "# Drafted from recordings by the names of channels, their units and how they move.\n";
    for (std::size_t i = 0; i < drafted_.size(); ++i) {
      const DraftedFile& file = drafted_[i];
      const std::string name = file.path.filename().string();
      if (!file.is_used) text += "# not used: " + name + ": " + file.use + '\n';
      text += ChannelComments(file);
      for (const std::string& missed : readings_[i].missed) text += "# look at: " + name + ": " + missed + '\n';
      if (IsSine(i) && shared_ && *shared_ != i && !AreSame(file.matches, drafted_[*shared_].matches))
        text += "# look at: channels of " + name + " are called otherwise than those of " +
                drafted_[*shared_].path.filename().string() + ", and a study has one set of names for both\n";
    }
    for (const Diagnostic& item : draft.findings.ByWeight()) {
      // Of a recording; what is at fault in the study itself stands in it.
      const std::string file = item.place.file == study_.string() ? "" : fs::path(item.place.file).filename().string();
      text += "# look at: " + (file.empty() ? "" : file + ": ") + item.message + " [" + item.id + "]\n";
    }
    return text;
  }

  const Vehicle& vehicle_;
  fs::path study_;
  const DraftStatements& stated_;
  const WorkHooks& hooks_;
  std::vector<FileReading> readings_;
  std::vector<DraftedFile> drafted_;
  /// The file whose channels are those of the study.
  std::optional<std::size_t> shared_;
  bool has_channels_ = false;
  std::string text_;
};

}  // namespace

StudyDraft DraftStudy(const std::vector<fs::path>& files, const Vehicle& vehicle, const fs::path& study,
                      const DraftStatements& stated, const WorkHooks& hooks) {
  return Drafter(files, vehicle, study, stated, hooks).Draft();
}

}  // namespace fourpost
