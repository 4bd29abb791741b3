#include "identify/report/simulation_page.h"

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/experiments/run_history.h"
#include "identify/report/sentences_html.h"
#include "identify/report/vehicle_page.h"
#include "vehicles/requests/engine_text.h"

namespace fourpost {
namespace {

using html::NumberCell;
using html::TextCell;

std::string SizesHtml(const std::vector<HistoryChannel>& channels) {
  std::vector<std::vector<html::Cell>> rows;
  for (const HistoryChannel& channel : channels) {
    const Extent extent = ExtentOf(channel.values);
    const bool is_length = channel.unit == "m";
    rows.push_back({{html::Code(channel.name), ""}, TextCell(is_length ? "mm" : ShownUnit(channel.unit))});
    for (const double size : {extent.mean, extent.rms, extent.peak, extent.peak_to_peak})
      rows.back().push_back(NumberCell(ShownNumber((is_length ? 1e3 : 1) * size, 4)));
  }
  return html::Table({"channel", "unit", "mean", "rms", "peak", "peak to peak"}, rows);
}

TimeTable TableOf(const SimulationAnswer& answer) {
  TimeTable table{.recording = answer.origin.motion,
                  .columns = {{"time", "s", {}}},
                  .rows = static_cast<std::size_t>(answer.channels.front().values.size())};
  for (std::size_t k = 0; k < table.rows; ++k)
    table.columns.front().values.push_back(answer.start_s + static_cast<double>(k) / answer.rate_Hz);
  for (const HistoryChannel& channel : answer.channels)
    table.columns.push_back({channel.name + "_modelled", channel.unit, {channel.values.begin(), channel.values.end()}});
  return table;
}

/// Seconds from its first sample to its last.
std::string Seconds(Eigen::Index samples, double rate_Hz) {
  return ShownShort(static_cast<double>(samples - 1) / rate_Hz, 4) + " s";
}

/// By what the moving vehicle differs from the histories below it.
std::string NoteOf(const SimulationAnswer& answer) {
  const bool is_full = answer.origin.by.engine == Engine::kFull;
  const Eigen::Index samples = answer.channels.front().values.size();
  const Eigen::Index frames = answer.motion.coordinates.rows();
  const bool is_part =
      static_cast<double>(frames) / answer.motion.rate_Hz < static_cast<double>(samples - 1) / answer.rate_Hz;
  return std::string("Drawn by the reduced model") +
         (is_full ? "; the numbers and charts of this page are of the full geometry" : "") +
         (is_part ? ". The first " + Seconds(frames, answer.motion.rate_Hz) + " of " +
                        Seconds(samples, answer.rate_Hz) + " are drawn"
                  : "") +
         ".";
}

}  // namespace

std::string SimulationPage(const Vehicle& vehicle, const SimulationAnswer& answer) {
  VehicleAnswer page{.facts = {"simulated", ShownUnit(answer.origin.motion)}, .file = "", .findings = answer.findings};
  page.before.push_back(
      {"summary", "Summary", SizesHtml(answer.channels) + SentencesHtml(EngineText(answer.origin.by))});
  if (answer.motion.coordinates.rows() > 1) {
    page.over_time = {{answer.origin.motion, answer.motion}};
    page.scene = {{"first", "history"}};
    page.viewer_note = NoteOf(answer);
  }
  page.after.push_back(
      {"histories", "Time histories", html::Drawn("histories", "The charts need JavaScript; history.csv has them.")});
  page.drawn["histories"] = nlohmann::ordered_json::array({RecordingJson(TableOf(answer))});
  return VehiclePage(vehicle, page);
}

}  // namespace fourpost
