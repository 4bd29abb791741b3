#include "identify/experiments/four_post/misfit_table.h"

#include <algorithm>
#include <optional>

#include "analysis/text/text_table.h"
#include "identify/residuals/history_table.h"

namespace fourpost {
namespace {

void Add(const std::string& name, const ChannelMisfit& misfit, TextTable& table) {
  table.Add({name, Rounded(misfit.rms_dB, 3), Rounded(misfit.rms_deg, 3), Rounded(misfit.nmse_percent, 3)});
}

std::string Percent(const std::optional<double>& percent) { return percent ? Rounded(*percent, 3) : "-"; }

const char* YardstickWords(bool has_linear) {
  return has_linear ? "Without physics: the best linear model, which is one response for all recordings of a pattern, "
                      "and the scatter\nthat their standard deviations state. NMSE above the least of these is the "
                      "model's: a better one exists.\nBelow it, the data may allow no more.\n"
                    : "Without physics: the scatter that the standard deviations of the recordings state. NMSE above "
                      "it is the model's;\nbelow it, the data may allow no more.\n";
}

/// Empty without any.
std::string YardstickTable(const std::vector<ChannelMisfit>& misfits, const std::string& above) {
  if (std::none_of(misfits.begin(), misfits.end(), [](const auto& misfit) { return misfit.Allowed_percent(); }))
    return "";
  // Of a single recording per pattern the best linear model is the recording.
  const bool has_linear = std::any_of(misfits.begin(), misfits.end(),
                                      [](const ChannelMisfit& misfit) { return misfit.linear_percent.has_value(); });
  std::vector<std::string> head = {"channel", "NMSE, %", "scatter, %", "of the model, %"};
  if (has_linear) head.insert(head.begin() + 2, "linear model, %");
  TextTable table(head);
  for (const ChannelMisfit& misfit : misfits) {
    const std::optional<double> allowed = misfit.Allowed_percent();
    std::vector<std::string> row = {misfit.name, Rounded(misfit.nmse_percent, 3), Percent(misfit.scatter_percent),
                                    allowed ? Rounded(std::max(0.0, misfit.nmse_percent - *allowed), 3) : "-"};
    if (has_linear) row.insert(row.begin() + 2, Percent(misfit.linear_percent));
    table.Add(row);
  }
  return '\n' + OnceExplained(YardstickWords(has_linear), above) + table.Format();
}

}  // namespace

std::string MisfitTable(const std::vector<ChannelMisfit>& misfits, const std::vector<ChannelMisfit>& recordings,
                        const std::string& above) {
  TextTable table({"channel", "rms dB", "rms deg", "NMSE, %"});
  for (const ChannelMisfit& misfit : misfits) Add(misfit.name, misfit, table);
  Add("all", GroupMisfit(misfits, ""), table);
  const std::string yardsticks = YardstickTable(misfits, above);
  if (recordings.size() < 2) return table.Format() + yardsticks;
  TextTable by_recording({"recording", "rms dB", "rms deg", "NMSE, %"});
  for (const ChannelMisfit& misfit : recordings) Add(misfit.name, misfit, by_recording);
  return table.Format() + '\n' + by_recording.Format() + yardsticks;
}

}  // namespace fourpost
