#include "identify/experiments/time_history/history_data.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "analysis/files/bridged_samples.h"
#include "analysis/files/near_file.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/sample_times.h"
#include "analysis/files/time_recording.h"
#include "analysis/signals/clipping.h"
#include "analysis/signals/dead_signal.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/noise_floor.h"
#include "analysis/signals/signal_levels.h"
#include "analysis/text/counted.h"
#include "analysis/text/enumeration.h"
#include "analysis/text/named.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/experiments/time_history/history_names.h"
#include "identify/experiments/time_history/motionless_signals.h"
#include "identify/experiments/time_history/post_sampling.h"
#include "identify/experiments/time_history/signal_breaks.h"
#include "identify/experiments/time_history/signal_drifts.h"
#include "identify/experiments/time_history/unknown_input.h"
#include "identify/study_file/filter_rate.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/own_fault.h"
#include "identify/study_file/source_recording.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Eigen::Index;

std::optional<std::size_t> IndexOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

class HistoryLoader {
 public:
  HistoryLoader(const StudyHistory& study, const std::string& file, const Vehicle& vehicle, const Control& control,
                Diagnostics& diagnostics)
      : study_(study),
        control_(control),
        file_(file),
        vehicle_(vehicle),
        diagnostics_(diagnostics),
        posts_(NamesOf(vehicle.posts)),
        sensors_(NamesOf(vehicle.sensors)),
        actuators_(NamesOf(vehicle.actuators)),
        post_noise_(vehicle.posts.size()),
        post_gaps_(vehicle.posts.size()),
        actuator_gaps_(vehicle.actuators.size()) {}

  std::optional<MeasuredHistory> Load() {
    good_ = CheckHistoryNames(study_, file_, vehicle_, diagnostics_);
    for (const auto& [post, source] : study_.posts) Want(source, kLength, "the height of post '" + post + "'");
    for (const auto& [actuator, source] : study_.actuators)
      Want(source, kForce, "the tension of actuator '" + actuator + "'");
    for (const auto& [sensor, source] : study_.channels)
      if (const auto index = IndexOf(sensor, sensors_))
        Want(source, ParseUnit(UnitOf(vehicle_.sensors[*index].type))->dimension, "sensor '" + sensor + "'");
    const std::vector<double> noise = ReadNoise();
    const std::optional<TimeRecording> recording =
        ReadTimeRecording(study_.file, wanted_, diagnostics_, TimeColumn(study_.time), study_.preparation);
    if (!good_ || !recording) return std::nullopt;
    MeasuredHistory history{
        .name = study_.name,
        .rate_Hz = recording->rate_Hz(),
        .filter = study_.filter,
        .release = study_.release,
        .setting = SettingOf(control_, study_.setting, study_.name, {file_, study_.line}, diagnostics_),
        .process_sd = study_.process_sd.value_or(0)};
    history.preparations = recording->preparations;
    if (study_.has_absolute_heights) history.preparations.emplace_back("heights of posts as recorded");
    CheckRate(history.rate_Hz);
    SetWindow(*recording, history);
    if (!good_) return std::nullopt;
    history.heights = Heights(*recording);
    history.tensions = Tensions(*recording);
    if (history.release) Find(*history.release);
    history.posts = posts_.empty() && actuators_.empty()
                        ? NoPosts(*recording)
                        : FollowHeights(history.heights, recording->start_s, recording->step_s,
                                        study_.filter ? &*study_.filter : nullptr, history.tensions);
    for (std::size_t p = 0; p < posts_.size(); ++p) {
      // Posts that the study does not name rest.
      const bool is_known = post_noise_[p].has_value() || study_.posts.empty();
      history.post_noise_sd.push_back(is_known ? post_noise_[p].value_or(0) : NoiseFloor(history.heights[p]));
      history.post_noise_is_stated.push_back(is_known);
      CheckPost(p, history);
    }
    AddSignals(*recording, noise, history);
    ReportSpikes(history, file_, diagnostics_);
    ReportDrifts(history, file_, diagnostics_);
    if (good_) LeaveOutUnknownInputs(*recording, history);
    return history;
  }

