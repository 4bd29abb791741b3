#pragma once

#include <string>

#include "analysis/diagnostics.h"
#include "analysis/time_recording.h"

namespace fourpost {

/// Looks at a bench recording, extension [m] and tension [N], for what makes a fit of it worthless. Faults: less than
/// one cycle; a stroke beyond any damper's, as of mm for m, or of columns swapped; a damper that would give off work,
/// as of a wrong sign; clipped signals. Warnings: a stroke too small, signals of too few levels, drift, compression
/// harder than rebound. False when there was a fault.
bool CheckBenchRecording(const TimeRecording& recording, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
