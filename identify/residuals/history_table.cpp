#include "identify/residuals/history_table.h"

#include <algorithm>
#include <optional>

#include "analysis/text/text_table.h"

namespace fourpost {

namespace {

/// Empty without predictions.
std::string OneStepTable(const std::vector<HistoryMisfit>& misfits) {
  TextTable table({"recording", "channel", "simulated, %", "one step ahead, %", "innovations' correlation",
                   "beyond white noise's"});
  for (const HistoryMisfit& misfit : misfits) {
    if (!misfit.one_step_nmse_percent) return "";
    table.Add({misfit.recording, misfit.name, Rounded(misfit.nmse_percent, 3),
               Rounded(*misfit.one_step_nmse_percent, 3), Rounded(*misfit.innovation_correlation, 2),
               Rounded(100 * *misfit.innovations_beyond, 2) + " %"});
  }
  return "\nKalman filter as predictor. It is corrected by each sample before it predicts the next, so that a channel "
         "that it\n"
         "trusts has a far smaller error than in a simulation, whatever the model is worth: the two do not compare.\n"
         "White innovations have no correlation from sample to sample, and 5 % of their first 25 autocorrelations "
         "beyond "
         "what\n95 % of those of white noise keep to.\n" +
         table.Format();
}

std::string Percent(const std::optional<double>& percent) { return percent ? Rounded(*percent, 3) : "-"; }

}  // namespace

std::string OnceExplained(const std::string& explanation, const std::string& above) {
  return above.find(explanation) == std::string::npos ? explanation : "Without physics, as explained above:\n";
}

std::string YardstickTable(const std::vector<HistoryMisfit>& misfits, const std::string& above) {
  const auto has = [&](const auto& value) {
    return std::any_of(misfits.begin(), misfits.end(),
                       [&](const HistoryMisfit& one) { return value(one.yardstick).has_value(); });
  };
  if (!has([](const Yardstick& one) { return one.Allowed_percent(); })) return "";
  const bool repeats = has([](const Yardstick& one) { return one.repeat_nmse_percent; });
  std::vector<std::string> head = {"recording", "channel", "NMSE, %", "linear model, %", "its order", "coherence"};
  if (repeats) head.emplace_back("repeats, %");
  head.emplace_back("of the model, %");
  TextTable table(head);
  for (const HistoryMisfit& misfit : misfits) {
    const Yardstick& one = misfit.yardstick;
    std::vector<std::string> row = {misfit.recording,
                                    misfit.name,
                                    Rounded(misfit.nmse_percent, 3),
                                    Percent(one.nmse_percent),
                                    one.order > 0 ? std::to_string(one.order) : "-",
                                    one.coherence ? Rounded(*one.coherence, 4) : "-"};
    if (repeats) row.push_back(Percent(one.repeat_nmse_percent));
    const std::optional<double> allowed = one.Allowed_percent();
    row.push_back(allowed ? Percent(std::max(0.0, misfit.nmse_percent - *allowed)) : "-");
    table.Add(row);
  }
  return OnceExplained(
             "Without physics: the best linear model from the same inputs (ARX), coherence, and what differs between "
             "repeats.\nNMSE above the least of these is the model's: a better one exists. Below it, the data may "
             "allow "
             "no more.\n",
             above) +
         table.Format();
}

std::string HistoryTable(const std::vector<HistoryMisfit>& misfits) {
  // Of one recording or some of several.
  const bool full = std::any_of(misfits.begin(), misfits.end(),
                                [](const HistoryMisfit& misfit) { return misfit.reduced_nmse_percent.has_value(); });
  std::vector<std::string> head = {"recording", "channel", "NMSE, %", "VAF, %", "gain", "delay, ms", "lag-1 corr."};
  if (full) head.insert(head.begin() + 3, "of reduced model");
  TextTable table(head);
  for (const HistoryMisfit& misfit : misfits) {
    std::vector<std::string> row = {misfit.recording,
                                    misfit.name,
                                    Rounded(misfit.nmse_percent, 3),
                                    Rounded(misfit.vaf_percent, 5),
                                    misfit.gain ? Rounded(*misfit.gain, 4) : "",
                                    misfit.delay_s ? Rounded(1e3 * *misfit.delay_s, 2) : "",
                                    Rounded(misfit.residual_correlation, 2)};
    if (full) row.insert(row.begin() + 3, misfit.reduced_nmse_percent ? Rounded(*misfit.reduced_nmse_percent, 3) : "");
    table.Add(row);
  }
  return table.Format() + OneStepTable(misfits);
}

}  // namespace fourpost
