#pragma once

#include "vehicles/description/drawn_vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Numbers outside the range of road vehicles, see AttributeRule::usual_least, e.g. if kN were meant. Zero is accepted.
void LintNumbers(const DrawnVehicle& drawn, FileFaults& findings);

/// The same for the mean rates of dampers whose file does not state rates.
void LintMeanRates(const DrawnVehicle& drawn, FileFaults& findings);

/// Cubic terms that far exceed the linear ones within a small travel.
void LintHardening(const DrawnVehicle& drawn, FileFaults& findings);

/// Points given in millimetres instead of metres; for sensors see LintSensorPlaces.
void LintPlacesInMillimetres(const DrawnVehicle& drawn, FileFaults& findings);

/// Stops that touch on both sides in the design pose.
void LintStopGaps(const DrawnVehicle& drawn, FileFaults& findings);

/// Gaps and knees beyond the available length.
void LintGaps(const DrawnVehicle& drawn, FileFaults& findings);

/// Hydraulic dampers whose piston reaches an end before the stop between the same links does.
void LintOilColumns(const DrawnVehicle& drawn, FileFaults& findings);

/// Dampers that resist bump far more than rebound.
void LintSwappedDamping(const DrawnVehicle& drawn, FileFaults& findings);

}  // namespace fourpost
