#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fourpost {

/// Types of numbers, by the codes of version 5 ("MAT-File Format", MathWorks, table 1-1).
enum class MatType : std::uint32_t {
  kInt8 = 1,
  kUint8 = 2,
  kInt16 = 3,
  kUint16 = 4,
  kInt32 = 5,
  kUint32 = 6,
  kSingle = 7,
  kDouble = 9,
  kInt64 = 12,
  kUint64 = 13,
  kMatrix = 14,
  kCompressed = 15,
  kUtf8 = 16,
  kUtf16 = 17,
  kUtf32 = 18,
};

/// Bytes of a MAT file of versions 4 and 5, taken from their front. What is taken is never longer than what is there:
/// nothing that a file says of its lengths is believed before. Throws MatFault.
class MatBytes {
 public:
  /// The bytes must outlive it.
  MatBytes(std::string_view bytes, bool is_big_endian) : rest_(bytes), is_big_endian_(is_big_endian) {}

  bool empty() const { return rest_.empty(); }
  bool is_big_endian() const { return is_big_endian_; }

  /// The next ones, as bytes of the same order.
  MatBytes Take(std::uint64_t count);
  std::string_view TakeText(std::uint64_t count);
  std::uint32_t TakeUint32();

  /// All that are left, as numbers of this type; throws when they are no whole number of them.
  std::vector<double> Numbers(MatType type) const;
  /// All that are left, a text each.
  std::vector<std::string> Characters(MatType type) const;
  std::string_view text() const { return rest_; }

 private:
  template <typename Number>
  std::vector<double> All() const;

  std::string_view rest_;
  bool is_big_endian_;
};

}  // namespace fourpost
