#include "identify/experiments/four_post/four_post_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "analysis/files/near_file.h"
#include "analysis/files/time_recording.h"
#include "analysis/measured_response/findings.h"
#include "analysis/text/named.h"
#include "analysis/text/nearest.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/study_recording.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/named_channels.h"
#include "identify/study_file/own_fault.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

/// Root mean square over each value and its neighbours: with three repeats a frequency's own deviation is known to a
/// factor of two only, five frequencies give it to a quarter, and noise changes little from one to the next.
std::vector<double> PooledOverNeighbours(const std::vector<double>& values) {
  constexpr std::size_t kReach = 2;
  std::vector<double> pooled;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t first = i < kReach ? 0 : i - kReach;
    const std::size_t last = std::min(i + kReach, values.size() - 1);
    double sum = 0;
    for (std::size_t j = first; j <= last; ++j) sum += values[j] * values[j];
    pooled.push_back(std::sqrt(sum / static_cast<double>(last - first + 1)));
  }
  return pooled;
}

/// Standard deviations along and across the phasors of a channel.
struct PhasorDeviation {
  std::vector<double> radial;
  std::vector<double> tangential;
};

PhasorDeviation DeviationOf(const ChannelResponse& channel) {
  PhasorDeviation deviation;
  const std::size_t points = channel.response.size();
  deviation.radial = channel.gain_sd.empty() ? std::vector<double>(points, 0.0) : channel.gain_sd;
  for (std::size_t i = 0; i < points; ++i)
    deviation.tangential.push_back(
        channel.phase_sd_rad.empty() ? 0 : std::abs(channel.response[i]) * channel.phase_sd_rad[i]);
  return {PooledOverNeighbours(deviation.radial), PooledOverNeighbours(deviation.tangential)};
}

/// Deviations of the sum, along and across its own phasor, from which those of the sources are turned away.
void AddDeviations(const std::vector<ChannelResponse>& sources, double share, MeasuredChannel& sum) {
  sum.radial_sd.assign(sum.response.size(), 0);
  sum.tangential_sd.assign(sum.response.size(), 0);
  for (const ChannelResponse& source : sources) {
    const PhasorDeviation deviation = DeviationOf(source);
    for (std::size_t i = 0; i < sum.response.size(); ++i) {
      const double turn = std::arg(source.response[i]) - std::arg(sum.response[i]);
      const double c = share * std::abs(std::cos(turn));
      const double s = share * std::abs(std::sin(turn));
      sum.radial_sd[i] = std::hypot(sum.radial_sd[i], c * deviation.radial[i], s * deviation.tangential[i]);
      sum.tangential_sd[i] = std::hypot(sum.tangential_sd[i], s * deviation.radial[i], c * deviation.tangential[i]);
    }
  }
}

/// The channel with its sign, scale and delay put right, and deviations of the mean over repeats.
ChannelResponse Corrected(ChannelResponse response, const std::vector<double>& frequency_Hz,
                          const SourceChannel& channel, int repeats) {
  const double scale = std::abs(channel.factor);
  for (std::size_t i = 0; i < response.response.size(); ++i)
    response.response[i] *= std::polar(1.0, 2 * std::numbers::pi * frequency_Hz[i] * channel.delay_s) * channel.factor;
  const double of_mean = 1 / std::sqrt(static_cast<double>(repeats));
  for (double& sd : response.gain_sd) sd *= scale * of_mean;
  for (double& sd : response.phase_sd_rad) sd *= of_mean;
  for (double& mean : response.mean) mean *= channel.factor;
  for (double& sd : response.mean_sd) sd *= scale * of_mean;
  for (double& harmonic : response.second_harmonic) harmonic *= scale;
  return response;
}

