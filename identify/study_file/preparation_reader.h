#pragma once

#include <string>

#include "analysis/files/recording_window.h"
#include "analysis/files/time_recording.h"
#include "analysis/text/finding.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// What an entry of a study that is a time history says of its times: `resample`, `bridge` and `with`. `where` names
/// the entry in messages. Adds every fault.
TimePreparation ReadTimePreparation(const StrictMap& map, const std::string& where);

/// `start` and `end` of such an entry; `empty`: the finding that the end is not behind the start, which names `where`.
RecordingWindow ReadWindow(const StrictMap& map, const std::string& where, const Finding& empty);

}  // namespace fourpost
