#pragma once

#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/requests/sweep.h"

namespace fourpost {

/// A page of a vehicle that need not have been fitted: its parameters, the vehicle moving, its responses to stepped
/// sines of the posts and its modes, with a slider for every parameter. `file`: the text of its file, which the page
/// saves with other values. Throws FaultyInput where the vehicle cannot be assembled or held.
std::string VehiclePage(const std::string& file, const Vehicle& vehicle, const std::vector<SweptResponse>& responses);

}  // namespace fourpost
