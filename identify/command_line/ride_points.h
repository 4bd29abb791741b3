#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride_metrics/ride_instruments.h"

namespace fourpost {

/// Points of --point, "seat=chassis:0.1,0.3,0.8", vertical in the design pose. Adds an error for each that cannot be
/// read, has no such link, or the name of another point or sensor.
std::vector<RidePoint> ReadRidePoints(const std::vector<std::string>& texts, const Vehicle& vehicle,
                                      Diagnostics& diagnostics);

/// Weightings of --weighting, "seat=Wb". Adds an error for each that cannot be read or has no such point.
void SetWeightings(const std::vector<std::string>& texts, RideInstruments& instruments, Diagnostics& diagnostics);

}  // namespace fourpost