/// Sum of channels with their noise independent; a mean is the sum over their number.
MeasuredChannel Combine(const std::vector<ChannelResponse>& sources, ChannelSource::Combine rule) {
  const std::size_t points = sources.front().response.size();
  const double share = rule == ChannelSource::Combine::kMean ? 1.0 / static_cast<double>(sources.size()) : 1.0;
  MeasuredChannel out;
  out.unit = sources.front().unit;
  out.response.assign(points, 0);
  // Struts only: the mean force of a tyre is its static load, whatever the damper does.
  const bool has_mean = out.unit == "m" && std::all_of(sources.begin(), sources.end(),
                                                       [](const ChannelResponse& c) { return !c.mean.empty(); });
  if (has_mean) out.mean.assign(points, 0);
  const bool has_mean_sd = has_mean && std::any_of(sources.begin(), sources.end(),
                                                   [](const ChannelResponse& c) { return !c.mean_sd.empty(); });
  if (has_mean_sd) out.mean_sd.assign(points, 0);
  const bool has_second = out.unit == "m" && std::all_of(sources.begin(), sources.end(), [](const ChannelResponse& c) {
                            return !c.second_harmonic.empty();
                          });
  if (has_second) out.second_harmonic.assign(points, 0);
  for (const ChannelResponse& source : sources)
    for (std::size_t i = 0; i < points; ++i) {
      out.response[i] += share * source.response[i];
      if (has_mean) out.mean[i] += share * source.mean[i];
      if (has_mean_sd && !source.mean_sd.empty())
        out.mean_sd[i] = std::hypot(out.mean_sd[i], share * source.mean_sd[i]);
      // Of struts that move alike; amplitudes have no phase to add by.
      if (has_second) out.second_harmonic[i] += share * source.second_harmonic[i];
    }
  AddDeviations(sources, share, out);
  return out;
}

class DataLoader {
 public:
  DataLoader(const FourPostPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics)
      : plan_(plan), vehicle_(vehicle), diagnostics_(diagnostics), file_(plan.file) {}

  std::vector<MeasuredRun> Load() {
    CheckChannelNames();
    if (plan_.channels.empty())
      diagnostics_.Report(kNoChannelByName, {file_}, {DidYouMeanOrAll("", NamesOf(vehicle_.sensors))});
    for (const StudyRecording& recording : plan_.recordings) LoadRun(recording);
    return std::move(runs_);
  }

 private:
  void CheckChannelNames() {
    const std::vector<std::string> sensors = NamesOf(vehicle_.sensors);
    for (const auto& [name, source] : plan_.channels)
      if (!IndexOf(name, sensors))
        diagnostics_.Report(kSineSensorUnknown, {file_, source.line}, {name, DidYouMeanOrAll(name, sensors)});
  }

  void LoadRun(const StudyRecording& recording) {
    MeasuredRun run;
    run.name = recording.name;
    run.excitation.shape = Shape(recording);
    // A pattern that these posts cannot make has been reported; the file's own faults are as well.
    const bool has_shape = !run.excitation.shape.empty();
    const std::optional<StudyResponse> read = ReadStudyRecording(
        recording, file_, plan_.channels, has_shape ? NamesOf(vehicle_.posts) : std::vector<std::string>(),
        run.excitation.shape, diagnostics_);
    if (!read) return;
    const FrequencyResponse* const measured = &read->response;
    run.preparations = read->preparations;
    run.excitation.frequency_Hz = measured->frequency_Hz;
    run.excitation.amplitude_m = measured->amplitude_m;
    const std::vector<std::string> sensors = NamesOf(vehicle_.sensors);
    for (const auto& [name, source] : plan_.channels) {
      const std::vector<ChannelResponse> channels = FindChannels(recording, source, *measured);
      const std::optional<std::size_t> sensor = IndexOf(name, sensors);
      if (channels.size() != source.channels.size() || channels.empty() || !sensor) continue;
      if (!HaveUnit(channels, vehicle_.sensors[*sensor], source)) continue;
      MeasuredChannel channel = Combine(channels, source.combine);
      channel.has_opposed_members = HasOpposedMembers(channels, source, name);
      channel.name = name;
      channel.sensor = *sensor;
      for (const SourceChannel& one : source.channels)
        if (one.delay_s != 0) run.preparations.push_back(DelayTakenBack(one.name, one.delay_s));
      CheckDeviations(channel, source);
      run.channels.push_back(std::move(channel));
    }
    runs_.push_back(std::move(run));
  }

  std::vector<double> Shape(const StudyRecording& recording) {
    return recording.pattern ? PatternShape(recording) : SharesOfPosts(recording);
  }

  std::vector<double> PatternShape(const StudyRecording& recording) {
    try {
      return PostPattern(vehicle_, *recording.pattern);
    } catch (const PatternError& fault) {
      diagnostics_.Report(*fault.found().kind, {file_, recording.line}, fault.found().words);
      return {};
    }
  }

