#include "analysis/files/mat/mat_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "analysis/files/mat/findings.h"
#include "analysis/files/mat/mat_variable.h"

namespace fourpost {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename Number>
Number NumberAt(const char* place, bool is_big_endian) {
  std::array<char, sizeof(Number)> bytes;
  std::copy_n(place, sizeof(Number), bytes.begin());
  if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

}  // namespace

MatBytes MatBytes::Take(std::uint64_t count) { return {TakeText(count), is_big_endian_}; }

std::string_view MatBytes::TakeText(std::uint64_t count) {
  if (count > rest_.size()) throw MatFault(kMatCutShort);
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::uint32_t MatBytes::TakeUint32() { return NumberAt<std::uint32_t>(TakeText(4).data(), is_big_endian_); }

template <typename Number>
std::vector<double> MatBytes::All() const {
  if (rest_.size() % sizeof(Number) != 0) throw MatFault(kMatPartialNumber);
  std::vector<double> numbers(rest_.size() / sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<double>(NumberAt<Number>(rest_.data() + i * sizeof(Number), is_big_endian_));
  return numbers;
}

std::vector<double> MatBytes::Numbers(MatType type) const {
  switch (type) {
    case MatType::kInt8: return All<std::int8_t>();
    case MatType::kUint8: return All<std::uint8_t>();
    case MatType::kInt16: return All<std::int16_t>();
    case MatType::kUint16: return All<std::uint16_t>();
    case MatType::kInt32: return All<std::int32_t>();
    case MatType::kUint32: return All<std::uint32_t>();
    case MatType::kSingle: return All<float>();
    case MatType::kDouble: return All<double>();
    case MatType::kInt64: return All<std::int64_t>();
    case MatType::kUint64: return All<std::uint64_t>();
    default: throw MatFault(kMatNumberType, {std::to_string(static_cast<std::uint32_t>(type))});
  }
}

std::vector<std::string> MatBytes::Characters(MatType type) const {
  std::vector<std::string> characters;
  if (type == MatType::kInt8 || type == MatType::kUint8 || type == MatType::kUtf8) {
    for (const char c : rest_) characters.emplace_back(1, c);
    return characters;
  }
  const MatType code = type == MatType::kUtf16 ? MatType::kUint16 : type == MatType::kUtf32 ? MatType::kUint32 : type;
  for (const double number : Numbers(code))
    characters.push_back(number >= 0 && number < 0x110000 ? Utf8(static_cast<std::uint32_t>(number)) : "?");
  return characters;
}

}  // namespace fourpost
