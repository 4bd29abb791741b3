#include "analysis/files/rpc/rpc_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "analysis/files/rpc/rpc_header.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr std::size_t kGroup = 2048;
/// Of 16 bits; 16 less, as rigs have it.
constexpr double kFullScale = 32752;

void Require(const Recording& recording) {
  if (recording.channels.empty() || recording.channels.front().values.empty())
    throw std::invalid_argument("a recording to be written needs channels with values");
  const RecordingChannel& first = recording.channels.front();
  for (const RecordingChannel& channel : recording.channels) {
    if (channel.values.size() != first.values.size() || channel.step_s != first.step_s || !(channel.step_s > 0))
      throw std::invalid_argument("channel '" + channel.name + "' has another length or step than '" + first.name +
                                  "'");
    if (!std::all_of(channel.values.begin(), channel.values.end(), [](double v) { return std::isfinite(v); }))
      throw std::invalid_argument("channel '" + channel.name + "' has a value that is not finite");
  }
}

std::size_t FrameFor(std::size_t samples) {
  for (const std::size_t frame : {2048, 1024, 512})
    if (samples % frame == 0) return frame;
  return 256;
}

bool IsOfCounts(const std::vector<double>& values, double count) {
  return count > 0 && std::all_of(values.begin(), values.end(), [&](double value) {
           const double counts = std::round(value / count);
           return counts >= -32768 && counts <= 32767 && counts * count == value;
         });
}

/// By which the integers of a channel are to be multiplied.
double CountOf(const RecordingChannel& channel) {
  if (IsOfCounts(channel.values, channel.count)) return channel.count;
  double largest = 0;
  for (const double value : channel.values) largest = std::max(largest, std::abs(value));
  const double count = largest / kFullScale;
  return count > 0 ? count : 1;
}

class Header {
 public:
  void Add(std::string_view key, std::string_view value) {
    records_ += Field(key, kRpcKey);
    records_ += Field(value, kRpcRecord - kRpcKey);
  }
  void Add(std::string_view key, std::size_t value) { Add(key, std::to_string(value)); }

  /// With the two records that say how long it is behind the first, filled up to whole blocks.
  std::string Bytes() const {
    const std::size_t records = records_.size() / kRpcRecord + 2;
    const std::size_t blocks = (records * kRpcRecord + kRpcBlock - 1) / kRpcBlock;
    Header sizes;
    sizes.Add("NUM_HEADER_BLOCKS", blocks);
    sizes.Add("NUM_PARAMS", records);
    std::string all = records_;
    all.insert(kRpcRecord, sizes.records_);
    all.resize(blocks * kRpcBlock, '\0');
    return all;
  }

 private:
  /// Ends with a zero.
  static std::string Field(std::string_view text, std::size_t size) {
    std::string field(text.substr(0, size - 1));
    field.resize(size, '\0');
    return field;
  }

  std::string records_;
};

template <typename Number>
void AppendBytes(Number number, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Groups of all channels; what follows the last value is 0 in the last group.
template <typename Convert>
std::string DataOf(const Recording& recording, std::size_t stored, const Convert& convert) {
  std::string data;
  for (std::size_t from = 0; from < stored; from += kGroup)
    for (std::size_t c = 0; c < recording.channels.size(); ++c)
      for (std::size_t k = from; k < from + kGroup; ++k) {
        const std::vector<double>& values = recording.channels[c].values;
        AppendBytes(k < stored ? convert(values[std::min(k, values.size() - 1)], c) : convert(0, c), data);
      }
  return data;
}

}  // namespace

std::string RpcBytes(const Recording& recording, RpcNumbers numbers) {
  Require(recording);
  const RecordingChannel& first = recording.channels.front();
  const std::size_t samples = first.values.size();
  const std::size_t frame = FrameFor(samples);
  const std::size_t frames = (samples + frame - 1) / frame;
  const bool is_float = numbers == RpcNumbers::kFloat;
  Header header;
  header.Add("FORMAT", "BINARY_IEEE_LITTLE_END");
  header.Add("FILE_TYPE", "TIME_HISTORY");
  header.Add("DATA_TYPE", is_float ? "FLOATING_POINT" : "SHORT_INTEGER");
  header.Add("TIME_TYPE", "DRIVE");
  header.Add("DELTA_T", FormatNumber(first.step_s));
  header.Add("PTS_PER_FRAME", frame);
  header.Add("CHANNELS", recording.channels.size());
  header.Add("PTS_PER_GROUP", kGroup);
  header.Add("BYPASS_FILTER", "0");
  header.Add("HALF_FRAMES", "0");
  header.Add("REPEATS", "0");
  header.Add("FRAMES", frames);
  header.Add("INT_FULL_SCALE", "32752");
  header.Add("PARTITIONS", "1");
  header.Add("PART.CHAN_1", "1");
  header.Add("PART.NCHAN_1", recording.channels.size());
  header.Add("OPERATION", "fourpost");
  std::vector<double> counts;
  for (std::size_t i = 0; i < recording.channels.size(); ++i) {
    const RecordingChannel& channel = recording.channels[i];
    const std::string ending = ".CHAN_" + std::to_string(i + 1);
    counts.push_back(is_float ? 1 : CountOf(channel));
    header.Add("DESC" + ending, channel.name);
    header.Add("UNITS" + ending, channel.unit);
    header.Add("SCALE" + ending, FormatNumber(counts.back()));
    header.Add("UPPER_LIMIT" + ending, "1");
    header.Add("LOWER_LIMIT" + ending, "-1");
    header.Add("MAP" + ending, i + 1);
  }
  const auto as_float = [](double value, std::size_t) { return static_cast<float>(value); };
  const auto as_count = [&](double value, std::size_t c) {
    return static_cast<std::int16_t>(std::clamp(std::round(value / counts[c]), -32768.0, 32767.0));
  };
  return header.Bytes() +
         (is_float ? DataOf(recording, frames * frame, as_float) : DataOf(recording, frames * frame, as_count));
}

}  // namespace fourpost
