#pragma once

#include <vector>

#include "identify/uncertainty/parameter_spread.h"

namespace fourpost {

/// Where a refinement of a fit ended.
struct EndedStart {
  double cost = 0;
  /// SI.
  Eigen::VectorXd values;
};

/// Of these ends those that the data may allow beside the best, each once: with exp(-15) of its likelihood at least,
/// and more than a standard deviation away in some parameter. `covariance`: of the judged parameters, that of noise or
/// in total; `cost`, `inflation`: of the best.
std::vector<EndedStart> OtherOptima(const std::vector<EndedStart>& ends, const ParameterSpread& best, double cost,
                                    double inflation, const Eigen::MatrixXd& covariance);

}  // namespace fourpost
