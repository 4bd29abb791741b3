#pragma once

#include "identify/experiments/recording_look.h"

namespace fourpost {

/// Tables of a kinematics and compliance rig.
extern const RecordingViewer kKinematicViewer;

}  // namespace fourpost
