#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/time_history/history_data.h"

namespace fourpost {

/// What the errors of a model would be after a remedy in the study, before another fit.
class RemediedErrors {
 public:
  /// As of HistoryMisfits; both are kept by reference.
  RemediedErrors(const std::vector<MeasuredHistory>& histories, const std::vector<Eigen::MatrixXd>& modelled)
      : histories_(histories), modelled_(modelled) {}

  /// NormalisedMse_percent of a channel that is multiplied by `factor` and taken `delay_s` earlier, while both last.
  /// Throws std::out_of_range for a channel that is not there.
  double Percent(const std::string& recording, const std::string& channel, double factor, double delay_s) const;

 private:
  const std::vector<MeasuredHistory>& histories_;
  const std::vector<Eigen::MatrixXd>& modelled_;
};

}  // namespace fourpost
