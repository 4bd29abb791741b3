#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/residuals/error_share.h"
#include "identify/study_file/channel_source.h"

namespace fourpost {

/// What is known of a channel without physics, see AddYardsticks(); [%] of its variance.
struct Yardstick {
  /// Of the best linear model from the inputs to the channel: its order, and the error of its predictions from each
  /// sample to the next and of its simulation.
  int order = 0;
  std::optional<double> one_step_nmse_percent = {};
  std::optional<double> nmse_percent = {};
  /// Share of the channel's power that follows linearly from the inputs.
  std::optional<double> coherence = {};
  /// What differs between recordings of one motion.
  std::optional<double> repeat_nmse_percent = {};

  /// The least error that either shows to be possible: more is the model's, less may be the data's.
  std::optional<double> Allowed_percent() const;
};

/// Of a channel of a time recording.
struct HistoryMisfit {
  std::string recording;
  std::string name;
  /// 100/(N var) sum of squared errors, var: the variance of the measured channel (thesis eq. 3.9); and the share of
  /// that variance that the model accounts for, 100 (1 - var(error)/var).
  double nmse_percent = 0;
  double vaf_percent = 0;
  /// Of a vehicle's: the least-squares answer of measured(t) = gain modelled(t - delay). A gain below zero is a wrong
  /// sign.
  std::optional<double> gain = {};
  std::optional<double> delay_s = {};
  /// What the error would be with these.
  std::optional<double> timed_nmse_percent = {};
  /// Of a Kalman filter that is corrected after each sample and predicts the next: always less than that of a
  /// simulation, also of a poor model. And the correlation of its errors from one sample to the next, 0 if they are
  /// white.
  std::optional<double> one_step_nmse_percent = {};
  std::optional<double> innovation_correlation = {};
  /// Of their first 25 autocorrelations, the share beyond what 95 % of those of white noise keep to: 0.05 if white.
  std::optional<double> innovations_beyond = {};
  /// Of what the model leaves, from one sample to the next; how many independent samples would say as much of a mean;
  /// and whether it is white, see WhitenessOf().
  double residual_correlation = 0;
  double effective_samples = 0;
  bool is_white = true;
  /// Residuals over noise and stated model error, of a cost that is whitened.
  std::optional<double> misfit = {};
  /// Of the reduced model, where the full geometry answered.
  std::optional<double> reduced_nmse_percent = {};
  /// The channel of the same unit that this one is measured like, while that one is measured like this: swapped.
  std::optional<std::string> swapped_with = {};
  /// Sum of squares of the measured channel about its mean.
  double measured_squares = 0;
  Yardstick yardstick = {};
  /// SI; empty of a damper on its bench.
  std::string unit = {};
  /// What the study takes it from.
  ChannelSource source = {};
  /// What moved the vehicle: posts alone, its release alone, or an actuator or a release beside posts.
  enum class Drive { kPosts, kRelease, kSeveral };
  Drive drive = Drive::kPosts;
  /// Of a displacement sensor and a release alone: what the vehicle was let go from above rest, with the model's sign.
  std::optional<double> released_from_m = {};
};

/// `residual`: measured less modelled, one sample after the other.
void JudgeNoise(const Eigen::VectorXd& residual, HistoryMisfit& misfit);

/// One per recording and channel.
std::vector<ErrorShare> ErrorShares(const std::vector<HistoryMisfit>& misfits);

}  // namespace fourpost
