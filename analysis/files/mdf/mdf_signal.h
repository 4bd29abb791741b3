#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/files/recording/file_bytes.h"
#include "analysis/files/recording/stored_number.h"

namespace fourpost {

/// From the number in a record to the value of a channel.
struct MdfConversion {
  /// Codes of version 4: linear, rational, and a table between whose points values are interpolated or not.
  enum class Kind { kNone, kLinear, kRational, kInterpolated, kTable };

  Kind kind = Kind::kNone;
  /// kLinear: offset and factor; kRational: p1 to p6 of (p1 x^2 + p2 x + p3) / (p4 x^2 + p5 x + p6); of tables pairs.
  std::vector<double> numbers;

  /// Whether there are as many numbers as the kind needs.
  bool IsComplete() const;
  double Of(double raw) const;
};

/// A number in a record.
struct MdfField {
  StoredNumber::Kind kind = StoredNumber::Kind::kUnsigned;
  bool is_big_endian = false;
  /// From the beginning of a record, its id included.
  std::uint64_t byte = 0;
  unsigned bit = 0;
  unsigned bits = 0;
  /// Set where the number is not valid; nothing where it always is.
  std::optional<std::uint64_t> invalid_bit = std::nullopt;

  /// Whether it is a number that is read, within a record of so many bytes.
  bool IsWithin(std::uint64_t record_bytes) const;
  /// NaN where it is not valid.
  double In(std::string_view record) const;
};

struct MdfSignal {
  std::string name;
  std::string unit;
  MdfField field;
  MdfConversion conversion;
};

/// A stretch of the records of a group, which may begin and end within one.
struct MdfPiece {
  /// Of the stored bytes.
  std::uint64_t at = 0;
  std::uint64_t stored = 0;
  /// Of the records.
  std::uint64_t bytes = 0;
  bool is_deflated = false;
  /// Bytes of a row that was transposed before it was packed; 0: none.
  std::uint64_t row = 0;
};

/// Channels with the same times.
struct MdfGroup {
  std::string name;
  std::uint64_t cycles = 0;
  std::uint64_t record_bytes = 0;
  std::vector<MdfPiece> pieces;
  std::vector<MdfSignal> signals;
  /// Times in s; `field` without bits: those are the numbers of the records.
  std::optional<MdfSignal> times;
};

struct MdfIndex {
  std::string description;
  std::vector<MdfGroup> groups;
  /// Names of channels that are no plain numbers.
  std::vector<std::string> left_out;
};

/// The values of a signal in all records. Throws RecordingFault.
std::vector<double> ReadSignal(const FileBytes& bytes, const MdfGroup& group, const MdfSignal& signal);

}  // namespace fourpost
