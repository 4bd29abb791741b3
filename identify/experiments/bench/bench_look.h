#pragma once

#include "identify/experiments/recording_look.h"

namespace fourpost {

/// Tables over time of nothing but a displacement and a force.
extern const RecordingViewer kBenchViewer;

}  // namespace fourpost
