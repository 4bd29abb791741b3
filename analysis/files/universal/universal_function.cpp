#include "analysis/files/universal/universal_function.h"

#include <algorithm>
#include <string_view>

#include "analysis/files/recording/file_lines.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/stored_number.h"
#include "analysis/files/universal/findings.h"
#include "analysis/files/universal/universal_number.h"

namespace fourpost {
namespace {

/// Numbers per sample.
std::uint64_t Width(const UniversalFunction& function) {
  return (function.is_even ? 0 : 1) + (function.is_complex ? 2 : 1);
}

/// However many a line has: the last one may have fewer.
std::vector<double> TextNumbers(const FileBytes& bytes, const UniversalFunction& function) {
  const std::uint64_t needed = function.samples * Width(function);
  std::vector<double> numbers;
  FileLines lines(bytes, function.data_at, function.data_line);
  const std::uint64_t end = function.data_at + function.data_bytes;
  for (std::string_view line; numbers.size() < needed && lines.at() < end && lines.Next(line);)
    while (numbers.size() < needed) {
      const std::optional<double> number = TakeUniversalNumber(line);
      if (!number) break;
      numbers.push_back(*number);
    }
  if (numbers.size() < needed)
    throw RecordingFault(kUniversalValues, {std::to_string(numbers.size()), std::to_string(needed)}, function.line);
  return numbers;
}

/// Of a sample; times are of single precision in some files of doubles.
std::uint64_t BytesOfTime(const UniversalFunction& function) {
  if (function.is_even) return 0;
  const std::uint64_t values = (function.is_complex ? 2 : 1) * (function.is_double ? 8 : 4);
  const bool is_single =
      !function.is_double || function.samples == 0 || function.data_bytes / function.samples < values + 8;
  return is_single ? 4 : 8;
}

std::vector<double> BinaryNumbers(const FileBytes& bytes, const UniversalFunction& function) {
  const std::uint64_t of_time = BytesOfTime(function);
  const std::uint64_t parts = function.is_complex ? 2 : 1;
  const std::uint64_t size = function.is_double ? 8 : 4;
  const std::uint64_t stride = of_time + parts * size;
  const std::string data = bytes.Read(function.data_at, function.samples * stride, "the data set 58b");
  const StoredNumber time = {StoredNumber::Kind::kFloat, of_time, function.is_big_endian};
  const StoredNumber value = {StoredNumber::Kind::kFloat, size, function.is_big_endian};
  std::vector<double> numbers;
  numbers.reserve(function.samples * Width(function));
  for (std::uint64_t i = 0; i < function.samples; ++i) {
    const std::string_view sample = std::string_view(data).substr(i * stride, stride);
    if (of_time > 0) AppendNumbers(sample, time, 1, of_time, numbers);
    AppendNumbers(sample.substr(of_time), value, parts, size, numbers);
  }
  return numbers;
}

}  // namespace

std::string UniversalPoint::Text() const {
  if (node == 0) return "";
  return std::to_string(node) + (direction.empty() ? "" : " " + direction);
}

UniversalNumbers ReadNumbers(const FileBytes& bytes, const UniversalFunction& function) {
  const std::vector<double> numbers =
      function.is_binary ? BinaryNumbers(bytes, function) : TextNumbers(bytes, function);
  const std::uint64_t width = Width(function);
  UniversalNumbers read;
  for (std::uint64_t i = 0; i < function.samples; ++i) {
    std::uint64_t at = i * width;
    if (!function.is_even) read.abscissa.push_back(numbers[at++]);
    read.values.emplace_back(numbers[at], function.is_complex ? numbers[at + 1] : 0);
  }
  return read;
}

}  // namespace fourpost
