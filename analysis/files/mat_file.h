#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A vector of numbers or of texts in a MAT file.
struct MatVector {
  std::string name;
  /// As written; empty where the file has none.
  std::string unit;
  /// One of both is filled.
  std::vector<double> values;
  std::vector<std::string> texts;
};

/// Reads the real vectors of a MAT file of version 4 to 7.3: variables, and fields of structures (of `run.force` the
/// name is "force", or "run" where the field is called data, values or signal). The unit of `force` is the text of
/// `force_unit`, of the field `force` of a structure `units`, or of the field `unit` or `units` beside the numbers.
/// Vectors of texts are cell arrays and the rows of character arrays, without the blanks that fill them up. Reports all
/// of: a file that is no MAT file or is cut short, one without a vector of numbers, two vectors of one name. Nothing
/// when there was one.
std::optional<std::vector<MatVector>> ReadMatFile(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same for bytes that are in memory already, of version 4 to 7; `file` is their name in messages.
std::optional<std::vector<MatVector>> ParseMat(std::string_view bytes, const std::string& file,
                                               Diagnostics& diagnostics);

}  // namespace fourpost
