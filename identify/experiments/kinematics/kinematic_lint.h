#pragma once

#include <span>
#include <string>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/kinematics/kinematic_result.h"

namespace fourpost {

/// What the vehicle cannot do of what was measured, as errors at the study's line.
void ReportRefusal(const KinematicAnswer::Refusal& refusal, std::span<const KinematicSweep> sweeps,
                   const std::string& study, Diagnostics& diagnostics);

/// Before a fit: curves that change against the model, as under another convention of signs.
void LintKinematicSigns(std::span<const KinematicMisfit> misfits, const std::string& study, Diagnostics& diagnostics);

/// After a fit: curves that a constant would explain.
void LintKinematicOffsets(std::span<const KinematicMisfit> misfits, const std::string& study, Diagnostics& diagnostics);

}  // namespace fourpost