 private:
  void Fault(const Finding& finding, int line, const std::vector<std::string>& words) {
    diagnostics_.Report(finding, {file_, line}, words);
    good_ = false;
  }

  /// Its sensors in the vehicle.
  void Find(Release& release) const {
    for (Release::Hold& hold : release.held) hold.index = *IndexOf(hold.sensor, sensors_);
  }

  static RecordedPosts NoPosts(const TimeRecording& recording) {
    return {.motion = [](double, std::span<PostState>) {},
            .start_s = recording.start_s,
            .end_s = recording.end_s,
            .step_s = recording.step_s};
  }

  std::vector<std::vector<double>> Tensions(const TimeRecording& recording) {
    std::vector<std::vector<double>> tensions(actuators_.size(), std::vector<double>(recording.samples()));
    for (const auto& [actuator, source] : study_.actuators) {
      const CombinedChannels tension = Combined(recording, source);
      tensions[*IndexOf(actuator, actuators_)].assign(tension.values.begin(), tension.values.end());
      actuator_gaps_[*IndexOf(actuator, actuators_)] = tension.gaps;
    }
    for (const auto& [actuator, load] : study_.loads_N)
      tensions[*IndexOf(actuator, actuators_)].assign(recording.samples(), load);
    return tensions;
  }

  void Want(const ChannelSource& source, const Dimension& dimension, const std::string& what) {
    for (const SourceChannel& channel : source.channels) wanted_.push_back(AsRecorded(channel, dimension, what));
  }

  std::vector<double> ReadNoise() {
    std::vector<double> noise(sensors_.size());
    for (const StudyNoise& stated : study_.noise) {
      const std::optional<std::size_t> sensor = IndexOf(stated.sensor, sensors_);
      if (const std::optional<std::size_t> post = IndexOf(stated.sensor, posts_); post && !sensor) {
        post_noise_[*post] = ReadDeviation(stated, "m");
        continue;
      }
      if (!sensor) {
        Fault(kHistorySensorUnknown, stated.line, {stated.sensor, DidYouMeanOrAll(stated.sensor, sensors_)});
        continue;
      }
      noise[*sensor] = ReadDeviation(stated, UnitOf(vehicle_.sensors[*sensor].type));
    }
    return noise;
  }

  double ReadDeviation(const StudyNoise& stated, const std::string& unit) {
    const std::optional<Quantity> sd = ParseRecordedQuantity(stated.sd);
    if (sd && sd->unit.dimension == ParseUnit(unit)->dimension && sd->si >= 0) return sd->si;
    Fault(kNoiseUnreadable, stated.line, {stated.sensor, unit, stated.sd});
    return 0;
  }

  void CheckRate(double rate_Hz) {
    if (study_.filter && !CheckFilterRate(study_.file.filename().string(), rate_Hz, study_.filter->cutoff_Hz,
                                          {file_, study_.line}, diagnostics_))
      good_ = false;
  }

  void SetWindow(const TimeRecording& recording, MeasuredHistory& history) {
    const auto sample = [&](double t) { return (t - recording.start_s) * history.rate_Hz; };
    const auto samples = static_cast<double>(recording.samples());
    double end = samples - 1;
    if (study_.filter) end -= study_.filter->UnknownEnd_s() * history.rate_Hz;
    if (study_.end_s) end = std::min(end, sample(*study_.end_s));
    const double start = study_.start_s ? std::max(0.0, sample(*study_.start_s)) : 0;
    history.first = static_cast<Index>(std::ceil(start - 1e-6));
    history.count = static_cast<Index>(std::floor(end + 1e-6)) - history.first + 1;
    // Less is no history.
    constexpr Index kLeast = 16;
    if (history.count < kLeast)
      Fault(kHistoryWindowOutside, study_.line,
            {study_.name, study_.file.filename().string(), FormatNumber(recording.start_s),
             FormatNumber(recording.end_s)});
    else if (study_.start_s || study_.end_s)
      history.preparations.push_back(
          CutTo(recording.time_s(static_cast<std::size_t>(history.first)),
                recording.time_s(static_cast<std::size_t>(history.first + history.count - 1))));
  }

