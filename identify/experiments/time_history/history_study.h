#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "analysis/files/time_recording.h"
#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/release.h"
#include "identify/study_file/channel_source.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/posts/recorded_posts.h"

namespace fourpost {

/// The standard deviation of what a sensor reads at rest, as written: "20 N".
struct StudyNoise {
  std::string sensor;
  std::string sd;
  int line = 0;
};

/// A recording over time of a vehicle on moving posts, as a study states it.
struct StudyHistory {
  std::string name;
  std::filesystem::path file;
  /// The column of times; one of the usual names when empty.
  std::optional<SourceChannel> time;
  /// Post of the vehicle, and the channels of its height.
  std::vector<std::pair<std::string, ChannelSource>> posts;
  /// Sensor of the vehicle, and what was measured for it.
  std::vector<std::pair<std::string, ChannelSource>> channels;
  /// Whether posts, and sensors that are not stated, are known by the names of channels.
  bool has_posts_by_name = false;
  bool takes_others_by_name = false;
  /// Of its times; files beside it are resolved.
  TimePreparation preparation;
  /// Whether heights of posts count from where they were recorded, not from their means.
  bool has_absolute_heights = false;
  /// Actuator of the vehicle, and the channels of its tension, or a constant one.
  std::vector<std::pair<std::string, ChannelSource>> actuators;
  std::vector<std::pair<std::string, double>> loads_N;
  /// Where the vehicle is let go at the start of the window; posts that are not named rest then.
  std::optional<Release> release;
  /// Of a control that parameters follow.
  std::optional<double> setting;
  /// Through which the rig sent all channels, heights of posts included.
  std::optional<LowPassDesign> filter;
  /// What sensors read at rest.
  std::vector<StudyNoise> noise;
  /// Of each coordinate's acceleration, white from sample to sample: what a Kalman filter takes for random. Turning
  /// coordinates take it in rad/s^2.
  std::optional<double> process_sd;
  /// Samples before and after do not count; the vehicle goes through them all the same.
  std::optional<double> start_s;
  std::optional<double> end_s;
  /// Not fitted, only predicted.
  bool is_validation = false;
  int line = 0;
};

/// What the residuals of histories are.
enum class HistoryCost {
  /// Differences over their deviations.
  kWhitened,
  /// The thesis's (4.29): mean square errors of the outputs weigh themselves, see CompromiseOf.
  kCompromise,
  /// The likelihood of a Kalman filter's innovations, see HistoryResiduals.
  kPrediction,
};
inline constexpr std::array<std::string_view, 3> kHistoryCostNames{"whitened", "compromise", "prediction"};

/// Those to fit, or those only to predict.
std::vector<StudyHistory> HistoriesOf(const std::vector<StudyHistory>& all, bool validation);

/// The list under `histories`; `channels` are those of histories that have none. Adds every fault to `diagnostics`.
std::vector<StudyHistory> ReadHistories(const YAML::Node& list, const YAML::Node& channels,
                                        const std::filesystem::path& study, Diagnostics& diagnostics);

/// Maps posts and sensors to channels of the same name, where the study leaves that to their names: a post's is called
/// as the post, or post_ and so; one post and one channel that begins with "post" need no more. Faults of the file are
/// left to LoadHistories().
void MapByName(const Vehicle& vehicle, StudyHistory& history);

}  // namespace fourpost
