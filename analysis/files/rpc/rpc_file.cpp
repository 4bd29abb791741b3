#include "analysis/files/rpc/rpc_file.h"

#include <algorithm>
#include <utility>

#include "analysis/files/recording/file_bytes.h"
#include "analysis/files/recording/file_lines.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/stored_number.h"
#include "analysis/files/recording/unique_names.h"
#include "analysis/files/rpc/findings.h"
#include "analysis/files/rpc/rpc_header.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

class RpcFile : public RecordingFile {
 public:
  explicit RpcFile(const std::filesystem::path& file) : bytes_(file, "RPC III") {
    const RpcHeader header(bytes_);
    RequireTime(header);
    ReadFormat(header);
    ReadLayout(header);
    ReadChannels(header);
    if (is_ascii_) ReadAscii();
  }

  std::vector<double> Values(std::size_t channel) const override {
    std::vector<double> values;
    values.reserve(samples_);
    // Stored ones, of which the first `skipped_` are a half frame.
    for (std::uint64_t from = 0; from < skipped_ + samples_; from += group_) {
      const std::uint64_t count = std::min(group_, skipped_ + samples_ - from);
      const std::uint64_t skipped = std::min(count, from < skipped_ ? skipped_ - from : 0);
      Append((from / group_ * header_.channels.size() + channel) * group_ + skipped, count - skipped, values);
    }
    for (double& value : values) value *= factors_[channel];
    return values;
  }

 private:
  static void RequireTime(const RpcHeader& header) {
    const auto refuse = [&](const std::string& key, const std::string& value) {
      throw RecordingFault(kRpcNotTime, {header.RecordOf(key), key, value});
    };
    const std::string type = header.Text("FILE_TYPE");
    if (!type.empty() && type != "TIME_HISTORY") refuse("FILE_TYPE", type);
    const std::string kind = header.Text("TIME_TYPE");
    for (const char* other :
         {"3", "4", "5", "6", "7", "MULT_DRIVE", "MULT_RESP", "CONFIG_DRIVE", "CONFIG_RESP", "PEAK_PICK"})
      if (kind == other) refuse("TIME_TYPE", kind);
  }

  void ReadFormat(const RpcHeader& header) {
    const std::string format = header.RequiredText("FORMAT");
    is_ascii_ = format == "ASCII";
    stored_.is_big_endian = format == "BINARY_IEEE_BIG_END";
    if (!is_ascii_ && !stored_.is_big_endian && format != "BINARY_IEEE_LITTLE_END" && format != "BINARY")
      throw RecordingFault(kRpcFormat, {header.RecordOf("FORMAT"), "FORMAT", format});
    const std::string type = header.Text("DATA_TYPE");
    if (type == "FLOATING_POINT")
      stored_ = {StoredNumber::Kind::kFloat, is_ascii_ ? std::size_t{2} : std::size_t{4}, stored_.is_big_endian};
    else if (!type.empty() && type != "SHORT_INTEGER")
      throw RecordingFault(kRpcFormat, {header.RecordOf("DATA_TYPE"), "DATA_TYPE", type});
  }

  void ReadLayout(const RpcHeader& header) {
    data_at_ = header.size();
    const std::uint64_t frame = header.Whole("PTS_PER_FRAME", 1);
    const std::uint64_t frames = header.Whole("FRAMES", 1);
    group_ = header.Whole("PTS_PER_GROUP", 1, frame);
    channels_ = header.Whole("CHANNELS", 1);
    samples_ = frame * frames;
    if (header.Whole("HALF_FRAMES", 0, 0) != 0) skipped_ = frame / 2;
    // Half a frame before the data and half a frame behind it.
    const std::uint64_t groups = (samples_ + 2 * skipped_ + group_ - 1) / group_;
    // A number in ASCII takes a digit and a blank.
    const std::uint64_t size = stored_.size;
    // No product of these is beyond 2^64 where the file is as long as it.
    const std::uint64_t most = bytes_.size() / size + 1;
    const bool is_beyond = groups > most || group_ * groups > most || channels_ > most ||
                           static_cast<double>(group_ * groups) * static_cast<double>(channels_) > 1e18;
    bytes_.Require(data_at_, is_beyond ? ~std::uint64_t{0} : group_ * groups * channels_ * size - (is_ascii_ ? 1 : 0),
                   "the data");
  }

  void ReadChannels(const RpcHeader& header) {
    header_.format = "RPC III";
    for (const char* key : {"OPERATION", "DATE"})
      if (const std::string text = header.Text(key); !text.empty())
        header_.description += (header_.description.empty() ? "" : "\n") + text;
    const double step = header.Number("DELTA_T");
    if (!(step > 0))
      throw RecordingFault(kRpcValue, {header.RecordOf("DELTA_T"), "DELTA_T", header.Text("DELTA_T"), "above zero"});
    for (std::uint64_t i = 1; i <= channels_; ++i) {
      const std::string ending = ".CHAN_" + std::to_string(i);
      const bool is_float = stored_.kind == StoredNumber::Kind::kFloat;
      // A file without DESC may have as many channels as its header says, but each needs a SCALE.
      factors_.push_back(is_float ? 1 : header.Number("SCALE" + ending));
      header_.channels.push_back({.name = header.Text("DESC" + ending),
                                  .unit = header.Text("UNITS" + ending),
                                  .samples = samples_,
                                  .step_s = step,
                                  .count = is_float ? 0 : factors_.back()});
    }
    MakeNamesUnique(header_);
  }

  /// Numbers in the order of the binary ones, with blanks between them.
  void ReadAscii() {
    FileLines lines(bytes_, data_at_);
    constexpr std::string_view kBlanks = " \t,";
    for (std::string_view line; lines.Next(line);)
      for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        const std::optional<double> number = ParseNumber(line.substr(at, end - at));
        // What fills up the last block.
        if (!number) break;
        ascii_.push_back(*number);
        at = line.find_first_not_of(kBlanks, end);
      }
    const double needed = static_cast<double>((samples_ + 2 * skipped_ + group_ - 1) / group_) *
                          static_cast<double>(group_) * static_cast<double>(channels_);
    if (static_cast<double>(ascii_.size()) < needed)
      throw RecordingFault(kRpcAscii, {std::to_string(ascii_.size()), FormatNumber(needed)});
  }

  /// From the `first` one of the data on.
  void Append(std::uint64_t first, std::uint64_t count, std::vector<double>& values) const {
    if (is_ascii_) {
      const auto begin = ascii_.begin() + static_cast<std::ptrdiff_t>(first);
      values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    } else {
      const std::string data = bytes_.Read(data_at_ + first * stored_.size, count * stored_.size, "a group");
      AppendNumbers(data, stored_, count, stored_.size, values);
    }
  }

  FileBytes bytes_;
  StoredNumber stored_;
  bool is_ascii_ = false;
  std::vector<double> ascii_;
  std::uint64_t data_at_ = 0;
  std::uint64_t channels_ = 0;
  /// Numbers of a channel that stand together.
  std::uint64_t group_ = 1;
  std::uint64_t samples_ = 0;
  std::uint64_t skipped_ = 0;
  std::vector<double> factors_;
};

}  // namespace

std::unique_ptr<RecordingFile> OpenRpc(const std::filesystem::path& file) { return std::make_unique<RpcFile>(file); }

}  // namespace fourpost
