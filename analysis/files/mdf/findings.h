#pragma once

#include "analysis/text/finding.h"

// What can be wrong with an MDF file.
namespace fourpost {

inline const Finding kMdfVersion{"mdf-version", Severity::kError, "MDF file of version '{}'",
                                 "save it as MDF 4.10 or MDF 3.30"};
inline const Finding kMdfNotFinished{"mdf-not-finished", Severity::kError, "MDF file that its recorder did not finish",
                                     "open it in the recorder's software and save it"};
inline const Finding kMdfBlock{"mdf-block", Severity::kError, "damaged MDF file, {} at byte {}",
                               "copy or save it again"};
inline const Finding kMdfUnsorted{"mdf-unsorted", Severity::kError,
                                  "the data group at byte {} of the MDF file is not sorted", "save it as sorted"};
inline const Finding kMdfData{"mdf-data", Severity::kError, "data block '{}' at byte {} is not read",
                              "save the file as MDF 4.10"};
inline const Finding kMdfCycles{
    "mdf-cycles", Severity::kError,
    "damaged MDF file, the channel group at byte {} has {} records of {} bytes, its data {} bytes",
    "copy or save it again"};

}  // namespace fourpost
