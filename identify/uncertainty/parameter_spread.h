#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/search/lattice.h"

namespace fourpost {

/// Fitted values of the n free parameters, and how far they may be off.
struct ParameterSpread {
  Lattice lattice;
  /// SI.
  Eigen::VectorXd values;
  /// Places of those that have a standard deviation, in order; the others stay where they are.
  std::vector<Eigen::Index> judged;
  /// Of those, in FitVariables: of noise alone, and of noise, held parameters and model error together.
  Eigen::MatrixXd noise;
  Eigen::MatrixXd total;
};

}  // namespace fourpost
