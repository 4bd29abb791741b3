#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/engine/steady_response.h"

namespace fourpost {

/// By how much the linear kinematics of a fit are off in a recording of a stepped sine.
struct RunKinematics {
  std::string recording;
  /// Where they were compared.
  std::vector<double> frequency_Hz;
  /// Nothing where the balances did not converge; then why.
  std::optional<KinematicsError> error;
  std::string not_estimated;
};

/// The vehicle at these values in each run, at the lowest and the highest frequency, at that of the largest amplitude
/// and where the channels of each unit peak. Only sensors that were measured count.
std::vector<RunKinematics> CheckKinematics(const std::vector<MeasuredRun>& runs, const Vehicle& vehicle,
                                           const std::vector<double>& values);

}  // namespace fourpost
