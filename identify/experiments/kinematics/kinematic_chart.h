#pragma once

#include <span>
#include <string>

#include "identify/experiments/kinematics/kinematic_result.h"

namespace fourpost {

/// A panel for each quantity of each sweep: measured points and the model's curves, offsets added, over travel or load.
std::string KinematicSvg(const std::string& title, std::span<const KinematicMisfit> misfits);

}  // namespace fourpost
