#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/files/mat_file.h"
#include "analysis/files/universal/universal_file.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// The frequency responses of a universal file as columns of a stepped sine (see ReadFrequencyResponse) in SI, without
/// the amplitude of the post, which such files do not state. Of a response R to the displacement x, the velocity v or
/// the acceleration a of a post, with w = 2 pi f:
///
///     R/x = i w R/v = -w^2 R/a          per metre, of displacements, forces and angular velocities
///     R/a = R/v / (i w) = -R/x / w^2    of accelerations
///
/// The line at 0 Hz is left out. Reports references to several points or to what is no motion, and frequencies that
/// differ; nothing then. Responses of other units are left out with a warning.
std::optional<std::vector<MatVector>> SteppedSineOf(const UniversalFile& file, const std::string& name,
                                                    Diagnostics& diagnostics);

}  // namespace fourpost
