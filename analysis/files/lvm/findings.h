#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a LabVIEW measurement file.
namespace fourpost {

inline const Finding kLvmHeader{"lvm-header", Severity::kError, "the file ends before ***End_of_Header***",
                                "copy or save it again"};
inline const Finding kLvmNames{"lvm-names", Severity::kError, "no line of channel names is behind the header",
                               "copy or save it again"};
inline const Finding kLvmNumber{"lvm-number", Severity::kError, "'{}' of channel '{}' is not a number",
                                "correct it, or leave the field empty where nothing was measured"};
inline const Finding kLvmCutShort{"lvm-cut-short", Severity::kError,
                                  "the file is cut short: a part has {} samples of channel '{}', and its header {}",
                                  "copy or save it again"};
inline const Finding kLvmChannels{"lvm-channels", Severity::kError, "a part with {} channels follows one with {}",
                                  "save each part as a file"};

}  // namespace fourpost
