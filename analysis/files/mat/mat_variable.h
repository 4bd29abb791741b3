#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/found.h"

namespace fourpost {

/// A variable of a MAT file of any version, a cell of an array, or a field of a structure.
struct MatVariable {
  enum class Kind { kNumbers, kText, kCells, kStructure, kOther };

  std::string name;
  Kind kind = Kind::kOther;
  /// Two at least; as many numbers, rows and parts are there as they say.
  std::vector<std::uint64_t> dims;
  /// Real numbers, column after column.
  std::vector<double> numbers;
  /// The rows of a matrix of characters, UTF-8 where the file says which characters they are.
  std::vector<std::string> rows;
  /// Cells, column after column, or the fields of a single structure.
  std::vector<MatVariable> parts;

  /// Of all dimensions; the greatest number there is where the product is beyond it.
  std::uint64_t Length() const;
};

/// Why a MAT file is not read.
class MatFault : public std::exception {
 public:
  explicit MatFault(const Finding& kind, std::vector<std::string> words = {}) : found_{&kind, std::move(words)} {}
  const Found& found() const { return found_; }
  const char* what() const noexcept override { return found_.kind->id().data(); }

 private:
  Found found_;
};

/// Parts of parts of parts: no recording goes that far down, and each level takes some of the stack.
constexpr int kDeepestMat = 20;

/// Bytes of characters: names and units are shorter, and what is longer is no text that anyone asks for.
constexpr std::size_t kLongestMatText = std::size_t{1} << 20;

/// That a variable holds `held` numbers, characters or cells, as its dimensions say; throws where they say otherwise.
void RequireLength(const MatVariable& variable, std::uint64_t held, const std::string& what);

/// Into the rows of a matrix of characters, which stand column after column; `rows`: at least one.
std::vector<std::string> RowsOf(const std::vector<std::string>& characters, std::uint64_t rows);

/// A character in UTF-8; '?' for what is none.
std::string Utf8(std::uint32_t code);

}  // namespace fourpost
