#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a MAT file.
namespace fourpost {

inline const Finding kMatNotReadable{"mat-not-readable", Severity::kError, "not a MAT file that fourpost can read",
                                     "save it again, for instance with -v7"};
inline const Finding kMatCutShort{"mat-cut-short", Severity::kError, "MAT file is cut short", "save or copy it again"};
inline const Finding kMatCrashed{"mat-hdf5-failed", Severity::kError, "damaged MAT file, HDF5 cannot read it",
                                 "save or copy it again"};
inline const Finding kMatOutOfMemory{"mat-out-of-memory", Severity::kError, "MAT file needs more memory than there is",
                                     "save fewer channels, or a part of the recording"};
inline const Finding kMatTooLarge{"mat-too-large", Severity::kError,
                                  "MAT file holds more than 1 GiB of compressed variables",
                                  "save fewer variables, or a part of the recording"};
inline const Finding kMatPartialNumber{"mat-partial-number", Severity::kError,
                                       "damaged MAT file, its data end within a number", "save or copy it again"};
inline const Finding kMatNumberType{"mat-number-type", Severity::kError,
                                    "damaged MAT file, numbers have the unknown type {}", "save or copy it again"};
inline const Finding kMatHeader{"mat-variable-header", Severity::kError,
                                "damaged MAT file, a variable does not begin with its class, dimensions and name",
                                "save or copy it again"};
inline const Finding kMatPart{"mat-part-not-a-variable", Severity::kError,
                              "damaged MAT file, a cell or field is not a variable", "save or copy it again"};
inline const Finding kMatDepth{"mat-too-deep", Severity::kError, "damaged MAT file, cells or fields are nested {} deep",
                               "save or copy it again"};
inline const Finding kMatObjects{
    "mat-too-many-objects", Severity::kError,
    "damaged MAT file, more than {} variables, cells and fields, or these are nested more than {} deep",
    "save or copy it again"};
inline const Finding kMatCells{"mat-too-many-cells", Severity::kError, "damaged MAT file, '{}' has too many cells",
                               "save or copy it again"};
inline const Finding kMatNegativeDimension{"mat-negative-dimension", Severity::kError,
                                           "damaged MAT file, a dimension is negative", "save or copy it again"};
inline const Finding kMatDimensions{"mat-dimensions", Severity::kError,
                                    "damaged MAT file, a variable has fewer than two dimensions",
                                    "save or copy it again"};
inline const Finding kMatLength{"mat-length", Severity::kError,
                                "damaged MAT file, variable '{}' holds {} {}, its dimensions say {}",
                                "save or copy it again"};
inline const Finding kMatStorage{"mat-storage", Severity::kError,
                                 "damaged MAT file, variable '{}' has {} elements but stores {} bytes of them",
                                 "save or copy it again"};
inline const Finding kMatElsewhere{"mat-stored-elsewhere", Severity::kError,
                                   "damaged MAT file, variable '{}' is stored in another file", "save it in one file"};
inline const Finding kMatInflate{"mat-decompression", Severity::kError,
                                 "damaged MAT file, a variable cannot be decompressed", "save or copy it again"};
inline const Finding kMatObject{"mat-object", Severity::kError, "damaged MAT file, an object cannot be opened",
                                "save or copy it again"};
inline const Finding kMatNoDimensions{"mat-no-dimensions", Severity::kError,
                                      "damaged MAT file, a variable has no dimensions", "save or copy it again"};
inline const Finding kMatLayout{"mat-layout", Severity::kError,
                                "damaged MAT file, the layout of a variable cannot be read", "save or copy it again"};
inline const Finding kMatGroup{"mat-group", Severity::kError, "damaged MAT file, a group cannot be read",
                               "save or copy it again"};
inline const Finding kMatName{"mat-name", Severity::kError, "damaged MAT file, the name of a variable cannot be read",
                              "save or copy it again"};
inline const Finding kMatContent{"mat-content", Severity::kError, "damaged MAT file, '{}' cannot be read",
                                 "save or copy it again"};

}  // namespace fourpost
