#include "identify/command_line/history_table.h"

#include <algorithm>
#include <cmath>

#include "identify/command_line/text_table.h"

namespace fourpost {

namespace {

/// Empty without predictions.
std::string OneStepTable(const std::vector<HistoryMisfit>& misfits) {
  TextTable table({"recording", "channel", "simulated, %", "one step ahead, %", "innovations' correlation"});
  for (const HistoryMisfit& misfit : misfits) {
    if (!misfit.one_step_nmse_percent) return "";
    table.Add({misfit.recording, misfit.name, Rounded(misfit.nmse_percent, 3),
               Rounded(*misfit.one_step_nmse_percent, 3), Rounded(*misfit.innovation_correlation, 2)});
  }
  return "\nKalman filter as predictor. It is corrected by each sample before it predicts the next, so that a channel "
         "that it\n"
         "trusts has a far smaller error than in a simulation, whatever the model is worth: the two do not compare.\n" +
         table.Format();
}

}  // namespace

std::string HistoryTable(const std::vector<HistoryMisfit>& misfits) {
  TextTable table({"recording", "channel", "NMSE, %", "VAF, %", "gain", "delay, ms"});
  for (const HistoryMisfit& misfit : misfits)
    table.Add({misfit.recording, misfit.name, Rounded(misfit.nmse_percent, 3), Rounded(misfit.vaf_percent, 5),
               misfit.gain ? Rounded(*misfit.gain, 4) : "", misfit.delay_s ? Rounded(1e3 * *misfit.delay_s, 2) : ""});
  return table.Format() + OneStepTable(misfits);
}

std::string HistoryRemarks(const std::vector<HistoryMisfit>& misfits, double sample_s) {
  // A model that is wrong in shape gains less by a shift.
  constexpr double kMuch = 0.25;
  // Less than g; no model that has the shape right is so far off.
  constexpr double kOtherUnit = 5;
  std::string remarks;
  for (const HistoryMisfit& misfit : misfits) {
    if (!misfit.gain || !(*misfit.timed_nmse_percent < kMuch * misfit.nmse_percent)) continue;
    const std::string channel = "'" + misfit.name + "' of '" + misfit.recording + "'";
    const std::string left = ": its error would be " + Rounded(*misfit.timed_nmse_percent, 2) + " % without that\n";
    const double ratio = std::max(std::abs(*misfit.gain), 1 / std::abs(*misfit.gain));
    if (ratio > kOtherUnit)
      remarks += channel + " and the model differ by a factor of " + Rounded(ratio, 3) +
                 ", as if its unit were wrong (1000: mm for m, 9.81: g for m/s^2)" + left;
    else if (*misfit.gain < 0) remarks += channel + " goes against the model, as if its sign were wrong" + left;
    else if (std::abs(*misfit.delay_s) > sample_s)
      remarks += channel + " comes " + Rounded(1e3 * std::abs(*misfit.delay_s), 3) + " ms " +
                 (*misfit.delay_s > 0 ? "later" : "earlier") + " than the model, as if it were not synchronised" + left;
  }
  return remarks;
}

}  // namespace fourpost
