#pragma once

#include "analysis/files/mdf/mdf_signal.h"

namespace fourpost {

/// Reads the blocks of an MDF file of version 4 ("ASAM MDF", 4.1) or 3 ("Measurement Data Format", 3.3). Throws
/// RecordingFault.
MdfIndex ReadMdf4(const FileBytes& bytes);
MdfIndex ReadMdf3(const FileBytes& bytes);

/// That its pieces hold all records of the group at this byte.
void RequireRecords(const MdfGroup& group, std::uint64_t at);

}  // namespace fourpost
