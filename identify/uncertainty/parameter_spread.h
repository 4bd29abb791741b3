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
  /// In FitVariables, of those: where they would be, from `values`, with what the model lacks; empty: nothing is known.
  /// `total` holds moved moved' / 3 for it, the second moment of anywhere between.
  Eigen::VectorXd moved = {};

  /// `total` about a point that is `moved` by any share.
  Eigen::MatrixXd AboutMoved() const {
    if (moved.size() == 0) return total;
    return total - moved * moved.transpose() / 3;
  }
};

}  // namespace fourpost
