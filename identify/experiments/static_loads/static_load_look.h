#pragma once

#include "identify/experiments/recording_look.h"

namespace fourpost {

/// Tables of quantities and their values.
extern const RecordingViewer kStaticLoadViewer;

}  // namespace fourpost
