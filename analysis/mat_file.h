#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"

namespace fourpost {

/// A vector of numbers in a MAT file.
struct MatVector {
  std::string name;
  /// As written; empty where the file tells none.
  std::string unit;
  std::vector<double> values;
};

/// Reads the real vectors of a MAT file of version 4 to 7.3: variables, and fields of structures (of `run.force` the
/// name is "force", or "run" where the field is called data, values or signal). The unit of `force` is the text of
/// `force_unit`, of the field `force` of a structure `units`, or of the field `unit` or `units` beside the numbers.
/// Reports all of: a file that is no MAT file or is cut short, one without a vector, two vectors of one name. Nothing
/// when there was one.
std::optional<std::vector<MatVector>> ReadMatFile(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
