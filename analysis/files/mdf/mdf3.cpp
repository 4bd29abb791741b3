#include <algorithm>
#include <set>

#include "analysis/files/mdf/findings.h"
#include "analysis/files/mdf/mdf_index.h"
#include "analysis/files/recording/recording_fault.h"

namespace fourpost {
namespace {

struct OldBlock {
  std::uint64_t at = 0;
  std::string bytes;
  bool is_big_endian = false;

  template <typename Number>
  Number At(std::size_t offset) const {
    if (offset + sizeof(Number) > bytes.size())
      throw RecordingFault(kMdfBlock, {"block '" + bytes.substr(0, 2) + "' is too short", std::to_string(at)});
    return NumberAt<Number>(bytes.data() + offset, is_big_endian);
  }

  /// Up to the zero that ends it, without blanks behind it.
  std::string Text(std::size_t offset, std::size_t size) const {
    if (offset >= bytes.size()) return "";
    std::string text = bytes.substr(offset, size);
    text.resize(std::min(text.find('\0'), text.size()));
    return text.substr(0, text.find_last_not_of(" \r\n") + 1);
  }
};

class Mdf3Reader {
 public:
  explicit Mdf3Reader(const FileBytes& bytes) : bytes_(bytes) {
    const std::string id = bytes.Read(0, 64, "the head");
    is_big_endian_ = NumberAt<std::uint16_t>(id.data() + 24, false) != 0;
  }

  MdfIndex Read() {
    const OldBlock header = Read(64, "HD");
    index_.description = TextAt(header.At<std::uint32_t>(8));
    for (std::uint64_t at = header.At<std::uint32_t>(4); at != 0;) {
      const OldBlock group = Next(at, "DG");
      ReadDataGroup(group);
      at = group.At<std::uint32_t>(4);
    }
    return std::move(index_);
  }

 private:
  OldBlock Read(std::uint64_t at, const char* id) const {
    const std::string head = bytes_.Read(at, 4, "a block");
    if (!head.starts_with(id))
      throw RecordingFault(kMdfBlock, {"no block '" + std::string(id) + "' is", std::to_string(at)});
    const std::uint64_t size = NumberAt<std::uint16_t>(head.data() + 2, is_big_endian_);
    return {at, bytes_.Read(at, size, "block '" + std::string(id) + "'"), is_big_endian_};
  }

  OldBlock Next(std::uint64_t at, const char* id) {
    if (!seen_.insert(at).second)
      throw RecordingFault(kMdfBlock, {"blocks refer to each other in a circle", std::to_string(at)});
    return Read(at, id);
  }

  std::string TextAt(std::uint64_t at) const {
    if (at == 0) return "";
    const OldBlock block = Read(at, "TX");
    return block.Text(4, block.bytes.size());
  }

  void ReadDataGroup(const OldBlock& data_group) {
    const std::uint64_t groups = data_group.At<std::uint16_t>(20);
    const std::uint64_t ids = data_group.At<std::uint16_t>(22);
    const std::uint64_t at = data_group.At<std::uint32_t>(8);
    if (at == 0) return;
    if (groups > 1) throw RecordingFault(kMdfUnsorted, {std::to_string(data_group.at)});
    const OldBlock channel_group = Next(at, "CG");
    MdfGroup group = {.name = TextAt(channel_group.At<std::uint32_t>(12)),
                      .cycles = channel_group.At<std::uint32_t>(22)};
    if (group.name.empty()) group.name = "group " + std::to_string(index_.groups.size() + 1);
    // One before each record, or one behind it as well.
    const std::uint64_t id_bytes = std::min<std::uint64_t>(ids, 1);
    group.record_bytes = channel_group.At<std::uint16_t>(20) + std::min<std::uint64_t>(ids, 2);
    if (group.cycles == 0 || group.record_bytes == 0) return;
    const std::uint64_t data_at = data_group.At<std::uint32_t>(16);
    const std::uint64_t size = group.cycles * group.record_bytes;
    bytes_.Require(data_at, size, "the data of a group");
    group.pieces.push_back({.at = data_at, .stored = size, .bytes = size});
    for (std::uint64_t channel = channel_group.At<std::uint32_t>(8); channel != 0;) {
      const OldBlock block = Next(channel, "CN");
      ReadChannel(block, id_bytes, group);
      channel = block.At<std::uint32_t>(4);
    }
    index_.groups.push_back(std::move(group));
  }

