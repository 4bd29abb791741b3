#pragma once

#include "identify/experiments/recording_look.h"

namespace fourpost {

/// Tables over time: all others.
extern const RecordingViewer kHistoryViewer;

}  // namespace fourpost
