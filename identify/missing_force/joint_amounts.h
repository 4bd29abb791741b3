#pragma once

#include <vector>

#include "identify/missing_force/force_explanation.h"
#include "identify/missing_force/weighed_forces.h"

namespace fourpost {

/// Sets the amounts of mechanisms to those beside each other. While one is not allowed, or less than three of its
/// standard deviations, the weakest is dropped and the rest are estimated anew: of two that do much the same one stays.
/// Returns the force with all that stay taken out; the record must outlive it.
WeighedForces EstimateTogether(const ForceRecord& record, std::vector<ForceExplanation>& found);

}  // namespace fourpost
