#include "identify/experiments/four_post/response_misfit_json.h"

#include <algorithm>
#include <optional>

#include "analysis/files/json_text.h"

namespace fourpost {

nlohmann::ordered_json ErrorsJson(const ChannelMisfit& misfit) {
  return {{"rms_dB", NumberOrNull(misfit.rms_dB)},
          {"rms_deg", NumberOrNull(misfit.rms_deg)},
          {"nmse_percent", NumberOrNull(misfit.nmse_percent)}};
}

nlohmann::ordered_json ResponseMisfitsJson(const std::vector<ChannelMisfit>& misfits) {
  auto list = nlohmann::ordered_json::array();
  for (const ChannelMisfit& misfit : misfits) {
    nlohmann::ordered_json entry = {{"name", misfit.name}};
    entry.update(ErrorsJson(misfit));
    entry["vaf_percent"] = NumberOrNull(100 - misfit.nmse_percent);
    if (misfit.misfit) entry["misfit"] = NumberOrNull(*misfit.misfit);
    if (misfit.worst)
      entry["worst"] = {{"recording", misfit.worst->recording},
                        {"band_Hz", {misfit.worst->lower_Hz, misfit.worst->upper_Hz}},
                        {"misfit", misfit.worst->misfit}};
    entry["residual_correlation"] = NumberOrNull(misfit.residual_correlation);
    if (const std::optional<double> allowed = misfit.Allowed_percent()) {
      nlohmann::ordered_json& yardstick = entry["yardstick"];
      if (misfit.linear_percent) yardstick["nmse_percent"] = NumberOrNull(*misfit.linear_percent);
      if (misfit.scatter_percent) yardstick["repeat_nmse_percent"] = NumberOrNull(*misfit.scatter_percent);
      yardstick["model_nmse_percent"] = NumberOrNull(std::max(0.0, misfit.nmse_percent - *allowed));
    }
    list.push_back(std::move(entry));
  }
  return list;
}

nlohmann::ordered_json UnseenMisfitsJson(const std::vector<MeasuredRun>& unseen,
                                         const std::vector<FrequencyResponse>& predicted,
                                         const ModelError& model_error) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t r = 0; r < unseen.size(); ++r) {
    std::vector<ChannelMisfit> misfits = ResponseMisfits({unseen[r]}, {predicted[r]});
    AddDeviations({unseen[r]}, {predicted[r]}, model_error, misfits);
    for (const ChannelMisfit& misfit : misfits) {
      nlohmann::ordered_json entry = {{"recording", unseen[r].name}, {"name", misfit.name}};
      entry.update(ErrorsJson(misfit));
      entry["vaf_percent"] = NumberOrNull(100 - misfit.nmse_percent);
      if (misfit.misfit) entry["misfit"] = NumberOrNull(*misfit.misfit);
      list.push_back(std::move(entry));
    }
  }
  return list;
}

}  // namespace fourpost
