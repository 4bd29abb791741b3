#include "identify/residuals/history_misfit_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Only what is known.
Json YardstickJson(const HistoryMisfit& misfit) {
  const Yardstick& yardstick = misfit.yardstick;
  Json json = Json::object();
  if (yardstick.order > 0) json["order"] = yardstick.order;
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = NumberOrNull(*value);
  };
  add("one_step_nmse_percent", yardstick.one_step_nmse_percent);
  add("nmse_percent", yardstick.nmse_percent);
  add("coherence", yardstick.coherence);
  add("repeat_nmse_percent", yardstick.repeat_nmse_percent);
  if (const std::optional<double> allowed = yardstick.Allowed_percent())
    json["model_nmse_percent"] = NumberOrNull(std::max(0.0, misfit.nmse_percent - *allowed));
  return json;
}

}  // namespace

nlohmann::ordered_json HistoryMisfitsJson(const std::vector<HistoryMisfit>& misfits) {
  Json list = Json::array();
  for (const HistoryMisfit& misfit : misfits) {
    list.push_back({{"recording", misfit.recording},
                    {"name", misfit.name},
                    {"nmse_percent", NumberOrNull(misfit.nmse_percent)},
                    {"vaf_percent", NumberOrNull(misfit.vaf_percent)},
                    {"residual_correlation", NumberOrNull(misfit.residual_correlation)},
                    {"effective_samples", NumberOrNull(std::round(misfit.effective_samples))},
                    {"residuals_white", misfit.is_white}});
    if (misfit.misfit) list.back()["misfit"] = NumberOrNull(*misfit.misfit);
    if (misfit.gain) list.back()["gain"] = NumberOrNull(*misfit.gain);
    if (misfit.delay_s) list.back()["delay_s"] = NumberOrNull(*misfit.delay_s);
    if (Json yardstick = YardstickJson(misfit); !yardstick.empty()) list.back()["yardstick"] = std::move(yardstick);
    if (misfit.reduced_nmse_percent) list.back()["reduced_nmse_percent"] = NumberOrNull(*misfit.reduced_nmse_percent);
    if (misfit.one_step_nmse_percent)
      list.back()["one_step_nmse_percent"] = NumberOrNull(*misfit.one_step_nmse_percent);
    if (misfit.innovation_correlation)
      list.back()["innovation_correlation"] = NumberOrNull(*misfit.innovation_correlation);
    if (misfit.innovations_beyond) list.back()["innovations_beyond"] = NumberOrNull(*misfit.innovations_beyond);
  }
  return list;
}

}  // namespace fourpost
