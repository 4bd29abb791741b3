#pragma once

#include <string>

#include "vehicles/requests/ride_files.h"

namespace fourpost {

/// Tables of one ride.
std::string RideText(const RideAnswer& ride);

/// A road by power spectra beside its time history.
std::string RideDifferenceText(const RideAnswer& spectra, const RideAnswer& history);

}  // namespace fourpost
