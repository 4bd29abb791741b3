#pragma once

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// Of tables of a kinematics and compliance rig: `kinematics` of result.json, and kinematics.svg.
const ExperimentReport& KinematicReport();

}  // namespace fourpost
