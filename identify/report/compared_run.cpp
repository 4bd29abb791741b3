#include "identify/report/compared_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "analysis/text/diagnostics.h"
#include "identify/report/fitted_data.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

std::map<ChannelGroup, double> MeanErrors(const std::vector<Json>& channels) {
  std::map<ChannelGroup, std::pair<double, int>> sums;
  for (const Json& channel : channels) {
    const double error = NumberAt(channel, "nmse_percent");
    if (!std::isfinite(error)) continue;
    auto& [sum, count] = sums[{TextAt(channel, "recording"), GroupOf(TextAt(channel, "name"))}];
    sum += error;
    ++count;
  }
  std::map<ChannelGroup, double> means;
  for (const auto& [group, tally] : sums) means[group] = tally.first / tally.second;
  return means;
}

/// `data`: one per run.
void NumberData(const std::vector<Json>& data, std::vector<ComparedRun>& runs) {
  std::vector<Json> known;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto found = std::find(known.begin(), known.end(), data[i]);
    runs[i].data = static_cast<std::size_t>(found - known.begin());
    if (found == known.end()) known.push_back(data[i]);
  }
}

std::string StudyOf(const ComparedRun& run) {
  const std::string stem = std::filesystem::path(TextAt(run.result, "study")).stem().string();
  return stem.empty() ? TextAt(run.result, "vehicle") : stem;
}

/// The last part of its path where it tells the runs apart, else all of it.
std::string FolderName(const ComparedRun& run, const std::vector<ComparedRun>& runs) {
  const auto last = [](const ComparedRun& one) {
    const std::filesystem::path folder = std::filesystem::path(one.folder).lexically_normal();
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  };
  const auto alike = std::count_if(runs.begin(), runs.end(), [&](const auto& one) { return last(one) == last(run); });
  return alike > 1 || last(run).empty() ? run.folder : last(run);
}

/// Every run by a name of its own.
void NameRuns(std::vector<ComparedRun>& runs) {
  std::map<std::string, int> studies;
  for (const ComparedRun& run : runs) ++studies[StudyOf(run)];
  std::set<std::string> taken;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string study = StudyOf(runs[i]);
    std::string name = studies[study] == 1 ? study : study + " (" + FolderName(runs[i], runs) + ")";
    if (!taken.insert(name).second) taken.insert(name += " " + std::to_string(i + 1));
    runs[i].name = name;
  }
}

std::string Joined(const auto& texts) {
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : ", ") + text;
  return joined;
}

/// Also what decides whether its cost can be compared.
ComparedRun RunOf(const std::string& folder, RunContents contents, ExperimentReports experiments, Json& data) {
  ComparedRun run{.folder = folder, .contents = std::move(contents)};
  try {
    run.result = FitResultOf(run.contents);
    run.parameters = ReportedParameters(run.result, run.contents);
    run.fitted = MeanErrors(ListAt(run.result, "channels"));
    run.predicted = MeanErrors(ListAt(run.result, "validation"));
    std::vector<std::string> kinds;
    for (const ExperimentReport* experiment : experiments) {
      run.recordings.merge(experiment->RecordingErrors(run.result));
      if (experiment->IsIn(run.Folder())) kinds.emplace_back(experiment->Name());
    }
    run.kind = Joined(kinds);
    data = FittedData(run.Folder(), experiments);
  } catch (const Json::exception& fault) {
    RefuseResult(run.FileNamed("result.json"), fault);
  }
  return run;
}

}  // namespace

std::string GroupOf(const std::string& channel) {
  constexpr std::array<const char*, 8> kPlaces = {"front", "rear", "left", "right", "FL", "FR", "RL", "RR"};
  const std::size_t mark = channel.rfind('_');
  if (mark == std::string::npos || mark == 0) return channel;
  return std::find(kPlaces.begin(), kPlaces.end(), channel.substr(mark + 1)) == kPlaces.end() ? channel
                                                                                              : channel.substr(0, mark);
}

std::string ComparedRun::Recordings() const { return Joined(FittedRecordings(result)); }

std::vector<ComparedRun> ComparedRuns(std::vector<std::pair<std::string, RunContents>> folders,
                                      ExperimentReports experiments) {
  std::vector<ComparedRun> runs;
  std::vector<Json> data;
  for (auto& [folder, contents] : folders)
    runs.push_back(RunOf(folder, std::move(contents), experiments, data.emplace_back()));
  NameRuns(runs);
  NumberData(data, runs);
  return runs;
}

std::vector<ChannelGroup> CommonGroups(const std::vector<ComparedRun>& runs,
                                       std::map<ChannelGroup, double> ComparedRun::*errors) {
  std::vector<ChannelGroup> common;
  if (runs.empty()) return common;
  for (const auto& entry : runs.front().*errors) {
    const ChannelGroup& group = entry.first;
    if (std::all_of(runs.begin(), runs.end(), [&](const ComparedRun& run) { return (run.*errors).contains(group); }))
      common.push_back(group);
  }
  return common;
}

}  // namespace fourpost
