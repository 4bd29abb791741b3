#include "identify/experiments/four_post/response_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/files/csv.h"
#include "identify/experiments/findings.h"

namespace fourpost {
namespace {

using Column = std::vector<double> ComparedChannel::*;

constexpr std::array<std::pair<const char*, Column>, 16> kColumns = {{
    {"frequency_Hz", &ComparedChannel::frequency_Hz},
    {"post_amplitude_m", &ComparedChannel::post_amplitude_m},
    {"gain_measured", &ComparedChannel::gain_measured},
    {"gain_modelled", &ComparedChannel::gain_modelled},
    {"phase_measured_deg", &ComparedChannel::phase_measured_deg},
    {"phase_modelled_deg", &ComparedChannel::phase_modelled_deg},
    {"gain_sd", &ComparedChannel::gain_sd},
    {"phase_sd_deg", &ComparedChannel::phase_sd_deg},
    {"gain_start", &ComparedChannel::gain_start},
    {"phase_start_deg", &ComparedChannel::phase_start_deg},
    {"gain_half_95_parameters", &ComparedChannel::gain_band},
    {"gain_half_95_measured", &ComparedChannel::gain_band_measured},
    {"phase_half_95_parameters_deg", &ComparedChannel::phase_band_deg},
    {"phase_half_95_measured_deg", &ComparedChannel::phase_band_measured_deg},
    {"mean_measured", &ComparedChannel::mean_measured},
    {"mean_modelled", &ComparedChannel::mean_modelled},
}};
constexpr std::array<const char*, 7> kRequired = {"recording", "channel",       "unit",         "frequency_Hz",
                                                  "in_band",   "gain_measured", "gain_modelled"};

ComparedChannel& ChannelOf(const CsvTable& table, std::size_t row, std::vector<ComparedChannel>& channels) {
  const std::string& recording = table.Text(row, *table.FindColumn("recording"));
  const std::string& name = table.Text(row, *table.FindColumn("channel"));
  const auto is_it = [&](const ComparedChannel& channel) {
    return channel.recording == recording && channel.name == name;
  };
  // Rows of a channel stand together.
  const auto found = std::find_if(channels.rbegin(), channels.rend(), is_it);
  if (found != channels.rend()) return *found;
  channels.push_back({.recording = recording, .name = name, .unit = table.Text(row, *table.FindColumn("unit"))});
  return channels.back();
}

}  // namespace

std::vector<ComparedChannel> ReadResponseTable(const std::string& text, const std::string& file) {
  Diagnostics faults;
  const std::optional<CsvTable> table = ParseCsv(text, file, faults);
  if (!table) throw FaultyInput(faults);
  for (const char* name : kRequired)
    if (!table->FindColumn(name)) faults.Report(kFitColumnMissing, {file, 1}, {name});
  if (faults.HasErrors()) throw FaultyInput(faults);
  std::vector<ComparedChannel> channels;
  const std::size_t in_band = *table->FindColumn("in_band");
  for (std::size_t row = 0; row < table->rows(); ++row) {
    ComparedChannel& channel = ChannelOf(*table, row, channels);
    channel.in_band.push_back(table->Number(row, in_band).value_or(0) > 0.5);
    for (const auto& [name, member] : kColumns) {
      const std::optional<std::size_t> column = table->FindColumn(name);
      if (column) (channel.*member).push_back(table->Number(row, *column).value_or(NAN));
    }
  }
  return channels;
}

}  // namespace fourpost
