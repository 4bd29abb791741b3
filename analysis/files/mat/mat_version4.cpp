#include "analysis/files/mat/mat_version4.h"

#include <algorithm>
#include <array>

#include "analysis/files/mat/findings.h"
#include "analysis/files/mat/mat_bytes.h"

namespace fourpost {
namespace {

using Kind = MatVariable::Kind;

/// What the number before a matrix says of it, digit by digit.
struct Type {
  bool is_big_endian = false;
  MatType numbers = MatType::kDouble;
  Kind kind = Kind::kNumbers;
};

Type TypeOf(std::string_view bytes) {
  constexpr std::array<MatType, 6> kNumbers = {MatType::kDouble, MatType::kSingle, MatType::kInt32,
                                               MatType::kInt16,  MatType::kUint16, MatType::kUint8};
  constexpr std::array<Kind, 3> kKinds = {Kind::kNumbers, Kind::kText, Kind::kOther};
  if (bytes.size() < 4) throw MatFault(kMatCutShort);
  for (const bool is_big_endian : {false, true}) {
    const std::uint32_t code = MatBytes(bytes, is_big_endian).TakeUint32();
    const bool is_known = code / 1000 == (is_big_endian ? 1 : 0) && code / 100 % 10 == 0 &&
                          code / 10 % 10 < kNumbers.size() && code % 10 < kKinds.size();
    if (is_known) return {is_big_endian, kNumbers[code / 10 % 10], kKinds[code % 10]};
  }
  throw MatFault(kMatNotReadable);
}

std::uint64_t BytesOf(MatType type) {
  switch (type) {
    case MatType::kDouble: return 8;
    case MatType::kSingle:
    case MatType::kInt32: return 4;
    case MatType::kUint8: return 1;
    default: return 2;
  }
}

MatVariable TakeMatrix(std::string_view& bytes) {
  const Type type = TypeOf(bytes);
  MatBytes rest(bytes.substr(4), type.is_big_endian);
  MatVariable variable;
  variable.dims = {rest.TakeUint32(), rest.TakeUint32()};
  const bool is_complex = rest.TakeUint32() != 0;
  const std::string_view name = rest.TakeText(rest.TakeUint32());
  // Ends with a zero.
  variable.name = name.substr(0, name.find('\0'));
  // Lengths of 32 bits: no product of these is beyond 64.
  if (variable.Length() > bytes.size()) throw MatFault(kMatCutShort);
  const MatBytes numbers = rest.Take(variable.Length() * BytesOf(type.numbers));
  if (is_complex) rest.Take(variable.Length() * BytesOf(type.numbers));
  bytes = rest.text();
  if (is_complex || type.kind == Kind::kOther) return variable;
  if (type.kind == Kind::kText && numbers.text().size() > kLongestMatText) return variable;
  variable.kind = type.kind;
  variable.numbers = numbers.Numbers(type.numbers);
  if (type.kind == Kind::kNumbers) return variable;
  std::vector<std::string> characters;
  for (const double code : variable.numbers)
    characters.push_back(code >= 0 && code < 0x110000 ? Utf8(static_cast<std::uint32_t>(code)) : "?");
  variable.rows = RowsOf(characters, variable.dims[0]);
  variable.numbers.clear();
  return variable;
}

}  // namespace

std::vector<MatVariable> ReadMatVersion4(std::string_view bytes) {
  std::vector<MatVariable> variables;
  while (!bytes.empty()) variables.push_back(TakeMatrix(bytes));
  return variables;
}

}  // namespace fourpost