  void ReadChannel(const OldBlock& block, std::uint64_t id_bytes, MdfGroup& group) {
    constexpr std::size_t kLongName = 218;
    constexpr std::size_t kMoreBytes = 226;
    MdfSignal signal = {.name = block.Text(26, 32)};
    if (block.bytes.size() >= kLongName + 4)
      if (const std::string name = TextAt(block.At<std::uint32_t>(kLongName)); !name.empty()) signal.name = name;
    const unsigned type = block.At<std::uint16_t>(190);
    const unsigned first_bit = block.At<std::uint16_t>(186);
    const std::uint64_t more = block.bytes.size() >= kMoreBytes + 2 ? block.At<std::uint16_t>(kMoreBytes) : 0;
    signal.field = {.is_big_endian = is_big_endian_,
                    .byte = id_bytes + first_bit / 8 + more,
                    .bit = first_bit % 8,
                    .bits = block.At<std::uint16_t>(188)};
    const bool is_read = ReadType(type, signal.field) && ReadConversion(block.At<std::uint32_t>(8), signal) &&
                         signal.field.IsWithin(group.record_bytes);
    if (!is_read) index_.left_out.push_back(signal.name);
    else if (block.At<std::uint16_t>(24) == 1) group.times = std::move(signal);
    else group.signals.push_back(std::move(signal));
  }

  static bool ReadType(unsigned type, MdfField& field) {
    // 0 to 3 in the file's order of bytes, 9 to 12 big endian, 13 to 16 little endian.
    if (type >= 9 && type <= 12) field.is_big_endian = true;
    if (type >= 13 && type <= 16) field.is_big_endian = false;
    const unsigned kind = type >= 13 ? type - 13 : type >= 9 ? type - 9 : type;
    if (type > 16 || kind > 3) return false;
    field.kind = kind == 0   ? StoredNumber::Kind::kUnsigned
                 : kind == 1 ? StoredNumber::Kind::kSigned
                             : StoredNumber::Kind::kFloat;
    return true;
  }

  bool ReadConversion(std::uint64_t at, MdfSignal& signal) const {
    if (at == 0) return true;
    const OldBlock block = Read(at, "CC");
    signal.unit = block.Text(22, 20);
    const unsigned type = block.At<std::uint16_t>(42);
    const std::size_t count = block.At<std::uint16_t>(44);
    using Kind = MdfConversion::Kind;
    constexpr unsigned kNone = 65535;
    if (type == kNone) return true;
    if (type == 0) signal.conversion.kind = Kind::kLinear;
    else if (type == 1) signal.conversion.kind = Kind::kInterpolated;
    else if (type == 2) signal.conversion.kind = Kind::kTable;
    else if (type == 9) signal.conversion.kind = Kind::kRational;
    else return false;
    // Tables have pairs.
    const std::size_t numbers = type == 1 || type == 2 ? 2 * count : count;
    for (std::size_t i = 0; i < numbers; ++i) signal.conversion.numbers.push_back(block.At<double>(46 + 8 * i));
    return signal.conversion.IsComplete();
  }

  const FileBytes& bytes_;
  bool is_big_endian_ = false;
  MdfIndex index_;
  std::set<std::uint64_t> seen_;
};

}  // namespace

MdfIndex ReadMdf3(const FileBytes& bytes) { return Mdf3Reader(bytes).Read(); }

}  // namespace fourpost
