#include "analysis/files/tdms/tdms_file.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/recording/file_bytes.h"
#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/unique_names.h"
#include "analysis/files/tdms/findings.h"
#include "analysis/files/tdms/tdms_scaling.h"
#include "analysis/files/tdms/tdms_segment.h"

namespace fourpost {
namespace {

using Content = TdmsLayout::Content;

/// Seconds and, below them, fractions of 2^-64.
double SecondsOf(const char* stamp, bool is_big_endian, std::int64_t first) {
  const auto seconds = NumberAt<std::int64_t>(stamp + (is_big_endian ? 0 : 8), is_big_endian);
  const auto fraction = NumberAt<std::uint64_t>(stamp + (is_big_endian ? 8 : 0), is_big_endian);
  // Unsigned, since a damaged file may hold any.
  const auto since = static_cast<std::int64_t>(static_cast<std::uint64_t>(seconds) - static_cast<std::uint64_t>(first));
  return static_cast<double>(since) + std::ldexp(static_cast<double>(fraction), -64);
}

class TdmsFile : public RecordingFile {
 public:
  explicit TdmsFile(const std::filesystem::path& file) : bytes_(file, "TDMS"), index_(ReadTdmsIndex(bytes_)) {
    header_.format = "TDMS";
    CountSamples();
    std::string left_out;
    std::string not_scaled;
    for (std::size_t i = 0; i < index_.objects.size(); ++i) {
      const TdmsObject& object = index_.objects[i];
      if (object.path.empty()) header_.description = DescriptionOf(object.properties);
      if (object.path.size() != 2 || samples_[i] == 0) continue;
      const auto add = [&](std::string& list) { list += (list.empty() ? "" : ", ") + object.path[1]; };
      std::optional<TdmsScaling> scaling = TdmsScaling::Of(object.properties);
      if (contents_[i] == Content::kOther) add(left_out);
      else if (!scaling) add(not_scaled);
      else AddChannel(i, *std::move(scaling));
    }
    if (!left_out.empty()) remarks_.push_back({&kChannelsLeftOut, {left_out}});
    if (!not_scaled.empty()) remarks_.push_back({&kTdmsScale, {not_scaled}});
    for (const std::uint64_t at : index_.cut_at) remarks_.push_back({&kTdmsCut, {std::to_string(at)}});
    if (header_.channels.empty()) throw RecordingFault(kRecordingNoChannel, {"TDMS"});
    MakeNamesUnique(header_);
  }

  std::vector<double> Values(std::size_t channel) const override {
    const std::size_t object = objects_[channel];
    std::vector<double> values;
    values.reserve(samples_[object]);
    std::optional<std::int64_t> first_second;
    for (const TdmsSegment& segment : index_.segments) AppendSegment(segment, object, first_second, values);
    scalings_[channel].Apply(values);
    return values;
  }

 private:
  static std::string DescriptionOf(const TdmsProperties& properties) {
    std::string text;
    for (const char* name : {"name", "description", "author"})
      if (const std::string line = TextOf(properties, name); !line.empty()) text += (text.empty() ? "" : "\n") + line;
    return text;
  }

  void CountSamples() {
    samples_.resize(index_.objects.size());
    contents_.resize(index_.objects.size(), Content::kNumbers);
    for (const TdmsSegment& segment : index_.segments)
      for (const TdmsLayout& layout : segment.layout) {
        samples_[layout.object] += segment.chunks * layout.count;
        if (layout.content != Content::kNumbers) contents_[layout.object] = layout.content;
      }
  }

  void AddChannel(std::size_t object, TdmsScaling scaling) {
    const TdmsProperties& properties = index_.objects[object].properties;
    RecordingChannel channel = {.name = index_.objects[object].path[1],
                                .unit = TextOf(properties, "unit_string"),
                                .group = index_.objects[object].path[0],
                                .samples = samples_[object]};
    if (channel.unit.empty()) channel.unit = TextOf(properties, "NI_UnitDescription");
    if (contents_[object] == Content::kTimeStamps) channel.unit = "s";
    const double step = NumberOf(properties, "wf_increment");
    if (step > 0 && std::isfinite(step) && contents_[object] == Content::kNumbers) {
      channel.step_s = step;
      channel.start_s = NumberOf(properties, "wf_start_offset");
    }
    header_.channels.push_back(std::move(channel));
    objects_.push_back(object);
    scalings_.push_back(std::move(scaling));
  }

  /// What an object has in all chunks of a segment.
  void AppendSegment(const TdmsSegment& segment, std::size_t object, std::optional<std::int64_t>& first_second,
                     std::vector<double>& values) const {
    std::uint64_t before = 0;
    std::uint64_t width = 0;
    const TdmsLayout* found = nullptr;
    for (const TdmsLayout& layout : segment.layout) {
      const std::uint64_t bytes = segment.is_interleaved ? layout.stored.size : layout.bytes;
      if (layout.object == object) found = &layout;
      if (found == nullptr) before += bytes;
      width += bytes;
    }
    if (found == nullptr || found->count == 0) return;
    const std::uint64_t size = found->stored.size;
    const std::uint64_t stride = segment.is_interleaved ? width : size;
    const std::uint64_t span = (found->count - 1) * stride + size;
    // Small chunks are read several at once.
    const std::uint64_t together = std::max<std::uint64_t>(1, (std::uint64_t{1} << 20) / segment.chunk_bytes);
    for (std::uint64_t chunk = 0; chunk < segment.chunks; chunk += together) {
      const std::uint64_t last = std::min(together, segment.chunks - chunk) - 1;
      const std::uint64_t at = segment.data_at + chunk * segment.chunk_bytes + before;
      const std::string data = bytes_.Read(at, last * segment.chunk_bytes + span, "the data of a segment");
      for (std::uint64_t i = 0; i <= last; ++i)
        AppendChunk(std::string_view(data).substr(i * segment.chunk_bytes), *found, stride, first_second, values);
    }
  }

  static void AppendChunk(std::string_view data, const TdmsLayout& layout, std::uint64_t stride,
                          std::optional<std::int64_t>& first_second, std::vector<double>& values) {
    if (layout.content == Content::kNumbers) return AppendNumbers(data, layout.stored, layout.count, stride, values);
    const bool big = layout.stored.is_big_endian;
    for (std::uint64_t i = 0; i < layout.count; ++i) {
      const char* stamp = data.data() + i * stride;
      if (!first_second) first_second = NumberAt<std::int64_t>(stamp + (big ? 0 : 8), big);
      values.push_back(SecondsOf(stamp, big, *first_second));
    }
  }

  FileBytes bytes_;
  TdmsIndex index_;
  /// By object.
  std::vector<std::uint64_t> samples_;
  std::vector<Content> contents_;
  /// By channel.
  std::vector<std::size_t> objects_;
  std::vector<TdmsScaling> scalings_;
};

}  // namespace

std::unique_ptr<RecordingFile> OpenTdms(const std::filesystem::path& file) { return std::make_unique<TdmsFile>(file); }

bool IsTdms(std::string_view head) { return head.starts_with("TDSm") || head.starts_with("TDSh"); }

}  // namespace fourpost
