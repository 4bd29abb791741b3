#include "analysis/files/recording/stored_number.h"

namespace fourpost {
namespace {

template <typename Number>
void Append(std::string_view bytes, bool is_big_endian, std::size_t count, std::size_t stride,
            std::vector<double>& numbers) {
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(static_cast<double>(NumberAt<Number>(bytes.data() + i * stride, is_big_endian)));
}

}  // namespace

void AppendNumbers(std::string_view bytes, const StoredNumber& stored, std::size_t count, std::size_t stride,
                   std::vector<double>& numbers) {
  const bool big = stored.is_big_endian;
  const auto append = [&]<typename Number>(Number) { Append<Number>(bytes, big, count, stride, numbers); };
  using Kind = StoredNumber::Kind;
  const bool is_signed = stored.kind == Kind::kSigned;
  if (stored.kind == Kind::kFloat) return stored.size == 4 ? append(float{}) : append(double{});
  switch (stored.size) {
    case 1: return is_signed ? append(std::int8_t{}) : append(std::uint8_t{});
    case 2: return is_signed ? append(std::int16_t{}) : append(std::uint16_t{});
    case 4: return is_signed ? append(std::int32_t{}) : append(std::uint32_t{});
    default: return is_signed ? append(std::int64_t{}) : append(std::uint64_t{});
  }
}

}  // namespace fourpost
