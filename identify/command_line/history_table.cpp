#include "identify/command_line/history_table.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "identify/command_line/text_table.h"

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

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// A model that is wrong in shape gains less by a shift.
constexpr double kMuch = 0.25;

bool GainsByTiming(const HistoryMisfit& misfit) {
  return misfit.gain && *misfit.timed_nmse_percent < kMuch * misfit.nmse_percent;
}

std::string Left(const HistoryMisfit& misfit) {
  return ": its error would be " + Rounded(*misfit.timed_nmse_percent, 2) + " % without that\n";
}

std::string Milliseconds(double delay_s) {
  return Rounded(1e3 * std::abs(delay_s), 3) + " ms " + (delay_s > 0 ? "later" : "earlier");
}

/// Of one recording. A fit meets a channel that is late half-way, so that the healthy ones seem early: what they have
/// in common, their median, is nobody's delay, and the odd one out is the one farthest from it.
std::string DelayRemark(std::span<const HistoryMisfit> misfits, double sample_s) {
  std::vector<double> delays;
  for (const HistoryMisfit& misfit : misfits)
    if (misfit.delay_s) delays.push_back(*misfit.delay_s);
  if (delays.empty()) return "";
  const double common = Median(delays);
  const auto off = [&](const HistoryMisfit& misfit) {
    return misfit.delay_s ? std::abs(*misfit.delay_s - common) : 0.0;
  };
  const HistoryMisfit& odd =
      *std::max_element(misfits.begin(), misfits.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
  const std::string recording = "' of '" + odd.recording + "'";
  // Of two it is anybody's guess.
  if (delays.size() > 2 && off(odd) > sample_s && GainsByTiming(odd))
    return "'" + odd.name + recording + " comes " + Milliseconds(*odd.delay_s - common) +
           " than the other channels do against the model, as if it were not synchronised" + Left(odd);
  const bool all_gain = std::all_of(misfits.begin(), misfits.end(), GainsByTiming);
  if (all_gain && delays.size() > 2 && std::abs(common) > sample_s)
    return "all channels of '" + odd.recording + "' come " + Milliseconds(common) +
           " than the model, as if the height of its post were not synchronised with them\n";
  if (delays.size() > 2) return "";
  std::string remarks;
  for (const HistoryMisfit& misfit : misfits)
    if (GainsByTiming(misfit) && std::abs(*misfit.delay_s) > sample_s)
      remarks += "'" + misfit.name + recording + " comes " + Milliseconds(*misfit.delay_s) +
                 " than the model, as if it, or the height of its post, were not synchronised" + Left(misfit);
  return remarks;
}

/// Gain and place of a channel; empty where they are right.
std::string ScaleRemark(const HistoryMisfit& misfit) {
  // Less than g; no model that has the shape right is so far off.
  constexpr double kOtherUnit = 5;
  const std::string channel = "'" + misfit.name + "' of '" + misfit.recording + "'";
  if (misfit.swapped_with)
    return channel + " is measured like the model's '" + *misfit.swapped_with +
           "', and the other way round, as if the two channels were swapped\n";
  if (!GainsByTiming(misfit)) return "";
  const double ratio = std::max(std::abs(*misfit.gain), 1 / std::abs(*misfit.gain));
  if (ratio > kOtherUnit)
    return channel + " and the model differ by a factor of " + Rounded(ratio, 3) +
           ", as if its unit were wrong (1000: mm for m, 9.81: g for m/s^2)" + Left(misfit);
  if (*misfit.gain < 0) return channel + " goes against the model, as if its sign were wrong" + Left(misfit);
  return "";
}

}  // namespace

std::string HistoryTable(const std::vector<HistoryMisfit>& misfits) {
  const bool full = !misfits.empty() && misfits.front().full_nmse_percent;
  std::vector<std::string> head = {"recording", "channel", "NMSE, %", "VAF, %", "gain", "delay, ms"};
  if (full) head.insert(head.begin() + 3, "multibody NMSE, %");
  TextTable table(head);
  for (const HistoryMisfit& misfit : misfits) {
    std::vector<std::string> row = {misfit.recording,
                                    misfit.name,
                                    Rounded(misfit.nmse_percent, 3),
                                    Rounded(misfit.vaf_percent, 5),
                                    misfit.gain ? Rounded(*misfit.gain, 4) : "",
                                    misfit.delay_s ? Rounded(1e3 * *misfit.delay_s, 2) : ""};
    if (full) row.insert(row.begin() + 3, Rounded(*misfit.full_nmse_percent, 3));
    table.Add(row);
  }
  return table.Format() + OneStepTable(misfits);
}

std::string HistoryRemarks(const std::vector<HistoryMisfit>& misfits, double sample_s) {
  std::string remarks;
  for (auto first = misfits.begin(); first != misfits.end();) {
    const auto last = std::find_if(first, misfits.end(),
                                   [&](const HistoryMisfit& misfit) { return misfit.recording != first->recording; });
    std::string scales;
    for (auto misfit = first; misfit != last; ++misfit) scales += ScaleRemark(*misfit);
    // A channel of another scale moves the model, and with it all delays.
    remarks += scales.empty() ? DelayRemark({first, last}, sample_s) : scales;
    first = last;
  }
  return remarks;
}

}  // namespace fourpost
