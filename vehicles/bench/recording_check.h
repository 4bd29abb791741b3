#pragma once

#include <string>

#include "analysis/files/time_recording.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Checks a bench recording, extension [m] and tension [N], for faults that make a fit worthless. Errors: a force that
/// never changes but for noise of its converter; less than one cycle; a stroke beyond any damper's (mm read as m,
/// columns swapped); a damper that would deliver work (wrong sign); clipped signals. Warnings: force that does not
/// follow the motion, leads the velocity or lags the extension (channels not synchronised); spikes, too small a stroke,
/// signals of too few levels, drift, bump harder than rebound. `longest_stroke_m`: upper bound of the stroke, such as
/// the damper's length. Returns false after an error.
bool CheckBenchRecording(const TimeRecording& recording, double longest_stroke_m, const std::string& file,
                         Diagnostics& diagnostics);

/// Whether the force acts along the motion, so that the damper would deliver work: by its sign, not by a delay.
bool IsForceReversed(const TimeRecording& recording);

}  // namespace fourpost
