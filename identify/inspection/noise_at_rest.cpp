#include "identify/inspection/noise_at_rest.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "identify/draft/drafted_preparation.h"
#include "identify/experiments/time_history/time_histories.h"

namespace fourpost {
namespace {

/// Those of all files of a history.
DraftedPreparation SummaryOf(const StudyHistory& history) {
  std::vector<std::filesystem::path> files = {history.file};
  for (const OtherFile& other : history.preparation.others) files.push_back(other.path);
  DraftedPreparation all;
  for (const std::filesystem::path& file : files) {
    Diagnostics unheard;
    const std::optional<RecordedTable> table = ReadRecordedTable(file, unheard);
    if (!table) continue;
    DraftedPreparation one = PreparationOf(*table);
    if (!all.summary.rest) all.summary.rest = one.summary.rest;
    for (ColumnSummary& column : one.summary.columns)
      if (all.Find(column.name) == nullptr) all.summary.columns.push_back(std::move(column));
  }
  return all;
}

}  // namespace

std::string NoiseAtRestText(const LoadedStudy& study) {
  const auto* histories = study.study.experiments.Find<TimeHistories>();
  std::string text;
  if (histories == nullptr) return text;
  for (StudyHistory history : histories->plan.histories) {
    if (!history.noise.empty()) continue;
    MapByName(study.vehicle, history);
    std::vector<ChannelMatch> matches;
    for (const auto& [sensor, source] : history.channels)
      matches.push_back({.name = sensor, .source = source, .correlation = {}, .rival = {}});
    const std::string lines = NoiseLines(SummaryOf(history), matches);
    if (!lines.empty()) text += "to state for '" + history.name + "' under 'histories':\n" + lines;
  }
  return text;
}

}  // namespace fourpost
