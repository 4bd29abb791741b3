#pragma once

#include <string>
#include <vector>

#include "analysis/measured_response/response_part.h"

namespace fourpost {

/// "no dwell was found from 2.0 to 8.1 s, where the posts move: ..." of motions between dwells that are not used: those
/// that swing for two cycles more than is usual between dwells of this recording, and of a cycle or more in more than
/// two seconds, so no ramp. A pause, in which the post stays near its middle for half a second and longer than for any
/// swing, parts motions, and what fades out behind a dwell, or in before it, at its frequency is none. Of many the first
/// three and how many more. `are_stated`: frequencies, so that to state them is no remedy.
std::vector<std::string> MotionsWithoutDwell(const LookedAt& looked, bool are_stated);

}  // namespace fourpost