  std::vector<double> SharesOfPosts(const StudyRecording& recording) {
    const std::vector<std::string> posts = NamesOf(vehicle_.posts);
    std::vector<double> shape(posts.size(), 0.0);
    std::vector<bool> stated(posts.size(), false);
    for (const auto& [name, share] : recording.posts) {
      const std::optional<std::size_t> post = IndexOf(name, posts);
      if (!post) {
        diagnostics_.Report(kSinePostUnknown, {file_, recording.line}, {name, DidYouMeanOrAll(name, posts)});
        continue;
      }
      shape[*post] = share;
      stated[*post] = true;
    }
    for (std::size_t i = 0; i < posts.size(); ++i)
      if (!stated[i]) diagnostics_.Report(kPostShareMissing, {file_, recording.line}, {recording.name, posts[i]});
    return shape;
  }

  std::vector<ChannelResponse> FindChannels(const StudyRecording& recording, const ChannelSource& source,
                                            const FrequencyResponse& measured) {
    std::vector<ChannelResponse> found;
    for (const SourceChannel& wanted : source.channels) {
      const std::string& name = wanted.name;
      if (const ChannelResponse* channel = measured.Find(name))
        found.push_back(Corrected(*channel, measured.frequency_Hz, wanted, recording.repeats));
      else
        diagnostics_.Report(kSineChannelMissing, {file_, source.line},
                            {recording.file.filename().string(), name, DidYouMean(name, NamesOf(measured.channels))});
    }
    return found;
  }

  bool HaveUnit(const std::vector<ChannelResponse>& channels, const Sensor& sensor, const ChannelSource& source) {
    const std::string unit = UnitOf(sensor.type);
    bool good = true;
    for (const ChannelResponse& channel : channels) {
      if (channel.unit == unit) continue;
      // Once for all recordings.
      if (reported_units_.insert({sensor.name, channel.name, channel.unit}).second)
        diagnostics_.Report(kSineUnitsDiffer, {file_, source.line}, {channel.name, channel.unit, sensor.name, unit});
      good = false;
    }
    return good;
  }

  /// A sensor of the vehicle that stands for several measured ones has them move alike. Whether they do not.
  bool HasOpposedMembers(const std::vector<ChannelResponse>& channels, const ChannelSource& source,
                         const std::string& name) {
    constexpr double kOpposite = -0.4;
    bool any = false;
    for (std::size_t c = 1; c < channels.size(); ++c) {
      std::complex<double> product;
      double first = 0;
      double other = 0;
      for (std::size_t i = 0; i < channels[0].response.size(); ++i) {
        product += std::conj(channels[0].response[i]) * channels[c].response[i];
        first += std::norm(channels[0].response[i]);
        other += std::norm(channels[c].response[i]);
      }
      if (!(product.real() < kOpposite * std::sqrt(first * other))) continue;
      any = true;
      // Once for all recordings.
      if (reported_opposed_.insert({name, c}).second)
        diagnostics_.Report(kMembersOpposed, {file_, source.line},
                            {channels[0].name, channels[c].name, name,
                             source.combine == ChannelSource::Combine::kMean ? "mean" : "sum"});
    }
    return any;
  }

  /// Residuals need a deviation to be weighted by.
  void CheckDeviations(const MeasuredChannel& channel, const ChannelSource& source) {
    const auto none = [](double model_error, const std::vector<double>& sd) {
      return model_error == 0 && std::find(sd.begin(), sd.end(), 0.0) != sd.end();
    };
    if (none(plan_.model_error.gain_dB, channel.radial_sd) || none(plan_.model_error.phase_rad, channel.tangential_sd))
      diagnostics_.Report(kSineWithoutWeight, {file_, source.line}, {channel.name});
  }

  const FourPostPlan& plan_;
  const Vehicle& vehicle_;
  Diagnostics& diagnostics_;
  std::string file_;
  std::vector<MeasuredRun> runs_;
  /// By name of the study and place among its channels.
  std::set<std::pair<std::string, std::size_t>> reported_opposed_;
  /// Sensor, channel and its unit.
  std::set<std::array<std::string, 3>> reported_units_;
};

template <typename Value>
std::vector<Value> Kept(const std::vector<Value>& values, const std::vector<bool>& keep) {
  std::vector<Value> kept;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (keep[i]) kept.push_back(values[i]);
  return kept;
}

}  // namespace

