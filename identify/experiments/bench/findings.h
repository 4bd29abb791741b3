#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a damper on its bench and its recordings.
namespace fourpost {

// The study.

inline const Finding kBenchRecordingsEmpty{"bench-recordings-empty", Severity::kError,
                                           "{} of 'bench' must be a list of files with at least one entry",
                                           "name one, or remove 'bench'"};
inline const Finding kBenchRecordingTwice{"bench-recording-twice", Severity::kError,
                                          "two recordings have the name '{}'", "rename one with 'name'"};
inline const Finding kBenchWindowEmpty{"bench-window-empty", Severity::kError, "'end' of {} must be later than 'start'",
                                       "correct one of the two"};
inline const Finding kBenchEngine{"bench-engine", Severity::kError,
                                  "the option is for vehicles on posts, and this study has a damper on its bench",
                                  "leave it out"};

// The damper.

inline const Finding kBenchNoDamper{"bench-no-damper", Severity::kError, "the vehicle has no fp:damper",
                                    "add the one that was on the bench"};
inline const Finding kBenchDamperOpen{"bench-damper-open", Severity::kError, "the vehicle has {} dampers",
                                      "name the one on the bench with 'damper'"};
inline const Finding kBenchDamperUnknown{"bench-damper-unknown", Severity::kError, "the vehicle has no damper '{}'{}"};

// Recordings and results.

inline const Finding kBenchWindowOutside{
    "bench-window-outside", Severity::kError,
    "'start' and 'end' leave fewer than {} samples of the recording, which goes from {} s to {} s",
    "correct 'start' and 'end'"};
inline const Finding kBenchFilterUnsettled{"bench-filter-unsettled", Severity::kError,
                                           "the recording ends before the rig's filter has settled", "record longer"};
inline const Finding kBenchChamberCloses{
    "bench-chamber-closes", Severity::kError,
    "the damper cannot move as recorded in '{}' at these values because one of its chambers closes",
    "give it more room"};
inline const Finding kBenchNotPredicted{"bench-not-predicted", Severity::kError,
                                        "the fitted damper cannot predict '{}': {}",
                                        "check its stroke and units with `fourpost info`"};
inline const Finding kBenchForceInaccurate{
    "bench-force-inaccurate", Severity::kWarning,
    "the integration error of the force is {}, because the damper is too stiff for the sampling rate",
    "record at a higher rate"};

}  // namespace fourpost
