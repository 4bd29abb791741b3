#pragma once

#include "vehicles/description/drawn_vehicle.h"

namespace fourpost {

/// Numbers that no road vehicle has, see AttributeRule::usual_least, as when kN were meant. Zero is no slip of a unit.
void LintNumbers(const DrawnVehicle& drawn, FileFaults& findings);

/// The same of the mean rates of dampers whose file does not state rates.
void LintMeanRates(const DrawnVehicle& drawn, FileFaults& findings);

/// Cubic terms that far outdo the linear ones within a small travel.
void LintHardening(const DrawnVehicle& drawn, FileFaults& findings);

/// Points given in millimetres where metres are meant; of sensors see LintSensorPlaces.
void LintPlacesInMillimetres(const DrawnVehicle& drawn, FileFaults& findings);

/// Stops that touch on both sides in the design pose.
void LintStopGaps(const DrawnVehicle& drawn, FileFaults& findings);

/// Gaps and knees beyond the length that there is to be compressed.
void LintGaps(const DrawnVehicle& drawn, FileFaults& findings);

/// Hydraulic dampers whose piston meets an end before the stop between the same links does.
void LintOilColumns(const DrawnVehicle& drawn, FileFaults& findings);

/// Dampers that resist compression far more than rebound.
void LintSwappedDamping(const DrawnVehicle& drawn, FileFaults& findings);

}  // namespace fourpost
