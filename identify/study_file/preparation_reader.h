#pragma once

#include <string>

#include "analysis/files/time_recording.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// What an entry of a study that is a time history says of its times: `resample`, `bridge` and `with`. `where` names
/// the entry in messages. Adds every fault.
TimePreparation ReadTimePreparation(const StrictMap& map, const std::string& where);

}  // namespace fourpost
