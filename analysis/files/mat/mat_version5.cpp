#include "analysis/files/mat/mat_version5.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <string>

#include "analysis/files/mat/findings.h"
#include "analysis/files/mat/mat_bytes.h"

namespace fourpost {
namespace {

using Kind = MatVariable::Kind;

constexpr std::size_t kHead = 128;
constexpr std::size_t kMostInflated = std::size_t{1} << 30;

enum Class : std::uint32_t { kCell = 1, kStruct = 2, kChar = 4, kFirstNumbers = 6, kLastNumbers = 15 };

struct Element {
  MatType type = MatType::kInt8;
  MatBytes bytes;
};

/// The next one, with the bytes that fill it up to eight but for one that is compressed.
Element TakeElement(MatBytes& rest) {
  const std::uint32_t first = rest.TakeUint32();
  // Up to four bytes stand in the tag itself.
  if (const std::uint32_t small = first >> 16; small != 0) {
    MatBytes held = rest.Take(4);
    return {static_cast<MatType>(first & 0xFFFF), held.Take(small)};
  }
  const auto type = static_cast<MatType>(first);
  const std::uint32_t length = rest.TakeUint32();
  Element element{type, rest.Take(length)};
  const std::uint64_t filling = type == MatType::kCompressed ? 0 : (8 - length % 8) % 8;
  // Some programs leave it out behind the last one.
  rest.Take(std::min<std::uint64_t>(filling, rest.text().size()));
  return element;
}

MatBytes TakeNumbersOf(MatBytes& rest, MatType type) {
  const Element element = TakeElement(rest);
  if (element.type != type) throw MatFault(kMatHeader);
  return element.bytes;
}

MatVariable ReadMatrix(MatBytes rest, int depth);

std::vector<MatVariable> TakeParts(MatBytes& rest, std::uint64_t count, int depth) {
  std::vector<MatVariable> parts;
  for (; count > 0; --count) {
    const Element element = TakeElement(rest);
    if (element.type != MatType::kMatrix) throw MatFault(kMatPart);
    parts.push_back(ReadMatrix(element.bytes, depth + 1));
  }
  return parts;
}

/// Each name fills up the same number of bytes with zeros.
std::vector<std::string> TakeFieldNames(MatBytes& rest) {
  const std::uint32_t length = TakeNumbersOf(rest, MatType::kInt32).TakeUint32();
  MatBytes bytes = TakeElement(rest).bytes;
  if (length == 0) return {};
  std::vector<std::string> names;
  while (!bytes.empty()) {
    const std::string_view name = bytes.TakeText(length);
    names.emplace_back(name.substr(0, name.find('\0')));
  }
  return names;
}

void ReadStructure(MatBytes& rest, int depth, MatVariable& variable) {
  // An array of structures is no set of channels.
  if (variable.Length() != 1) return;
  variable.kind = Kind::kStructure;
  const std::vector<std::string> names = TakeFieldNames(rest);
  variable.parts = TakeParts(rest, names.size(), depth);
  for (std::size_t i = 0; i < names.size(); ++i) variable.parts[i].name = names[i];
}

/// A line of text is what the file holds, however long its dimensions say it is: bytes of UTF-8 are more.
void ReadText(MatBytes& rest, MatVariable& variable) {
  if (rest.empty()) return;
  const Element element = TakeElement(rest);
  if (element.bytes.text().size() > kLongestMatText) return;
  variable.kind = Kind::kText;
  const std::vector<std::string> characters = element.bytes.Characters(element.type);
  if (variable.dims[0] > 1) RequireLength(variable, characters.size(), "characters");
  variable.rows = RowsOf(characters, std::max<std::uint64_t>(variable.dims[0], 1));
}

void ReadNumbers(MatBytes& rest, MatVariable& variable) {
  variable.kind = Kind::kNumbers;
  const Element element = TakeElement(rest);
  variable.numbers = element.bytes.Numbers(element.type);
  RequireLength(variable, variable.numbers.size(), "numbers");
}

MatVariable ReadMatrix(MatBytes rest, int depth) {
  MatVariable variable;
  // An empty one has not even a class.
  if (rest.empty()) return variable;
  if (depth > kDeepestMat) throw MatFault(kMatDepth, {std::to_string(depth)});
  const std::uint32_t flags = TakeNumbersOf(rest, MatType::kUint32).TakeUint32();
  for (const double side : TakeNumbersOf(rest, MatType::kInt32).Numbers(MatType::kInt32)) {
    if (side < 0) throw MatFault(kMatNegativeDimension);
    variable.dims.push_back(static_cast<std::uint64_t>(side));
  }
  if (variable.dims.size() < 2) throw MatFault(kMatDimensions);
  variable.name = TakeElement(rest).bytes.text();
  constexpr std::uint32_t kComplex = 0x800;
  const std::uint32_t kind = flags & 0xFF;
  if (kind == kCell) {
    variable.kind = Kind::kCells;
    variable.parts = TakeParts(rest, variable.Length(), depth);
  } else if (kind == kStruct) {
    ReadStructure(rest, depth, variable);
  } else if (kind == kChar) {
    ReadText(rest, variable);
  } else if (kind >= kFirstNumbers && kind <= kLastNumbers && (flags & kComplex) == 0) {
    ReadNumbers(rest, variable);
  }
  return variable;
}

/// zlib's state for as long as it is used.
class Inflater {
 public:
  explicit Inflater(std::string_view compressed) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
    stream_.avail_in = static_cast<uInt>(compressed.size());
    if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// At most so many bytes; fewer at the end.
  std::string Next(std::size_t most) {
    std::string bytes(most, '\0');
    stream_.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream_.avail_out = static_cast<uInt>(most);
    const int code = inflate(&stream_, Z_NO_FLUSH);
    if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) throw MatFault(kMatInflate);
    bytes.resize(most - stream_.avail_out);
    return bytes;
  }

 private:
  z_stream stream_{};
};

/// Piece by piece, so that only what is there takes memory.
std::string Inflated(std::string_view compressed, std::size_t most) {
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  Inflater inflater(compressed);
  std::string all;
  for (std::string piece = inflater.Next(kPiece); !piece.empty(); piece = inflater.Next(kPiece)) {
    if (all.size() + piece.size() > most) throw MatFault(kMatTooLarge);
    all += piece;
  }
  return all;
}

}  // namespace

bool IsMatVersion5(std::string_view bytes) {
  if (bytes.size() < kHead || !bytes.starts_with("MATLAB 5.0")) return false;
  const std::string_view order = bytes.substr(kHead - 2, 2);
  return order == "IM" || order == "MI";
}

std::vector<MatVariable> ReadMatVersion5(std::string_view bytes) {
  const bool is_big_endian = bytes[kHead - 2] == 'M';
  MatBytes rest(bytes.substr(kHead), is_big_endian);
  std::vector<MatVariable> variables;
  std::size_t inflated = 0;
  while (!rest.empty()) {
    const Element element = TakeElement(rest);
    if (element.type == MatType::kMatrix) variables.push_back(ReadMatrix(element.bytes, 0));
    if (element.type != MatType::kCompressed) continue;
    const std::string unpacked = Inflated(element.bytes.text(), kMostInflated - inflated);
    inflated += unpacked.size();
    MatBytes inner(unpacked, is_big_endian);
    const Element variable = TakeElement(inner);
    if (variable.type == MatType::kMatrix) variables.push_back(ReadMatrix(variable.bytes, 0));
  }
  return variables;
}

}  // namespace fourpost
