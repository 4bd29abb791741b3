#pragma once

#include <string>
#include <vector>

#include "vehicles/requests/sweep.h"

namespace fourpost {

/// What `fourpost response` of a vehicle shows on a terminal: of each sweep a head, what linear kinematics leave out, a
/// table of gains, and why which frequencies have no answer.
std::string ResponseText(const SweepRequest& request, const std::vector<SweptResponse>& responses);

}  // namespace fourpost
