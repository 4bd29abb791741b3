#pragma once

#include <string>
#include <vector>

#include "vehicles/requests/ride_files.h"

namespace fourpost {

/// Numbers of a ride as text; columns after the first are numbers, mostly.
struct RideTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  /// A line below it; may be empty.
  std::string foot;
};

/// Comfort, tyres, axles, dampers, their speeds, stops and body; without those that the vehicle has not.
std::vector<RideTable> RideTables(const RideAnswer& ride);

/// "power spectra, 8 nonlinear elements by statistical linearisation"
std::string RideMethod(const RideAnswer& ride);

/// By what it is found, and how well; lines.
std::string RideFoot(const RideAnswer& ride);

}  // namespace fourpost
