#include "analysis/files/recording_window.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

bool CutToWindow(const RecordingWindow& window, TimeRecording& recording) {
  const auto sample = [&](double t) { return (t - recording.start_s) * recording.rate_Hz(); };
  const auto last = static_cast<double>(recording.samples()) - 1;
  // Times are rounded where they were written.
  constexpr double kRounding = 1e-6;
  const double begin = window.start_s ? std::clamp(std::ceil(sample(*window.start_s) - kRounding), 0.0, last + 1) : 0;
  const double end = window.end_s ? std::clamp(std::floor(sample(*window.end_s) + kRounding), -1.0, last) : last;
  if (begin == 0 && end == last) return true;
  if (end - begin + 1 < kFewestInWindow) return false;
  const auto first = static_cast<std::ptrdiff_t>(begin);
  const auto count = static_cast<std::ptrdiff_t>(end - begin) + 1;
  for (std::vector<double>& channel : recording.channels)
    channel = std::vector<double>(channel.begin() + first, channel.begin() + first + count);
  recording.start_s = recording.time_s(static_cast<std::size_t>(first));
  recording.end_s = recording.time_s(static_cast<std::size_t>(count - 1));
  recording.preparations.push_back(CutTo(recording.start_s, recording.end_s));
  return true;
}

}  // namespace fourpost
