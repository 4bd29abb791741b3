#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a file that was given for another kind.
namespace fourpost {

inline const Finding kStudyForVehicle{"study-for-vehicle", Severity::kError, "this is a study, not a vehicle file",
                                      "give the vehicle file (.urdf) that it names"};
inline const Finding kVehicleForStudy{"vehicle-for-study", Severity::kError, "this is a vehicle file, not a study",
                                      "give a study (.yaml), which names its vehicle and recordings"};
inline const Finding kVehicleForRecording{"vehicle-for-recording", Severity::kError,
                                          "this is a vehicle file, not a recording",
                                          "see `fourpost check` and `fourpost params` for its contents"};
inline const Finding kFolderForRecording{"folder-for-recording", Severity::kError, "this is a folder, not a recording",
                                         "name the recordings in it; `fourpost report` shows what a fit wrote"};
inline const Finding kFileOfOtherKind{"file-of-other-kind", Severity::kError, "this is {}", "give {}"};

}  // namespace fourpost
