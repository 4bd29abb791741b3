#include "identify/command_line/misfit_table.h"

#include "identify/command_line/text_table.h"

namespace fourpost {

std::string MisfitTable(const std::vector<ChannelMisfit>& misfits) {
  TextTable table({"channel", "rms dB", "rms deg", "NMSE, %"});
  const auto add = [&](const std::string& name, const ChannelMisfit& misfit) {
    table.Add({name, Rounded(misfit.rms_dB, 3), Rounded(misfit.rms_deg, 3), Rounded(misfit.nmse_percent, 3)});
  };
  for (const ChannelMisfit& misfit : misfits) add(misfit.name, misfit);
  add("all", GroupMisfit(misfits, ""));
  return table.Format();
}

}  // namespace fourpost
