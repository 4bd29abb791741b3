#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/time_history/history_data.h"
#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// Noise in the recorded heights of the posts, over frequency. The vehicle moves with the posts and not with their
/// noise: through its equations that noise appears in the residuals of all channels at once. Where the spectra between
/// channels agree with that they say how large it is. What follows the recorded posts linearly is taken out before,
/// since noise does not and errors of the model do.
struct PostNoise {
  /// Upper ends of the bands [Hz], ascending, the last at half the rate.
  std::vector<double> ends_Hz;
  /// Per post, per band [m^2/Hz], one-sided.
  std::vector<std::vector<double>> density;

  bool IsAny() const;
};

/// White noise of `history.post_noise_sd`; of posts whose noise the study does not state as the residuals of two
/// channels or more show it. `modelled`: samples of the window x signals, at the values of `model`; `step_s`: of the
/// condensed stepper. Throws as HistorySimulation::Run() does.
PostNoise PostNoiseOf(const MeasuredHistory& history, const CondensedModel& model, const Eigen::MatrixXd& modelled,
                      double step_s);

/// The same history with noise of these spectra added to the heights, `sign` times that of this seed.
MeasuredHistory WithPostNoise(const MeasuredHistory& history, const PostNoise& noise, std::uint64_t seed, double sign);

}  // namespace fourpost
