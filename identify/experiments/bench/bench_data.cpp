#include "identify/experiments/bench/bench_data.h"

#include <algorithm>
#include <array>

#include "analysis/files/bridged_samples.h"
#include "analysis/files/near_file.h"
#include "analysis/files/recording_window.h"
#include "analysis/files/time_recording.h"
#include "analysis/signals/smoothed.h"
#include "analysis/signals/unfiltered.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "identify/experiments/bench/findings.h"
#include "identify/study_file/filter_rate.h"
#include "identify/study_file/source_recording.h"
#include "vehicles/bench/bench_unit_check.h"
#include "vehicles/bench/offset_check.h"
#include "vehicles/bench/recording_check.h"

namespace fourpost {
namespace {

/// Place in Vehicle::dampers.
std::optional<std::size_t> FindDamper(const BenchStudy& study, const std::string& file, const Vehicle& vehicle,
                                      Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Damper& damper : vehicle.dampers) names.push_back(damper.name);
  if (!study.damper && names.size() == 1) return 0;
  if (!study.damper) {
    if (names.empty()) diagnostics.Report(kBenchNoDamper, {file, study.line});
    else diagnostics.Report(kBenchDamperOpen, {file, study.line}, {std::to_string(names.size())});
    return std::nullopt;
  }
  const auto found = std::find(names.begin(), names.end(), *study.damper);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  diagnostics.Report(kBenchDamperUnknown, {file, study.line}, {*study.damper, DidYouMeanOrAll(*study.damper, names)});
  return std::nullopt;
}

/// What is left of the time before a recording, which the modelled filter did not see: less than a model misses.
constexpr double kForgotten = 1e-3;

/// Of displacement and force: what a force was at an unknown motion says nothing.
std::vector<BridgedGap> GapsOf(const TimeRecording& recording) {
  std::vector<BridgedGap> gaps = recording.gaps[0];
  gaps.insert(gaps.end(), recording.gaps[1].begin(), recording.gaps[1].end());
  return gaps;
}

/// `damper`: nothing where the vehicle has no such.
std::optional<BenchRecording> Load(const BenchStudy& study, const BenchStudy::Recording& from,
                                   const std::optional<BenchDamper>& damper, Diagnostics& diagnostics) {
  // Both ends may be drawn at one point.
  const double length_m = damper && damper->length_m() > 0 ? damper->length_m() : kLongestStroke_m;
  const std::array<RecordedChannel, 2> wanted = {
      AsRecorded(from.displacement.value_or(study.displacement), kLength, "the damper's extension"),
      AsRecorded(from.force.value_or(study.force), kForce, "the damper's tension")};
  std::optional<TimeRecording> read = ReadTimeRecording(
      from.file, wanted, diagnostics, TimeColumn(from.time ? from.time : study.time), from.preparation);
  if (!read) return std::nullopt;
  if (!CutToWindow(from.window, *read)) {
    diagnostics.Report(kBenchWindowOutside, {from.file.string()},
                       {std::to_string(kFewestInWindow), FormatNumber(read->start_s), FormatNumber(read->end_s)});
    return std::nullopt;
  }
  // Before anything else, which would be an effect of it.
  if (study.rig_filter && !CheckFilterRate(from.file.filename().string(), read->rate_Hz(), study.rig_filter->cutoff_Hz,
                                           {from.file.string()}, diagnostics))
    return std::nullopt;
  if (!CheckBenchRecording(*read, length_m, from.file.string(), diagnostics)) return std::nullopt;
  BenchRecording recording{.name = from.name,
                           .start_s = read->start_s,
                           .sample_s = read->step_s,
                           .motion = {},
                           .force = std::move(read->channels[1]),
                           .is_unknown = BridgedSamples(*read, GapsOf(*read)),
                           .preparations = std::move(read->preparations),
                           .filter = {},
                           .end = read->samples()};
  // Its noise would be differentiated.
  std::vector<double> displacement = WithoutNoise(read->channels[0]);
  if (study.rig_filter) {
    const double rate_Hz = 1 / recording.sample_s;
    recording.cutoff_Hz = study.rig_filter->cutoff_Hz;
    recording.filter = LowPass(study.rig_filter->order, study.rig_filter->cutoff_Hz, rate_Hz);
    displacement = Unfiltered(displacement, *recording.filter, study.rig_filter->cutoff_Hz / rate_Hz);
    recording.first = recording.filter->SettlingSamples(kForgotten);
    recording.end -= std::min(recording.end, recording.first);
    if (recording.first >= recording.end) {
      diagnostics.Report(kBenchFilterUnsettled, {from.file.string()});
      return std::nullopt;
    }
  }
  recording.motion = MotionThrough(displacement, recording.sample_s);
  return recording;
}

/// Against the damper at the file's values.
bool Check(const BenchDamper& damper, const BenchRecording& recording, const std::vector<double>& values,
           const std::string& file, Diagnostics& diagnostics) {
  if (!CheckBenchUnits(damper, recording.motion, recording.force, values, file, diagnostics)) return false;
  CheckBenchOffsets(damper, {recording.motion, recording.filter, recording.force, recording.first, recording.end},
                    values, file, diagnostics);
  return true;
}

}  // namespace

std::optional<BenchData> LoadBenchData(const BenchStudy& study, const std::string& study_file, const Vehicle& vehicle,
                                       Diagnostics& diagnostics, const Control& control) {
  BenchData data;
  const std::optional<std::size_t> damper = FindDamper(study, study_file, vehicle, diagnostics);
  bool good = damper.has_value();
  data.damper = damper.value_or(0);
  const std::vector<double> values = vehicle.ParameterValues();
  std::optional<BenchDamper> on_bench;
  if (damper) on_bench.emplace(vehicle, *damper);
  const auto load = [&](const BenchStudy::Recording& from, Diagnostics& found) {
    std::optional<BenchRecording> loaded = Load(study, from, on_bench, found);
    if (loaded) loaded->setting = SettingOf(control, from.setting, from.name, {study_file, from.line}, found);
    if (loaded && on_bench && !Check(*on_bench, *loaded, loaded->setting.At(values), from.file.string(), found))
      loaded.reset();
    return loaded;
  };
  for (const BenchStudy::Recording& recording : study.recordings) {
    std::optional<BenchRecording> loaded = load(recording, diagnostics);
    good = good && loaded;
    if (loaded) data.fitted.push_back(*std::move(loaded));
  }
  for (const BenchStudy::Recording& recording : study.validation) {
    Diagnostics found;
    std::optional<BenchRecording> loaded;
    if (RequireFile(recording.file, study_file, recording.line, found)) loaded = load(recording, found);
    if (std::optional<LeftOutRecording> out = LeftOutFor(found, recording.name, recording.file, diagnostics))
      data.left_out.push_back(*std::move(out));
    else if (loaded) data.validation.push_back(*std::move(loaded));
  }
  if (!good) return std::nullopt;
  return data;
}

std::vector<double> ModelledForce(const BenchDamper& damper, const BenchRecording& recording,
                                  const std::vector<double>& values) {
  std::vector<double> force = damper.Tensions(recording.motion, recording.setting.At(values));
  if (recording.filter) recording.filter->Apply(force);
  return force;
}

}  // namespace fourpost
