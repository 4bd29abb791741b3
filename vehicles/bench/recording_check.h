#pragma once

#include <string>

#include "analysis/diagnostics.h"
#include "analysis/time_recording.h"

namespace fourpost {

/// Looks at a bench recording, extension [m] and tension [N], for what makes a fit of it worthless. Faults: a force
/// that never changes; less than one cycle; a stroke beyond any damper's, as of mm for m, or of columns swapped; a
/// damper that would give off work, as of a wrong sign; clipped signals. Warnings: force that does not go with the
/// motion, that runs ahead of the speed or falls behind the extension, as of channels that are not synchronised;
/// spikes, a stroke too small, signals of too few levels, drift, compression harder than rebound. `longest_stroke_m`:
/// what the stroke is below, such as the damper's length. False when there was a fault.
bool CheckBenchRecording(const TimeRecording& recording, double longest_stroke_m, const std::string& file,
                         Diagnostics& diagnostics);

}  // namespace fourpost
