#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/search/archive.h"
#include "identify/uncertainty/covariance.h"

namespace fourpost {

/// A parameter held here, all others fitted to it.
struct ProfilePoint {
  /// SI.
  double value = 0;
  /// Of the cost above that of the fit, over the square of the deviations' inflation: 1 at one standard deviation,
  /// where the model is linear.
  double rise = 0;
};

/// How the cost rises when one parameter is held away from its fitted value and all others are fitted anew: what the
/// linear deviation is a parabola of.
struct Profile {
  std::string name;
  /// By value, the fitted one among them.
  std::vector<ProfilePoint> points;
  /// Rise at the ends of the interval of 95 %: the square of Covariance::reach_95.
  double threshold = 0;
  /// Interval of 95 %, SI; infinite on a side where the rise stays below the threshold up to the parameter's bound.
  double lower_95 = 0;
  double upper_95 = 0;
  /// A fit on the way went below the cost of the fit by more than its tolerance: that was no optimum.
  bool found_better = false;
  /// `stop` ended it.
  bool interrupted = false;
};

/// The profile of parameter `index` of the lattice about `best`, a refined optimum with this covariance: outward on
/// both sides from fitted point to fitted point until the rise passes the threshold or the bound is reached, then
/// towards the crossing until that is known to a hundredth of the interval.
Profile ProfileOf(Archive& archive, const RefineResult& best, const Covariance& covariance, Eigen::Index index,
                  const RefineOptions& options, const std::function<bool()>& stop);

}  // namespace fourpost
