#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/time_history/history_study.h"
#include "identify/study_file/control.h"
#include "vehicles/posts/recorded_posts.h"

namespace fourpost {

/// What was measured for one sensor of the vehicle, without its offset.
struct MeasuredSignal {
  std::size_t sensor = 0;
  std::string name;
  std::string unit;
  /// Samples of the window, their mean taken away.
  Eigen::VectorXd values;
  /// Of the noise that the study states; 0: none.
  double noise_sd = 0;
  /// Deviation of the loudest of its unit in the recording; 0: not known.
  double loudest = 0;
  /// Of the recording.
  ChannelSource source = {};
  /// Per sample, whether it was not measured: in a gap that is bridged, or clipped. Empty: all were measured.
  std::vector<char> is_unknown = {};

  double Deviation() const;

  /// A sample that was not measured.
  void LeaveOut(Eigen::Index k);

  /// What was measured; where nothing was, what the model gives, so that it weighs nothing: offsets of both are then
  /// equal over the other samples.
  Eigen::VectorXd MeasuredOr(const Eigen::Ref<const Eigen::VectorXd>& modelled) const;
  /// Of every `stride`-th sample, those that were not measured.
  Eigen::Index UnknownCount(Eigen::Index stride) const;
  /// Of rows at every `stride`-th sample, such as parts of the model: without their mean where there was a measurement,
  /// 0 elsewhere.
  void KeepMeasured(Eigen::Index stride, Eigen::MatrixXd& rows) const;
};

/// A recording over time in the terms of the vehicle. Sensors, posts too, have offsets that say nothing: those of posts
/// are their means over the record, those of outputs their means over the window, of model and measurement alike.
struct MeasuredHistory {
  std::string name;
  double rate_Hz = 0;
  /// With the rig's filter taken back.
  RecordedPosts posts;
  /// As recorded, without their means [m]; and the deviation of the noise in them, as stated or by NoiseFloor().
  std::vector<std::vector<double>> heights = {};
  std::vector<double> post_noise_sd = {};
  /// Per post, whether the study states it.
  std::vector<char> post_noise_is_stated = {};
  /// Tensions of the actuators [N], with their means.
  std::vector<std::vector<double>> tensions = {};
  std::optional<LowPassDesign> filter;
  /// From where the vehicle is let go at the first sample of the window.
  std::optional<Release> release = {};
  /// Of the vehicle's parameters, while it was recorded.
  ControlSetting setting = {};
  /// Of a Kalman filter's process, as the study states it [m/s^2]; 0: it does not.
  double process_sd = 0;
  /// First sample compared, of the record; and how many are. Samples that the filter keeps back at the end are left
  /// out.
  Eigen::Index first = 0;
  Eigen::Index count = 0;
  std::vector<MeasuredSignal> signals;
  /// What was done to the recording, a sentence each.
  std::vector<std::string> preparations = {};
  /// Samples of the window x signals: what the full geometry adds to the reduced model's signals, see
  /// full_correction.h; empty: nothing.
  Eigen::MatrixXd correction = {};

  /// The first sample of the window and the number of samples of its longest stretch in which all was measured.
  struct Stretch {
    Eigen::Index first = 0;
    Eigen::Index count = 0;
  };
  Stretch LongestMeasured() const;

  double TimeAt(Eigen::Index k) const { return posts.start_s + static_cast<double>(first + k) / rate_Hz; }

  /// Whether the tension of an actuator changes.
  bool HasMovingActuator() const;
  bool HasMovingPost() const;

  /// Residuals take every n-th sample: a filtered record sampled at three times the cut-off has all that passes
  /// it, and noise that is nearly independent from sample to sample.
  Eigen::Index Stride() const;
};

inline Eigen::VectorXd WithoutMean(const Eigen::VectorXd& values) { return values.array() - values.mean(); }

}  // namespace fourpost
