#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a recording in any of the formats of measurement systems.
namespace fourpost {

inline const Finding kRecordingNotOpened{"recording-not-opened", Severity::kError, "cannot be read ({})",
                                         "allow reading it, or name another file"};
inline const Finding kRecordingCutShort{"recording-cut-short", Severity::kError,
                                        "{} file is cut short: {} at byte {} takes {} bytes, the file ends at {}",
                                        "copy or save it again"};
inline const Finding kRecordingNoChannel{"recording-no-channel", Severity::kError,
                                         "{} file holds no channel of numbers", "record or export the channels again"};
inline const Finding kRecordingInflate{"recording-decompression", Severity::kError,
                                       "damaged {} file, the data at byte {} cannot be decompressed",
                                       "copy or save it again"};
inline const Finding kChannelsLeftOut{"recording-channels-left-out", Severity::kWarning,
                                      "channels that are not read: {}", "export them as plain numbers if they matter"};

}  // namespace fourpost
