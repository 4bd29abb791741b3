#include <algorithm>
#include <set>

#include "analysis/files/mdf/findings.h"
#include "analysis/files/mdf/mdf_index.h"
#include "analysis/files/recording/inflated.h"
#include "analysis/files/recording/recording_fault.h"

namespace fourpost {
namespace {

/// Header of a block: id, filling, length, number of links.
constexpr std::uint64_t kHead = 24;
/// No block but those of data is as long.
constexpr std::uint64_t kLongestBlock = std::uint64_t{1} << 24;
/// Of a DZ block: type, kind of packing, its parameter, lengths.
constexpr std::uint64_t kPackedHead = 24;
/// A channel of a channel of a channel: no recorder goes that far down.
constexpr int kDeepest = 8;

struct Block {
  std::uint64_t at = 0;
  std::string id;
  std::uint64_t length = 0;
  std::vector<std::uint64_t> links;
  /// Behind the links; of data blocks empty.
  std::string data;

  std::uint64_t Link(std::size_t i) const { return i < links.size() ? links[i] : 0; }

  template <typename Number>
  Number At(std::size_t offset) const {
    if (offset + sizeof(Number) > data.size())
      throw RecordingFault(kMdfBlock, {"block '" + id + "' is too short", std::to_string(at)});
    return NumberAt<Number>(data.data() + offset, false);
  }
};

class Mdf4Reader {
 public:
  explicit Mdf4Reader(const FileBytes& bytes) : bytes_(bytes) {}

  MdfIndex Read() {
    constexpr std::uint64_t kHeader = 64;
    const Block header = Read(kHeader, "##HD");
    index_.description = Text(header.Link(5));
    for (std::uint64_t at = header.Link(0); at != 0;) {
      const Block group = Next(at, "##DG");
      ReadDataGroup(group);
      at = group.Link(0);
    }
    return std::move(index_);
  }

 private:
  /// Block with its links and, unless it is one of data, its content.
  Block Read(std::uint64_t at, const char* id) {
    const std::string head = bytes_.Read(at, kHead, "a block");
    Block block = {.at = at, .id = head.substr(0, 4), .length = NumberAt<std::uint64_t>(head.data() + 8, false)};
    const auto links = NumberAt<std::uint64_t>(head.data() + 16, false);
    if (id != nullptr && block.id != id)
      throw RecordingFault(kMdfBlock, {"no block '" + std::string(id) + "' is", std::to_string(at)});
    if (block.length < kHead || links > (block.length - kHead) / 8)
      throw RecordingFault(kMdfBlock, {"block '" + block.id.substr(2) + "' is too short", std::to_string(at)});
    bytes_.Require(at, block.length, "block '" + block.id.substr(2) + "'");
    const bool is_data = block.id == "##DT" || block.id == "##SD" || block.id == "##DV";
    const std::uint64_t taken = is_data ? 0 : block.id == "##DZ" ? kPackedHead : block.length - kHead;
    if (taken > kLongestBlock || (block.id == "##DZ" && block.length < kHead + kPackedHead))
      throw RecordingFault(kMdfBlock, {"block '" + block.id.substr(2) + "' has a wrong length", std::to_string(at)});
    const std::string rest = bytes_.Read(at + kHead, taken, "a block");
    for (std::uint64_t i = 0; i < links && (i + 1) * 8 <= rest.size(); ++i)
      block.links.push_back(NumberAt<std::uint64_t>(rest.data() + 8 * i, false));
    block.data = rest.substr(std::min<std::size_t>(8 * block.links.size(), rest.size()));
    return block;
  }

  /// One of a list, which may not come back to itself.
  Block Next(std::uint64_t at, const char* id) {
    if (!seen_.insert(at).second)
      throw RecordingFault(kMdfBlock, {"blocks refer to each other in a circle", std::to_string(at)});
    return Read(at, id);
  }

