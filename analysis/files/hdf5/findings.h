#pragma once

#include "analysis/text/finding.h"

// What can be wrong with an HDF5 file that is not of MATLAB.
namespace fourpost {

inline const Finding kHdf5Failed{"hdf5-failed", Severity::kError, "damaged HDF5 file, the HDF5 library cannot read it",
                                 "copy or save it again"};
inline const Finding kHdf5Object{"hdf5-object", Severity::kError, "damaged HDF5 file, '{}' cannot be read",
                                 "copy or save it again"};
inline const Finding kHdf5Storage{"hdf5-storage", Severity::kError,
                                  "damaged HDF5 file, '{}' has {} numbers but stores {} bytes of them",
                                  "copy or save it again"};
inline const Finding kHdf5Objects{"hdf5-too-many-objects", Severity::kError,
                                  "HDF5 file with more than {} objects, or groups nested more than {} deep",
                                  "save the channels in one group"};

}  // namespace fourpost