  struct CombinedChannels {
    Eigen::VectorXd values;
    std::vector<BridgedGap> gaps;
    /// Name of a channel that is dead; empty without one.
    std::string dead;
  };

  /// Sum or mean of its channels.
  CombinedChannels Combined(const TimeRecording& recording, const ChannelSource& source) {
    CombinedChannels all = {
        .values = Eigen::VectorXd::Zero(static_cast<Index>(recording.samples())), .gaps = {}, .dead = {}};
    for (std::size_t k = 0; k < source.channels.size(); ++k, ++next_) {
      all.values += Eigen::Map<const Eigen::VectorXd>(recording.channels[next_].data(), all.values.size());
      if (IsDead(recording.channels[next_]) && !MovesPosts(source.channels[k].name)) all.dead = source.channels[k].name;
      all.gaps.insert(all.gaps.end(), recording.gaps[next_].begin(), recording.gaps[next_].end());
    }
    if (source.combine == ChannelSource::Combine::kMean) all.values /= static_cast<double>(source.channels.size());
    return all;
  }

  /// The height of a post that rests is no dead channel.
  bool MovesPosts(const std::string& channel) const {
    return std::any_of(study_.posts.begin(), study_.posts.end(), [&](const auto& post) {
      const std::vector<SourceChannel>& channels = post.second.channels;
      return std::any_of(channels.begin(), channels.end(), [&](const auto& one) { return one.name == channel; });
    });
  }

  static void LeaveOutGaps(const std::vector<BridgedGap>& gaps, const TimeRecording& recording,
                           const MeasuredHistory& history, MeasuredSignal& signal) {
    const std::vector<char> is_bridged = BridgedSamples(recording, gaps);
    for (Index k = 0; k < history.count && !is_bridged.empty(); ++k)
      if (is_bridged[static_cast<std::size_t>(history.first + k)]) signal.LeaveOut(k);
  }

  std::vector<std::vector<double>> Heights(const TimeRecording& recording) {
    std::vector<std::vector<double>> heights(posts_.size(), std::vector<double>(recording.samples()));
    for (const auto& [post, source] : study_.posts) {
      const CombinedChannels recorded = Combined(recording, source);
      const Eigen::VectorXd height = study_.has_absolute_heights ? recorded.values : WithoutMean(recorded.values);
      if (const std::optional<double> upper_Hz = SampledTooSlowly(height, recording.rate_Hz(), study_.filter))
        diagnostics_.Report(kPostSampledTooSlowly, {file_, study_.line},
                            {post, study_.name, FormatNumber(std::round(10 * *upper_Hz) / 10),
                             ShortNumber(recording.rate_Hz(), 4), FormatNumber(kLeastSamplesAPeriod)});
      heights[*IndexOf(post, posts_)].assign(height.begin(), height.end());
      post_gaps_[*IndexOf(post, posts_)] = recorded.gaps;
    }
    return heights;
  }