void AddChannelsByName(const Vehicle& vehicle, FourPostPlan& plan) {
  if (!plan.takes_others_by_name) return;
  plan.takes_others_by_name = false;
  std::vector<std::string> common = NamesOf(vehicle.sensors);
  for (const StudyRecording& recording : plan.Stated()) {
    Diagnostics left_to_loading;
    const std::optional<RecordedTable> table = ReadRecordedTable(recording.file, left_to_loading);
    if (!table) continue;
    std::vector<std::string> recorded = ChannelNames(*table);
    for (const OtherFile& other : recording.preparation.others)
      if (const std::optional<RecordedTable> beside = ReadRecordedTable(other.path, left_to_loading))
        recorded.insert(recorded.end(), beside->names().begin(), beside->names().end());
    std::erase_if(common, [&](const std::string& name) { return !IndexOf(name, recorded); });
  }
  AddByName(common, common, plan.Stated().empty() ? 0 : plan.Stated().front().line, plan.channels);
}

std::vector<MeasuredRun> LoadRuns(const FourPostPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics) {
  return DataLoader(plan, vehicle, diagnostics).Load();
}

std::vector<MeasuredRun> LoadValidationRuns(const FourPostPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics,
                                            std::vector<LeftOutRecording>& left_out) {
  std::vector<MeasuredRun> loaded;
  for (const StudyRecording& recording : plan.validation) {
    Diagnostics found;
    FourPostPlan alone = plan;
    alone.recordings = {recording};
    std::vector<MeasuredRun> runs;
    if (RequireFile(recording.file, plan.file, recording.line, found)) runs = LoadRuns(alone, vehicle, found);
    for (const MeasuredRun& run : InBand(runs, plan.band_lower_Hz, plan.band_upper_Hz))
      if (run.excitation.frequency_Hz.empty())
        found.Report(kBandWithoutFrequency, {plan.file, plan.band_line}, {run.name});
    found = WithoutOwnFaults(found, {&kSinePostUnknown, &kResponsePostMissing}, diagnostics);
    if (std::optional<LeftOutRecording> out = LeftOutFor(found, recording.name, recording.file, diagnostics))
      left_out.push_back(*std::move(out));
    else
      for (MeasuredRun& run : runs) {
        run.is_validation = true;
        loaded.push_back(std::move(run));
      }
  }
  return loaded;
}

bool IsInBand(double frequency_Hz, double lower_Hz, double upper_Hz) {
  // Frequencies of dwells are measured, those of a band are round.
  constexpr double kMeasured = 1e-3;
  return frequency_Hz >= (1 - kMeasured) * lower_Hz && frequency_Hz <= (1 + kMeasured) * upper_Hz;
}

std::vector<FrequencyResponse> InBand(const std::vector<FrequencyResponse>& modelled, double lower_Hz,
                                      double upper_Hz) {
  std::vector<FrequencyResponse> out = modelled;
  for (FrequencyResponse& response : out) {
    std::vector<bool> keep;
    for (const double f : response.frequency_Hz) keep.push_back(IsInBand(f, lower_Hz, upper_Hz));
    response.frequency_Hz = Kept(response.frequency_Hz, keep);
    response.amplitude_m = Kept(response.amplitude_m, keep);
    for (ChannelResponse& channel : response.channels) {
      channel.response = Kept(channel.response, keep);
      channel.mean = Kept(channel.mean, keep);
      channel.second_harmonic = Kept(channel.second_harmonic, keep);
    }
  }
  return out;
}

MeasuredRun AtFrequencies(const MeasuredRun& run, const std::vector<bool>& keep) {
  MeasuredRun part = run;
  part.excitation.frequency_Hz = Kept(run.excitation.frequency_Hz, keep);
  part.excitation.amplitude_m = Kept(run.excitation.amplitude_m, keep);
  for (MeasuredChannel& channel : part.channels) {
    channel.response = Kept(channel.response, keep);
    channel.radial_sd = Kept(channel.radial_sd, keep);
    channel.tangential_sd = Kept(channel.tangential_sd, keep);
    if (!channel.mean.empty()) channel.mean = Kept(channel.mean, keep);
    if (!channel.mean_sd.empty()) channel.mean_sd = Kept(channel.mean_sd, keep);
    if (!channel.second_harmonic.empty()) channel.second_harmonic = Kept(channel.second_harmonic, keep);
  }
  return part;
}

std::vector<MeasuredRun> InBand(const std::vector<MeasuredRun>& runs, double lower_Hz, double upper_Hz) {
  std::vector<MeasuredRun> out;
  for (const MeasuredRun& run : runs) {
    std::vector<bool> keep;
    for (const double f : run.excitation.frequency_Hz) keep.push_back(IsInBand(f, lower_Hz, upper_Hz));
    out.push_back(AtFrequencies(run, keep));
  }
  return out;
}

}  // namespace fourpost