  /// Of a TX block, or between <TX> and </TX> of an MD block; empty without one.
  std::string Text(std::uint64_t at) {
    if (at == 0) return "";
    const Block block = Read(at, nullptr);
    if (block.id != "##TX" && block.id != "##MD") return "";
    std::string text = block.data.substr(0, block.data.find('\0'));
    if (block.id == "##TX") return text;
    const std::size_t begin = text.find("<TX>");
    const std::size_t end = text.find("</TX>");
    return begin == std::string::npos || end == std::string::npos || end < begin + 4
               ? ""
               : text.substr(begin + 4, end - begin - 4);
  }

  void ReadDataGroup(const Block& data_group) {
    const unsigned id_bytes = data_group.At<std::uint8_t>(0);
    std::vector<Block> channel_groups;
    for (std::uint64_t at = data_group.Link(1); at != 0;) {
      channel_groups.push_back(Next(at, "##CG"));
      at = channel_groups.back().Link(0);
    }
    if (channel_groups.empty()) return;
    if (channel_groups.size() > 1) throw RecordingFault(kMdfUnsorted, {std::to_string(data_group.at)});
    const Block& channel_group = channel_groups.front();
    MdfGroup group = {.name = Text(channel_group.Link(2)), .cycles = channel_group.At<std::uint64_t>(8)};
    if (group.name.empty()) group.name = "group " + std::to_string(index_.groups.size() + 1);
    const std::uint64_t data_bytes = channel_group.At<std::uint32_t>(24);
    group.record_bytes = id_bytes + data_bytes + channel_group.At<std::uint32_t>(28);
    if (group.cycles == 0 || group.record_bytes == 0) return;
    AddPieces(data_group.Link(2), group);
    RequireRecords(group, channel_group.at);
    ReadChannels(channel_group.Link(1), "", id_bytes, data_bytes, 0, group);
    index_.groups.push_back(std::move(group));
  }

  void AddPieces(std::uint64_t at, MdfGroup& group) {
    if (at == 0) return;
    const Block block = Next(at, nullptr);
    if (block.id == "##DT") {
      const std::uint64_t size = block.length - kHead;
      if (size > 0) group.pieces.push_back({.at = at + kHead, .stored = size, .bytes = size});
    } else if (block.id == "##DZ") {
      AddPacked(block, group);
    } else if (block.id == "##HL") {
      AddPieces(block.Link(0), group);
    } else if (block.id == "##DL") {
      AddList(block, group);
    } else {
      throw RecordingFault(kMdfData, {block.id.substr(2), std::to_string(at)});
    }
  }

  void AddList(Block list, MdfGroup& group) {
    for (;;) {
      for (std::size_t i = 1; i < list.links.size(); ++i) AddPieces(list.links[i], group);
      if (list.Link(0) == 0) return;
      list = Next(list.Link(0), "##DL");
    }
  }

  void AddPacked(const Block& block, MdfGroup& group) {
    // A DZ block has no links, and `data` is its head.
    const unsigned kind = block.At<std::uint8_t>(2);
    const std::uint64_t row = block.At<std::uint32_t>(4);
    MdfPiece piece = {.at = block.at + kHead + kPackedHead,
                      .stored = block.At<std::uint64_t>(16),
                      .bytes = block.At<std::uint64_t>(8),
                      .is_deflated = true,
                      .row = kind == 1 ? row : 0};
    if (block.data.substr(0, 2) != "DT" || kind > 1) throw RecordingFault(kMdfData, {"DZ", std::to_string(block.at)});
    if (piece.stored > block.length - kHead - kPackedHead || piece.bytes / kClosestDeflated > piece.stored ||
        (kind == 1 && row == 0))
      throw RecordingFault(kMdfBlock, {"block 'DZ' has a wrong length", std::to_string(block.at)});
    if (piece.bytes > 0) group.pieces.push_back(piece);
  }