  void AddSignals(const TimeRecording& recording, const std::vector<double>& noise, MeasuredHistory& history) {
    bool has_dead = false;
    for (const auto& [name, source] : study_.channels) {
      const std::size_t sensor = *IndexOf(name, sensors_);
      const CombinedChannels combined = Combined(recording, source);
      if (!combined.dead.empty()) {
        has_dead = true;
        diagnostics_.Report(kChannelOnlyNoise, {file_, source.line}, {combined.dead, history.name, name});
        continue;
      }
      const Eigen::VectorXd& all = combined.values;
      MeasuredSignal signal{.sensor = sensor,
                            .name = name,
                            .unit = UnitOf(vehicle_.sensors[sensor].type),
                            .values = WithoutMean(all.segment(history.first, history.count)),
                            .noise_sd = noise[sensor],
                            .source = source};
      if (signal.Deviation() == 0) Fault(kChannelDead, source.line, {name, study_.file.filename().string()});
      LeaveOutGaps(combined.gaps, recording, history, signal);
      if (CheckSaturation(history, all, signal)) history.signals.push_back(std::move(signal));
    }
    if (history.signals.empty())
      Fault(has_dead ? kHistoryMotionless : kHistoryAllSaturated, study_.line, {study_.name});
    FindLoudest(history.signals);
    for (const MotionlessSignal& signal : TakeMotionless(history))
      diagnostics_.Report(kChannelMotionless, {file_, signal.line},
                          {signal.name, history.name, signal.rms, signal.largest_rms});
    if (history.signals.empty() && good_) Fault(kHistoryMotionless, study_.line, {study_.name});
  }

  /// Posts first, then actuators; of each kind the loudest says what shows.
  void LeaveOutUnknownInputs(const TimeRecording& recording, MeasuredHistory& history) {
    constexpr double kShare = 0.01;
    constexpr double kDeviations = 3;
    std::vector<BridgedGap> gaps;
    std::vector<std::string> names;
    const auto look = [&](const std::vector<std::string>& of, const std::vector<std::vector<double>>& inputs,
                          const std::vector<double>& noise_sd, const std::vector<std::vector<BridgedGap>>& bridged) {
      double loudest = 0;
      for (const std::vector<double>& input : inputs) loudest = std::max(loudest, DeviationOf(input));
      for (std::size_t i = 0; i < of.size(); ++i) {
        const double unseen =
            bridged[i].empty() ? 0 : std::max({kShare * loudest, kDeviations * noise_sd[i], 2 * LevelOf(inputs[i])});
        const std::vector<BridgedGap> visible = VisibleGaps(recording, inputs[i], unseen, bridged[i]);
        if (!visible.empty()) names.push_back("'" + of[i] + "'");
        gaps.insert(gaps.end(), visible.begin(), visible.end());
      }
    };
    std::vector<double> of_tensions;
    for (const std::vector<double>& tension : history.tensions) of_tensions.push_back(NoiseFloor(tension));
    look(posts_, history.heights, history.post_noise_sd, post_gaps_);
    look(actuators_, history.tensions, of_tensions, actuator_gaps_);
    const std::vector<BridgedGap> closed_up = ClosedUpTimes(history);
    if (!closed_up.empty())
      diagnostics_.Report(kTimesClosedUp, {file_, study_.line},
                          {study_.file.filename().string(), SecondsText(closed_up.front().from_s),
                           closed_up.size() > 1 ? " and in " + Counted(closed_up.size() - 1, "later place") : ""});
    gaps.insert(gaps.end(), closed_up.begin(), closed_up.end());
    if (gaps.empty()) return;
    if (names.empty()) names.push_back("the posts' motion");
    const UnknownMotion unknown = LeaveOutMotion(vehicle_, std::move(gaps), history);
    if (unknown.samples == 0) return;
    constexpr Index kLeast = 16;
    if (history.count - unknown.samples < kLeast)
      return Fault(kInputNeverKnown, study_.line, {Enumeration(names), history.name});
    const double share = static_cast<double>(unknown.samples) / static_cast<double>(history.count);
    diagnostics_.Report(kInputUnknown, {file_, study_.line},
                        {Enumeration(names), history.name, SecondsText(unknown.gaps.front().from_s),
                         SecondsText(unknown.gaps.front().to_s),
                         unknown.gaps.size() > 1 ? " and in " + Counted(unknown.gaps.size() - 1, "later gap") : "",
                         ShortNumber(unknown.settled_s, 2), ShortNumber(100 * share, 2)});
  }

