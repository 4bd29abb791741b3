#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fourpost {

/// The digest of a text or of numbers, to compare two (SHA-256, FIPS 180-4).
class Sha256 {
 public:
  /// The bytes alone: "ab" and "c" give the digest of "a" and "bc".
  void AddBytes(std::string_view bytes);

  // Each with its length in front, so that no two sequences of calls give the same bytes.
  void Add(std::string_view text);
  void Add(std::span<const double> numbers);
  void Add(double number) { Add(std::span<const double>(&number, 1)); }

  /// Of all that was added: 64 hexadecimal digits. Ends the sum: throws std::logic_error when called again, as Add
  /// does.
  std::string Hex();
  /// The same in base 64, as pages name their scripts by it.
  std::string Base64();

 private:
  /// Its 32 bytes. Ends the sum.
  std::array<unsigned char, 32> Bytes();
  void AddBlock(const unsigned char* block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_ = {};
  std::size_t filled_ = 0;
  std::uint64_t length_ = 0;
  bool ended_ = false;
};

}  // namespace fourpost
