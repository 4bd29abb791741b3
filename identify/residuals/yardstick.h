#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/residuals/history_misfit.h"
#include "identify/study_file/control.h"

namespace fourpost {

/// What a recording moves a vehicle or a damper by, and what is measured; of one length.
struct YardstickRecord {
  std::string name;
  double rate_Hz = 0;
  /// Recordings of unlike settings are of unlike systems.
  ControlSetting setting = {};
  /// Whether means are compared as well, as those of a bench's force.
  bool has_means = false;
  /// Samples x inputs.
  Eigen::MatrixXd inputs;
  struct Channel {
    std::string name;
    Eigen::VectorXd values;
  };
  std::vector<Channel> channels;
};

/// What can be said of channels without physics, against which a fitted model is held: see Yardstick.
///
/// The linear model is an ARX model of order 20 at most from all inputs to the channel, of all fitted recordings of its
/// rate and setting. It takes every n-th sample, 25 per period of the frequency below which 95 % of the channel's power
/// lie, and its inputs' principal components that hold a ten-thousandth of their power or more; 20000 samples at most
/// are fitted. Repeats are recordings of one rate and setting whose inputs differ by less than a thousandth of their
/// power: a channel's half squared difference between two is what does not repeat. `misfits`: of the judged recordings,
/// a channel after the other.
void AddYardsticks(const std::vector<YardstickRecord>& fitted, const std::vector<YardstickRecord>& judged,
                   std::span<HistoryMisfit> misfits);

}  // namespace fourpost
