#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/files/recording/file_bytes.h"

namespace fourpost {

/// Record 8 to 11 of data set 58: what is along an axis.
struct UniversalAxis {
  /// Specific data type: 8 displacement, 11 velocity, 12 acceleration, 13 force, 17 time, 18 frequency.
  int quantity = 0;
  std::string label;
  /// As written, else that of SI by data set 164; empty without both.
  std::string unit;
  /// Of values as stored to `unit`.
  double factor = 1;
};

/// Node, direction ("+X", "-RZ", "") and what the file calls it.
struct UniversalPoint {
  std::string entity;
  std::uint64_t node = 0;
  std::string direction;

  /// "12 +Z"; empty without a node.
  std::string Text() const;
};

/// A data set 58 or 58b ("Universal File Data Set Number 58", SDRC and University of Cincinnati): its header, and where
/// its numbers are.
struct UniversalFunction {
  /// Of the file, at which the data set begins.
  int line = 0;
  std::array<std::string, 5> id;
  /// 1 time response, 4 frequency response, ...
  int type = 0;
  UniversalPoint response;
  UniversalPoint reference;
  bool is_complex = false;
  bool is_double = false;
  bool is_even = false;
  std::uint64_t samples = 0;
  double start = 0;
  double step = 0;
  UniversalAxis abscissa;
  UniversalAxis ordinate;
  UniversalAxis denominator;

  bool is_binary = false;
  bool is_big_endian = false;
  /// Of its numbers: where they begin, and how many bytes the file has for them.
  std::uint64_t data_at = 0;
  std::uint64_t data_bytes = 0;
  int data_line = 0;

  bool IsOverTime() const { return !is_complex && (type == 0 || type == 1) && (abscissa.quantity == 17 || type == 1); }
  bool IsFrequencyResponse() const { return type == 4 && is_complex; }
};

struct UniversalNumbers {
  /// Of functions that are not even.
  std::vector<double> abscissa;
  /// Imaginary parts are zero of what is not complex.
  std::vector<std::complex<double>> values;
};

/// The numbers of a function. Throws RecordingFault.
UniversalNumbers ReadNumbers(const FileBytes& bytes, const UniversalFunction& function);

}  // namespace fourpost
