#include "identify/experiments/four_post/misfit_table.h"

#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

void Add(const std::string& name, const ChannelMisfit& misfit, TextTable& table) {
  table.Add({name, Rounded(misfit.rms_dB, 3), Rounded(misfit.rms_deg, 3), Rounded(misfit.nmse_percent, 3)});
}

}  // namespace

std::string MisfitTable(const std::vector<ChannelMisfit>& misfits, const std::vector<ChannelMisfit>& recordings) {
  TextTable table({"channel", "rms dB", "rms deg", "NMSE, %"});
  for (const ChannelMisfit& misfit : misfits) Add(misfit.name, misfit, table);
  Add("all", GroupMisfit(misfits, ""), table);
  if (recordings.size() < 2) return table.Format();
  TextTable by_recording({"recording", "rms dB", "rms deg", "NMSE, %"});
  for (const ChannelMisfit& misfit : recordings) Add(misfit.name, misfit, by_recording);
  return table.Format() + '\n' + by_recording.Format();
}

}  // namespace fourpost
