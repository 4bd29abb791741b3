#pragma once

#include <string>
#include <vector>

namespace fourpost {

/// A table for the terminal: columns of numbers to the right, of words to the left, as wide as they need to be.
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

/// The same of an SI number in a unit such as "kN/m", which is not shown; "" is a pure number.
std::string InUnit(double si, const std::string& unit, int digits);

}  // namespace fourpost
