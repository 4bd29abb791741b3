#include "identify/fit/calibration_changes.h"

#include <iterator>
#include <stdexcept>

namespace fourpost {

Eigen::MatrixXd CalibrationChanges(const VehicleObjective& objective, const Eigen::VectorXd& values) {
  Eigen::MatrixXd changes =
      Eigen::MatrixXd::Zero(objective.residual_count() - objective.prior_count(), std::ssize(objective.calibrations()));
  Eigen::Index first = 0;
  for (const ResidualBlock& block : objective.blocks()) {
    try {
      if (block.by_calibrations)
        changes.middleRows(first, block.count) = block.by_calibrations(objective.AllParameters(values));
    } catch (const std::runtime_error&) {
      return {};
    }
    first += block.count;
  }
  return changes;
}

}  // namespace fourpost
