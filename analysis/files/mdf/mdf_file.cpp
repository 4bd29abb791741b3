#include "analysis/files/mdf/mdf_file.h"

#include "analysis/files/mdf/findings.h"
#include "analysis/files/mdf/mdf_index.h"
#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/unique_names.h"

namespace fourpost {
namespace {

MdfIndex ReadMdf(const FileBytes& bytes) {
  const std::string head = bytes.Read(0, 64, "the head");
  if (head.starts_with("UnFinMF ")) throw RecordingFault(kMdfNotFinished);
  std::string version = head.substr(8, 8);
  version.resize(version.find_last_not_of(std::string_view(" \0", 2)) + 1);
  if (version.starts_with('4')) return ReadMdf4(bytes);
  if (version.starts_with('3')) return ReadMdf3(bytes);
  throw RecordingFault(kMdfVersion, {version});
}

class MdfFile : public RecordingFile {
 public:
  explicit MdfFile(const std::filesystem::path& file) : bytes_(file, "MDF"), index_(ReadMdf(bytes_)) {
    header_ = {.format = "MDF", .description = index_.description};
    for (std::size_t g = 0; g < index_.groups.size(); ++g)
      for (std::size_t s = 0; s < index_.groups[g].signals.size(); ++s) {
        const MdfGroup& group = index_.groups[g];
        header_.channels.push_back({.name = group.signals[s].name,
                                    .unit = group.signals[s].unit,
                                    .group = group.name,
                                    .samples = group.cycles,
                                    .clock = group.times ? std::optional(g) : std::nullopt});
        signals_.push_back({g, s});
      }
    std::string left_out;
    for (const std::string& name : index_.left_out) left_out += (left_out.empty() ? "" : ", ") + name;
    if (!left_out.empty()) remarks_.push_back({&kChannelsLeftOut, {left_out}});
    if (header_.channels.empty()) throw RecordingFault(kRecordingNoChannel, {"MDF"});
    MakeNamesUnique(header_);
  }

  std::vector<double> Values(std::size_t channel) const override {
    const auto& [group, signal] = signals_[channel];
    return ReadSignal(bytes_, index_.groups[group], index_.groups[group].signals[signal]);
  }

 protected:
  std::vector<double> ClockTimes(std::size_t channel) const override {
    const MdfGroup& group = index_.groups[signals_[channel].first];
    return ReadSignal(bytes_, group, *group.times);
  }

 private:
  FileBytes bytes_;
  MdfIndex index_;
  /// Group and signal of each channel.
  std::vector<std::pair<std::size_t, std::size_t>> signals_;
};

}  // namespace

std::unique_ptr<RecordingFile> OpenMdf(const std::filesystem::path& file) { return std::make_unique<MdfFile>(file); }

bool IsMdf(std::string_view head) { return head.starts_with("MDF     ") || head.starts_with("UnFinMF "); }

}  // namespace fourpost
