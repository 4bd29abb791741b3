#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// A minimum that a refinement ended in, with the cost near it.
struct KnownOptimum {
  /// In FitVariables.
  Eigen::VectorXd x;
  double cost = 0;
  /// Half the second derivatives of the cost, to first order in the residuals.
  Eigen::MatrixXd normal;
};

/// Where a refinement stands.
struct PointOnTheWay {
  const Eigen::VectorXd& x;
  double cost = 0;
  /// By how much the cost would fall if the residuals were linear.
  double full_gain = 0;
  /// Residuals less variables.
  double freedom = 1;
};

/// Minima of earlier refinements from other starts, so that a later one need not go all the way into the same.
class KnownOptima {
 public:
  void Add(KnownOptimum optimum) { optima_.push_back(std::move(optimum)); }

  /// The one of which the point lies within three standard deviations, no lower, and as low as which the cost would
  /// fall, give or take `agreement` of chi-square (see RefineOptions::agreement).
  std::optional<std::size_t> MetBy(const PointOnTheWay& point, double agreement) const;

  /// The one within three standard deviations of another end of a refinement, whose cost differs by no more than that.
  std::optional<std::size_t> OneWith(const Eigen::VectorXd& x, double cost, double freedom, double agreement) const;

 private:
  /// `is_met(optimum, unit)`; the unit of chi-square there.
  template <typename IsMet>
  std::optional<std::size_t> First(double freedom, const IsMet& is_met) const;

  std::vector<KnownOptimum> optima_;
};

}  // namespace fourpost
