#pragma once

#include <optional>

#include <Eigen/Core>

#include "identify/residuals/residual_structure.h"

namespace fourpost {

/// Residuals and how they belong together.
struct StructuredResiduals {
  const Eigen::VectorXd& residuals;
  const ResidualStructure& structure;
};

/// N, of `known`: the others in their places, those over time by their times. Where they have none, as at the end of a
/// record whose channel is taken later, those of `known` stay: they say nothing for or against. Nothing where both
/// are not of the same series.
std::optional<Eigen::VectorXd> AlignedTo(const StructuredResiduals& known, const StructuredResiduals& others);

}  // namespace fourpost
