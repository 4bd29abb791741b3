#pragma once

#include <string>
#include <string_view>

#include "vehicles/ride_metrics/ride_instruments.h"

namespace fourpost {

/// What RideOnRoad() needs of instruments beside their reduced vehicle, as bytes, see reduced_bytes.h.
std::string BytesOf(const RideInstruments& instruments);

/// The vehicle in them has no more than the names and laws of tyres, dampers and springs. Throws std::invalid_argument
/// for bytes of another length than these are; whether indices fit a vehicle is for who has it, as LiveRide.
RideInstruments RideInstrumentsOf(std::string_view bytes);

}  // namespace fourpost
