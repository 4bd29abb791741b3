#include "analysis/files/tdms/tdms_segment.h"

#include <algorithm>
#include <string_view>

#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/tdms/findings.h"

namespace fourpost {
namespace {

constexpr std::uint64_t kLeadIn = 28;
constexpr std::uint64_t kNotWritten = ~std::uint64_t{0};
/// Bits of a lead-in's mask.
enum : std::uint32_t {
  kMetaData = 1 << 1,
  kNewObjects = 1 << 2,
  kRawData = 1 << 3,
  kInterleaved = 1 << 5,
  kBigEndian = 1 << 6
};
/// In place of the length of an object's raw data index.
enum : std::uint32_t { kNoData = 0xFFFFFFFF, kSameAsBefore = 0, kFormatChanging = 0x1269, kDigitalLine = 0x126A };

/// Codes of tdsDataType.
enum : std::uint32_t {
  kFirstInteger = 1,
  kLastUnsigned = 8,
  kSingle = 9,
  kDouble = 10,
  kText = 0x20,
  kBoolean = 0x21,
  kTimeStamp = 0x44
};
constexpr std::uint32_t kWithUnit = 16;

std::uint64_t SizeOf(std::uint32_t type) {
  if (type >= kFirstInteger && type <= kLastUnsigned) return std::uint64_t{1} << (type - kFirstInteger) % 4;
  switch (type) {
    case kSingle:
    case kSingle + kWithUnit: return 4;
    case kDouble:
    case kDouble + kWithUnit: return 8;
    case kBoolean: return 1;
    case kTimeStamp: return 16;
    case 11:
    case 11 + kWithUnit: return 16;
    case 0x08000C: return 8;
    case 0x10000D: return 16;
    default: return 0;
  }
}

TdmsLayout LayoutOf(std::uint32_t type, bool is_big_endian) {
  using Kind = StoredNumber::Kind;
  TdmsLayout layout;
  layout.stored = {Kind::kSigned, SizeOf(type), is_big_endian};
  if (type >= kFirstInteger && type <= kLastUnsigned) layout.stored.kind = type > 4 ? Kind::kUnsigned : Kind::kSigned;
  else if (type == kBoolean) layout.stored.kind = Kind::kUnsigned;
  else if (type == kTimeStamp) layout.content = TdmsLayout::Content::kTimeStamps;
  else if (type == kSingle || type == kDouble || type == kSingle + kWithUnit || type == kDouble + kWithUnit)
    layout.stored.kind = Kind::kFloat;
  else layout.content = TdmsLayout::Content::kOther;
  return layout;
}

/// The metadata of a segment, from their front.
class MetaData {
 public:
  MetaData(std::string_view bytes, std::uint64_t at, bool is_big_endian)
      : bytes_(bytes), first_at_(at), is_big_endian_(is_big_endian) {}

  std::uint64_t at() const { return first_at_ + taken_; }
  bool is_big_endian() const { return is_big_endian_; }

  std::string_view Take(std::uint64_t count) {
    if (count > bytes_.size() - taken_)
      throw RecordingFault(kTdmsObject, {"the properties end within one", std::to_string(at())});
    const std::string_view taken = bytes_.substr(taken_, count);
    taken_ += count;
    return taken;
  }

  template <typename Number>
  Number Take() {
    return NumberAt<Number>(Take(sizeof(Number)).data(), is_big_endian_);
  }

  std::string TakeText() { return std::string(Take(Take<std::uint32_t>())); }

  TdmsProperty TakeProperty() {
    const auto type = Take<std::uint32_t>();
    if (type == kText) return TakeText();
    const std::uint64_t size = SizeOf(type);
    if (size == 0) throw RecordingFault(kTdmsObject, {"a property is of unknown type", std::to_string(at())});
    const TdmsLayout layout = LayoutOf(type, is_big_endian_);
    const std::string_view value = Take(size);
    if (layout.content == TdmsLayout::Content::kOther) return std::string();
    if (layout.content == TdmsLayout::Content::kTimeStamps)
      return static_cast<double>(NumberAt<std::int64_t>(value.data() + (is_big_endian_ ? 0 : 8), is_big_endian_));
    std::vector<double> numbers;
    AppendNumbers(value, layout.stored, 1, size, numbers);
    return numbers.front();
  }

 private:
  std::string_view bytes_;
  std::uint64_t first_at_;
  std::uint64_t taken_ = 0;
  bool is_big_endian_;
};

/// "/'Group'/'It''s a channel'".
TdmsPath PathOf(std::string_view text) {
  TdmsPath path;
  for (std::size_t at = 0; at + 1 < text.size() && text[at] == '/' && text[at + 1] == '\'';) {
    std::string name;
    for (at += 2; at < text.size(); ++at) {
      if (text[at] == '\'' && (at + 1 == text.size() || text[at + 1] != '\'')) break;
      if (text[at] == '\'') ++at;
      name += text[at];
    }
    path.push_back(std::move(name));
    ++at;
  }
  return path;
}

class IndexReader {
 public:
  explicit IndexReader(const FileBytes& bytes) : bytes_(bytes) {}

  TdmsIndex Read() {
    for (std::uint64_t at = 0; at < bytes_.size();) at = ReadSegment(at);
    return std::move(index_);
  }

