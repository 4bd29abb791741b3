#pragma once

#include "identify/experiments/recording_look.h"

namespace fourpost {

/// Tables of responses at frequencies.
extern const RecordingViewer kSteppedSineViewer;

}  // namespace fourpost
