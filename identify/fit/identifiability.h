#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/finding.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/search/archive.h"
#include "identify/uncertainty/covariance.h"

namespace fourpost {

/// How well data and priors of a study determine its free parameters, before they are fitted.
struct Identifiability {
  /// Parameters whose derivatives are noise are held in it.
  Covariance covariance;
  /// Names of parameters whose derivatives are noise, see NoisyColumns(): nothing is known of them.
  std::vector<std::string> noisy = {};
  /// Combinations that nothing determines, in words; if there is none, the least identifiable direction.
  std::vector<std::string> weakest;

  bool HasUndetermined() const { return covariance.rank < covariance.directions.cols(); }
};

/// At the values of the vehicle file. A direction that is open there, as that of a knee between equal rates, may be
/// closed elsewhere: such directions are looked at from two random points as well, and only what is open from all of
/// them counts. Where one is, derivatives at the file's values are looked at twice: what noise hides is not open.
/// kAutomatic takes the model's own derivatives where they leave nothing open; else central differences.
/// Nothing where the model cannot be evaluated at the file's values. Its evaluations are counted.
std::optional<Identifiability> IdentifiabilityBefore(Archive& archive, const VehicleObjective& objective,
                                                     std::uint64_t seed,
                                                     Differences differences = Differences::kCentral);

/// The finding about a direction that nothing determines: of all masses and rates together, a force fixes the scale;
/// else one of them is to be fixed, known before, or distinguished by another channel. Its word: DescribeDirection().
const Finding& UnidentifiedAs(const Eigen::VectorXd& direction);

/// DescribeDirection() of all that a covariance leaves open, or of what it determines least.
std::vector<std::string> WeakestDirections(const Lattice& lattice, const Covariance& covariance);

}  // namespace fourpost