  /// Of the window, whose saturated samples are left out: what they should have read is not known. False where the
  /// channel is.
  bool CheckSaturation(const MeasuredHistory& history, const Eigen::VectorXd& all, MeasuredSignal& signal) {
    const std::span<const double> values(all.data() + history.first, static_cast<std::size_t>(history.count));
    const std::optional<ClippedEnds> ends = ClippingAtEnds(values);
    if (!ends) return true;
    const double first_s = history.TimeAt(static_cast<Index>(ends->first()));
    const bool is_left_out = study_.is_validation && ends->is_exact();
    diagnostics_.Report(is_left_out        ? kSaturatedLeftOut
                        : ends->is_exact() ? kSamplesSaturated
                                           : kChannelSaturated,
                        {file_, signal.source.line},
                        {signal.name, ends->Text(signal.unit, first_s), study_.file.filename().string()});
    if (ends->is_exact())
      for (Index k = 0; k < history.count; ++k)
        if (ends->IsExactAt(all[history.first + k])) signal.LeaveOut(k);
    return !is_left_out;
  }

  /// A post may well stand, at the end of a ramp, but not exactly where its transducer has noise.
  void CheckPost(std::size_t post, const MeasuredHistory& history) {
    if (history.heights[post].empty()) return;
    const auto window = std::span(history.heights[post])
                            .subspan(static_cast<std::size_t>(history.first), static_cast<std::size_t>(history.count));
    if (history.post_noise_sd[post] <= LevelOf(window)) return;
    const std::optional<ClippedEnds> ends = ClippingAtEnds(window);
    if (ends && ends->is_exact())
      diagnostics_.Report(kPostSaturated, {file_, study_.line},
                          {posts_[post], ends->Text("m", history.TimeAt(static_cast<Index>(ends->first()))),
                           study_.file.filename().string()});
  }

  const StudyHistory& study_;
  const Control& control_;
  const std::string& file_;
  const Vehicle& vehicle_;
  Diagnostics& diagnostics_;
  std::vector<std::string> posts_;
  std::vector<std::string> sensors_;
  std::vector<std::string> actuators_;
  /// As stated.
  std::vector<std::optional<double>> post_noise_;
  std::vector<std::vector<BridgedGap>> post_gaps_;
  std::vector<std::vector<BridgedGap>> actuator_gaps_;
  std::vector<RecordedChannel> wanted_;
  /// Channel of the recording to take next.
  std::size_t next_ = 0;
  bool good_ = true;
};

}  // namespace

std::optional<std::vector<MeasuredHistory>> LoadHistories(const std::vector<StudyHistory>& histories,
                                                          const std::string& study_file, const Vehicle& vehicle,
                                                          Diagnostics& diagnostics, const Control& control) {
  std::vector<MeasuredHistory> loaded;
  for (const StudyHistory& study : histories)
    if (std::optional<MeasuredHistory> history = HistoryLoader(study, study_file, vehicle, control, diagnostics).Load())
      loaded.push_back(std::move(*history));
  if (diagnostics.HasErrors()) return std::nullopt;
  return loaded;
}

std::vector<MeasuredHistory> LoadValidation(const std::vector<StudyHistory>& histories, const std::string& study_file,
                                            const Vehicle& vehicle, Diagnostics& diagnostics,
                                            std::vector<LeftOutRecording>& left_out, const Control& control) {
  std::vector<MeasuredHistory> loaded;
  for (const StudyHistory& study : histories) {
    Diagnostics found;
    std::optional<MeasuredHistory> history;
    if (RequireFile(study.file, study_file, study.line, found))
      history = HistoryLoader(study, study_file, vehicle, control, found).Load();
    found = WithoutOwnFaults(found, {&kHistoryPostUnknown}, diagnostics);
    if (std::optional<LeftOutRecording> out = LeftOutFor(found, study.name, study.file, diagnostics))
      left_out.push_back(*std::move(out));
    else if (history) loaded.push_back(std::move(*history));
  }
  return loaded;
}

}  // namespace fourpost