 private:
  /// Where the next one begins.
  std::uint64_t ReadSegment(std::uint64_t at) {
    const std::string lead = bytes_.Read(at, kLeadIn, "the lead-in of a segment");
    if (at == 0 && lead.starts_with("TDSh")) throw RecordingFault(kTdmsIndex);
    if (!lead.starts_with("TDSm")) throw RecordingFault(kTdmsSegment, {std::to_string(at)});
    const auto mask = NumberAt<std::uint32_t>(lead.data() + 4, false);
    const bool is_big_endian = (mask & kBigEndian) != 0;
    const auto next = NumberAt<std::uint64_t>(lead.data() + 12, is_big_endian);
    const auto raw = NumberAt<std::uint64_t>(lead.data() + 20, is_big_endian);
    const std::uint64_t rest = bytes_.size() - at - kLeadIn;
    // What was being written when the recording program ended has no length.
    const std::uint64_t length = next == kNotWritten ? rest : next;
    if (raw > length || raw > rest)
      throw RecordingFault(kTdmsLead, {std::to_string(at), std::to_string(raw), std::to_string(length)});
    if ((mask & kMetaData) != 0) ReadMetaData(at, raw, is_big_endian, (mask & kNewObjects) != 0);
    if ((mask & kRawData) != 0) AddData(at, raw, std::min(length, rest), (mask & kInterleaved) != 0);
    if (length > rest) index_.cut_at.push_back(at);
    return at + kLeadIn + std::min(length, rest);
  }

  void ReadMetaData(std::uint64_t segment, std::uint64_t size, bool is_big_endian, bool is_new_list) {
    const std::string text = bytes_.Read(segment + kLeadIn, size, "the properties of a segment");
    MetaData data(text, segment + kLeadIn, is_big_endian);
    if (is_new_list) layout_.clear();
    for (auto count = data.Take<std::uint32_t>(); count > 0; --count) ReadObject(data, segment);
  }

  void ReadObject(MetaData& data, std::uint64_t segment) {
    const std::string path = data.TakeText();
    const auto [place, is_new] = place_of_.emplace(path, index_.objects.size());
    if (is_new) index_.objects.push_back({.path = PathOf(path)});
    const std::size_t object = place->second;
    const auto index = data.Take<std::uint32_t>();
    if (index == kFormatChanging || index == kDigitalLine)
      throw RecordingFault(kTdmsDaqmx, {path, std::to_string(segment)});
    if (index == kSameAsBefore) SetLayout(LastOf(object, data));
    else if (index == kNoData) RemoveLayout(object);
    else SetLayout(TakeLayout(data, object));
    for (auto count = data.Take<std::uint32_t>(); count > 0; --count) {
      std::string name = data.TakeText();
      index_.objects[object].properties.insert_or_assign(std::move(name), data.TakeProperty());
    }
  }

  TdmsLayout TakeLayout(MetaData& data, std::size_t object) {
    const std::uint64_t at = data.at();
    const auto type = data.Take<std::uint32_t>();
    const auto dimension = data.Take<std::uint32_t>();
    TdmsLayout layout = LayoutOf(type, data.is_big_endian());
    layout.object = object;
    layout.count = data.Take<std::uint64_t>();
    const std::uint64_t size = SizeOf(type);
    if (dimension != 1 || (size == 0 && type != kText) || layout.count > bytes_.size())
      throw RecordingFault(kTdmsObject, {"an object has " + std::to_string(layout.count) + " values of type " +
                                             std::to_string(type) + " and dimension " + std::to_string(dimension),
                                         std::to_string(at)});
    layout.bytes = type == kText ? data.Take<std::uint64_t>() : layout.count * size;
    if (layout.bytes > bytes_.size())
      throw RecordingFault(kTdmsObject, {"an object has more bytes than the file", std::to_string(at)});
    last_[object] = layout;
    return layout;
  }

  TdmsLayout LastOf(std::size_t object, const MetaData& data) {
    const auto found = last_.find(object);
    if (found == last_.end())
      throw RecordingFault(kTdmsObject, {"an object continues without a beginning", std::to_string(data.at())});
    TdmsLayout layout = found->second;
    layout.stored.is_big_endian = data.is_big_endian();
    return layout;
  }

  void SetLayout(const TdmsLayout& layout) {
    const auto found = Place(layout.object);
    if (found == layout_.end()) layout_.push_back(layout);
    else *found = layout;
  }

  void RemoveLayout(std::size_t object) {
    if (const auto found = Place(object); found != layout_.end()) layout_.erase(found);
  }

  std::vector<TdmsLayout>::iterator Place(std::size_t object) {
    return std::find_if(layout_.begin(), layout_.end(),
                        [&](const TdmsLayout& other) { return other.object == object; });
  }

  void AddData(std::uint64_t at, std::uint64_t raw, std::uint64_t length, bool is_interleaved) {
    TdmsSegment segment = {.data_at = at + kLeadIn + raw, .is_interleaved = is_interleaved, .layout = layout_};
    for (const TdmsLayout& layout : layout_) {
      segment.chunk_bytes += layout.bytes;
      // Row by row as long as all have a value.
      if (is_interleaved && layout.count != layout_.front().count)
        throw RecordingFault(kTdmsObject, {"interleaved channels differ in length", std::to_string(at)});
      if (segment.chunk_bytes > 2 * bytes_.size())
        throw RecordingFault(kTdmsObject, {"objects have more bytes than the file", std::to_string(at)});
    }
    if (segment.chunk_bytes == 0) return;
    segment.chunks = (length - raw) / segment.chunk_bytes;
    if ((length - raw) % segment.chunk_bytes != 0) index_.cut_at.push_back(at);
    if (segment.chunks > 0) index_.segments.push_back(std::move(segment));
  }

  const FileBytes& bytes_;
  TdmsIndex index_;
  std::map<std::string, std::size_t> place_of_;
  /// Of the segment that is read.
  std::vector<TdmsLayout> layout_;
  std::map<std::size_t, TdmsLayout> last_;
};

}  // namespace

TdmsIndex ReadTdmsIndex(const FileBytes& bytes) { return IndexReader(bytes).Read(); }

}  // namespace fourpost
