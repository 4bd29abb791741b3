#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/report/live_json.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/requests/ride_files.h"

namespace fourpost {

/// What `fourpost ride` found, to be shown.
struct ShownRides {
  /// Text of the vehicle's file, at whose values sliders begin.
  std::string file;
  std::vector<RideAnswer> rides;
  /// What the sliders begin with.
  ShownRide first;
  Diagnostics findings;
};

/// A page of rides: of each its numbers, power spectra of the weighted accelerations with the weighting curves, and of
/// the tyres' loads; the vehicle in its modes, with sliders that the numbers of a road follow.
std::string RidePage(const Vehicle& vehicle, const ShownRides& shown);

}  // namespace fourpost
