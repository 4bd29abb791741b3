#include "analysis/files/hdf5/hdf5_file.h"

#include <algorithm>
#include <utility>

#include "analysis/files/hdf5/hdf5_dataset.h"
#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/unique_names.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

/// "run" and "force" of "/run/force".
std::pair<std::string, std::string> SplitPath(const std::string& path) {
  const std::size_t at = path.rfind('/');
  return {at == 0 ? "" : path.substr(1, at - 1), path.substr(at + 1)};
}

bool IsTime(const Hdf5Dataset& dataset) {
  const std::string name = SplitPath(dataset.path).second;
  return dataset.columns == 1 && (name == "time" || name == "Time" || name == "t" || name == "TIME");
}

class Hdf5File : public RecordingFile {
 public:
  explicit Hdf5File(std::filesystem::path file) : file_(std::move(file)), contents_(ListHdf5(file_)) {
    header_ = {.format = "HDF5", .description = contents_.description};
    for (std::size_t d = 0; d < contents_.datasets.size(); ++d)
      if (!IsTime(contents_.datasets[d])) AddChannels(d);
    std::string left_out;
    for (const std::string& path : contents_.left_out) left_out += (left_out.empty() ? "" : ", ") + path;
    if (!left_out.empty()) remarks_.push_back({&kChannelsLeftOut, {left_out}});
    if (header_.channels.empty()) throw RecordingFault(kRecordingNoChannel, {"HDF5"});
    MakeNamesUnique(header_);
  }

  std::vector<double> Values(std::size_t channel) const override {
    return ReadHdf5(file_, contents_.datasets[places_[channel].first], places_[channel].second);
  }

 protected:
  std::vector<double> ClockTimes(std::size_t channel) const override {
    const Hdf5Dataset& dataset = contents_.datasets[*header_.channels[channel].clock];
    std::vector<double> times = ReadHdf5(file_, dataset, 0);
    const std::optional<Unit> unit = dataset.units.empty() ? std::nullopt : ParseUnit(dataset.units.front());
    for (double& time : times) time *= unit && unit->dimension == kTime ? unit->si : 1;
    return times;
  }

 private:
  void AddChannels(std::size_t d) {
    const Hdf5Dataset& dataset = contents_.datasets[d];
    const auto [group, name] = SplitPath(dataset.path);
    for (std::uint64_t column = 0; column < dataset.columns; ++column) {
      RecordingChannel channel = {.name = name, .unit = "", .group = group, .samples = dataset.rows};
      if (dataset.names.size() == dataset.columns) channel.name = dataset.names[column];
      else if (dataset.columns > 1) channel.name += " " + std::to_string(column + 1);
      if (dataset.units.size() == dataset.columns) channel.unit = dataset.units[column];
      else if (dataset.units.size() == 1) channel.unit = dataset.units.front();
      channel.step_s = std::max(dataset.step_s, 0.0);
      channel.start_s = dataset.start_s;
      if (!(channel.step_s > 0)) channel.clock = TimeOf(group, dataset.rows);
      header_.channels.push_back(std::move(channel));
      places_.emplace_back(d, column);
    }
  }

  std::optional<std::size_t> TimeOf(const std::string& group, std::uint64_t rows) const {
    for (std::size_t d = 0; d < contents_.datasets.size(); ++d) {
      const Hdf5Dataset& other = contents_.datasets[d];
      if (IsTime(other) && other.rows == rows && SplitPath(other.path).first == group) return d;
    }
    return std::nullopt;
  }

  std::filesystem::path file_;
  Hdf5Contents contents_;
  /// Dataset and column of each channel.
  std::vector<std::pair<std::size_t, std::uint64_t>> places_;
};

}  // namespace

std::unique_ptr<RecordingFile> OpenHdf5(const std::filesystem::path& file) { return std::make_unique<Hdf5File>(file); }

bool IsHdf5(std::string_view head) { return head.starts_with("\x89HDF\r\n\x1A\n"); }

bool IsOfMatlab(const std::filesystem::path& file) { return ListHdf5(file).is_of_matlab; }

}  // namespace fourpost
