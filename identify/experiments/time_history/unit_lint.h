#pragma once

#include "identify/experiments/subject.h"
#include "identify/experiments/time_history/time_histories.h"

namespace fourpost {

/// Histories whose posts or channels are in another unit than stated, by a thousand: posts that move as no rig does,
/// and channels that are a thousand times what the vehicle of the file gives. Where all channels are, it is the posts.
/// Reported with `severity`. Evaluates the model once.
void LintUnits(const TimeHistories& histories, const Subject& subject, Severity severity, Diagnostics& diagnostics);

}  // namespace fourpost
