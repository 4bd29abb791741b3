#include "identify/report/ranked_run.h"

#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include "identify/report/findings.h"
#include "identify/report/run_result.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

/// NaN of an empty list.
double MeanError(const std::vector<Json>& channels) {
  double sum = 0;
  for (const Json& channel : channels) sum += NumberAt(channel, "nmse_percent");
  return channels.empty() ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(channels.size());
}

/// Nothing where the run is not of bench recordings.
std::optional<FittedModel> ModelOf(const ComparedRun& run) {
  const Json criteria = run.result.value("criteria", Json());
  const double residuals = NumberAt(criteria, "residuals");
  const double parameters = NumberAt(criteria, "parameters");
  if (!(residuals > 0) || !(parameters >= 0)) return std::nullopt;
  return FittedModel{.name = run.name,
                     .fitted_percent = MeanError(ListAt(run.result, "channels")),
                     .validation_percent = MeanError(ListAt(run.result, "validation")),
                     .criteria = {.residuals = static_cast<std::size_t>(residuals),
                                  .parameters = static_cast<std::size_t>(parameters),
                                  .aicc = NumberAt(criteria, "aicc"),
                                  .bic = NumberAt(criteria, "bic")},
                     .termination = TextAt(run.result, "termination"),
                     .explains = ListAt(run.result.value("verdict", Json()), "reasons").empty()};
}

/// What was kept for validation: recordings and their bytes, in whichever order the study has them.
std::multiset<std::string> ValidationOf(const ComparedRun& run) {
  std::multiset<std::string> kept;
  for (const Json& channel : ListAt(run.result, "validation")) kept.insert(TextAt(channel, "recording"));
  for (const Json& file : ListAt(run.result, "validation_files")) kept.insert(TextAt(file, "sha256"));
  return kept;
}

}  // namespace

std::vector<FittedModel> FittedModels(const std::vector<ComparedRun>& runs, Diagnostics& diagnostics) {
  std::vector<FittedModel> models;
  const ComparedRun* first = nullptr;
  for (const ComparedRun& run : runs) {
    std::optional<FittedModel> model = ModelOf(run);
    if (!model) {
      diagnostics.Report(kRunNotOfBench, {run.FileNamed("result.json")});
      continue;
    }
    if (first == nullptr) first = &run;
    if (run.data != first->data || ValidationOf(run) != ValidationOf(*first))
      diagnostics.Report(kRunOfOtherData, {run.FileNamed("result.json")}, {first->folder});
    models.push_back(std::move(*model));
  }
  return models;
}

}  // namespace fourpost