  void ReadChannels(std::uint64_t at, const std::string& above, unsigned id_bytes, std::uint64_t data_bytes, int depth,
                    MdfGroup& group) {
    while (at != 0) {
      const Block block = Next(at, "##CN");
      at = block.Link(0);
      const std::string name = above + Text(block.Link(2));
      if (const std::uint64_t parts = block.Link(1); parts != 0) {
        if (depth < kDeepest && Read(parts, nullptr).id == "##CN")
          ReadChannels(parts, name + ".", id_bytes, data_bytes, depth + 1, group);
        else index_.left_out.push_back(name);
        continue;
      }
      ReadChannel(block, name, id_bytes, data_bytes, group);
    }
  }

  void ReadChannel(const Block& block, const std::string& name, unsigned id_bytes, std::uint64_t data_bytes,
                   MdfGroup& group) {
    enum : unsigned { kFixed = 0, kMaster = 2, kVirtualMaster = 3, kVirtual = 6 };
    constexpr unsigned kTime = 1;
    constexpr unsigned kFlagInvalid = 2;
    const unsigned kind = block.At<std::uint8_t>(0);
    const bool is_virtual = kind == kVirtualMaster || kind == kVirtual;
    MdfSignal signal = {.name = name, .unit = Text(block.Link(6))};
    const unsigned type = block.At<std::uint8_t>(2);
    signal.field = {.kind = type >= 4   ? StoredNumber::Kind::kFloat
                            : type >= 2 ? StoredNumber::Kind::kSigned
                                        : StoredNumber::Kind::kUnsigned,
                    .is_big_endian = type % 2 == 1,
                    .byte = id_bytes + std::uint64_t{block.At<std::uint32_t>(4)},
                    .bit = block.At<std::uint8_t>(3),
                    .bits = is_virtual ? 0 : block.At<std::uint32_t>(8)};
    if ((block.At<std::uint32_t>(12) & kFlagInvalid) != 0)
      signal.field.invalid_bit = 8 * (id_bytes + data_bytes) + block.At<std::uint32_t>(16);
    const bool is_read = ReadConversion(block.Link(4), signal) && type <= 5 &&
                         (is_virtual || kind == kFixed || kind == kMaster) &&
                         (is_virtual || signal.field.IsWithin(group.record_bytes));
    if (!is_read) index_.left_out.push_back(name);
    else if (kind != kMaster && kind != kVirtualMaster) group.signals.push_back(std::move(signal));
    else if (block.At<std::uint8_t>(1) == kTime) group.times = std::move(signal);
  }

  /// False for one that is not read, as those to texts.
  bool ReadConversion(std::uint64_t at, MdfSignal& signal) {
    if (at == 0) return true;
    const Block block = Read(at, "##CC");
    if (signal.unit.empty()) signal.unit = Text(block.Link(1));
    const unsigned type = block.At<std::uint8_t>(0);
    if (type == 0) return true;
    using Kind = MdfConversion::Kind;
    constexpr std::array<Kind, 6> kKinds = {Kind::kNone, Kind::kLinear,       Kind::kRational,
                                            Kind::kNone, Kind::kInterpolated, Kind::kTable};
    if (type >= kKinds.size() || kKinds[type] == Kind::kNone) return false;
    signal.conversion.kind = kKinds[type];
    constexpr std::size_t kNumbersAt = 24;
    const std::size_t count = block.At<std::uint16_t>(6);
    for (std::size_t i = 0; i < count; ++i) signal.conversion.numbers.push_back(block.At<double>(kNumbersAt + 8 * i));
    return signal.conversion.IsComplete();
  }

  const FileBytes& bytes_;
  MdfIndex index_;
  std::set<std::uint64_t> seen_;
};

}  // namespace

MdfIndex ReadMdf4(const FileBytes& bytes) { return Mdf4Reader(bytes).Read(); }

void RequireRecords(const MdfGroup& group, std::uint64_t at) {
  std::uint64_t held = 0;
  for (const MdfPiece& piece : group.pieces) held += piece.bytes;
  if (group.cycles <= held / group.record_bytes) return;
  throw RecordingFault(kMdfCycles, {std::to_string(at), std::to_string(group.cycles),
                                    std::to_string(group.record_bytes), std::to_string(held)});
}

}  // namespace fourpost
