#pragma once

#include <string>
#include <vector>

namespace fourpost {

/// A table for the terminal: the first column to the left, numbers to the right, columns as wide as they need to be.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> head);

  /// One cell per column; throws std::invalid_argument otherwise.
  void Add(std::vector<std::string> row);

  /// Lines end with a newline.
  std::string Format() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// A number with this many significant digits, without an exponent in everyday ranges: "12.3", "0.0123".
std::string Rounded(double value, int digits);

}  // namespace fourpost
