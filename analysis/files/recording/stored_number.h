#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

namespace fourpost {

/// How a file stores a number.
struct StoredNumber {
  enum class Kind { kSigned, kUnsigned, kFloat };

  Kind kind = Kind::kSigned;
  /// Bytes: 1, 2, 4 or 8; floats 4 or 8.
  std::size_t size = 2;
  bool is_big_endian = false;
};

static_assert(std::endian::native == std::endian::little);

/// That begins at `place`.
template <typename Number>
Number NumberAt(const char* place, bool is_big_endian) {
  std::array<char, sizeof(Number)> bytes;
  std::copy_n(place, sizeof(Number), bytes.begin());
  if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

/// Appends those that begin at every `stride` bytes; `bytes` must hold `count` of them.
void AppendNumbers(std::string_view bytes, const StoredNumber& stored, std::size_t count, std::size_t stride,
                   std::vector<double>& numbers);

}  // namespace fourpost
