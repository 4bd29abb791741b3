#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/files/recording/file_bytes.h"
#include "analysis/files/universal/universal_function.h"

namespace fourpost {

/// What a universal file holds.
struct UniversalIndex {
  /// Of data set 151.
  std::string description;
  std::vector<UniversalFunction> functions;
  /// Numbers of the data sets that are not read, each once: "15, 2411".
  std::string others;
};

/// Reads the data sets 151 (header), 164 (units), 58 and 58b, and passes over others and over the numbers of functions.
/// An axis that states no unit has that of its quantity in SI where data set 164 stands before it. Throws
/// RecordingFault.
UniversalIndex ReadUniversalIndex(const FileBytes& bytes);

/// Whether these bytes begin a universal file.
bool IsUniversal(std::string_view head);

}  // namespace fourpost
