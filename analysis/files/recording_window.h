#pragma once

#include <optional>

#include "analysis/files/time_recording.h"

namespace fourpost {

/// Part of a recording; an end that is not stated is the recording's.
struct RecordingWindow {
  std::optional<double> start_s = {};
  std::optional<double> end_s = {};
};

/// Fewer samples are no recording.
inline constexpr int kFewestInWindow = 16;

/// Cuts off all samples outside and adds that to `preparations`. False, with the recording as it was, where it would
/// leave fewer than kFewestInWindow.
bool CutToWindow(const RecordingWindow& window, TimeRecording& recording);

}  // namespace fourpost
