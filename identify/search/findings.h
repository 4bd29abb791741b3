#pragma once

#include "analysis/text/finding.h"

// What can be wrong with an objective and with the archive of its evaluations.
namespace fourpost {

// The objective.

inline const Finding kObjectiveConstant{"objective-constant", Severity::kError,
                                        "the objective is constant, no parameter has an effect on it",
                                        "check bounds, channels and band of the study"};
inline const Finding kObjectiveIgnores{"objective-ignores", Severity::kWarning,
                                       "parameter '{}' has no effect on the objective", "fix it"};

// The archive.

inline const Finding kArchiveNotFile{"archive-not-a-file", Severity::kError,
                                     "a pipe or a device, not an archive of evaluations", "move it away"};
inline const Finding kArchiveForeign{"archive-foreign", Severity::kError,
                                     "not an archive of evaluations (left unchanged)",
                                     "move it away, or name another one"};
inline const Finding kArchiveLayout{"archive-layout", Severity::kError,
                                    "the archive has layout {}, this version of fourpost reads up to {}",
                                    "move it away, or use a newer fourpost"};
inline const Finding kArchiveFolder{"archive-folder", Severity::kError, "the folder cannot be created ({})",
                                    "allow it or name another folder"};
inline const Finding kArchiveFull{"archive-disk-full", Severity::kError, "the archive cannot be written ({})",
                                  "free some space; the stored evaluations have been kept"};
inline const Finding kArchiveDamaged{"archive-damaged", Severity::kError,
                                     "not an archive of evaluations, or damaged ({})", "move it away"};
inline const Finding kArchiveBusy{"archive-busy", Severity::kError, "another program uses the archive ({})",
                                  "wait for that program, or name another folder"};
inline const Finding kArchiveNotWritten{
    "archive-not-written", Severity::kError, "the archive cannot be used ({})",
    "allow writing, free some space, or name another folder; the stored evaluations have been kept"};

}  // namespace fourpost
