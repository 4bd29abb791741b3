#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The parameters to determine, in FitVariables (ln of the value, or a share of the range), and what is known of them.
struct KnownParameters {
  /// In Vehicle::parameters.
  std::vector<std::size_t> places;
  /// d value [SI] / d variable.
  Eigen::VectorXd slopes;
  /// Inverse covariance before anything is measured.
  Eigen::MatrixXd information;
  /// Of a fit: free parameters that are left out, for they have no standard deviation, "k, c".
  std::string left_out = {};
};

/// Inverse of a positive definite matrix.
Eigen::MatrixXd InverseOf(const Eigen::MatrixXd& matrix);

/// Of a fit, whose fitted vehicle this is: those with a standard deviation, as its noise and stated model error allow.
/// Throws FaultyInput for a run that has no covariance.
KnownParameters KnownByFit(const std::filesystem::path& run, const Vehicle& vehicle);

/// Of a vehicle file: all with a range, which count as anywhere in it, or as their priors say.
KnownParameters KnownByRanges(const Vehicle& vehicle);

}  // namespace fourpost
