#pragma once

#include <Eigen/Core>

#include "identify/residuals/residual_structure.h"

namespace fourpost {

/// Recordings over time cut into windows that say equally much of the parameters: five of a single one, each as it is
/// where they are many. Windows of equal length would not do: of a step the first one would hold all there is to know.
/// A window is named by its times. `leverage`: of each residual, what it says of the parameters. Other recordings stay
/// whole.
ResidualPartition WindowsOfTime(const ResidualStructure& structure, const Eigen::VectorXd& leverage);

}  // namespace fourpost
