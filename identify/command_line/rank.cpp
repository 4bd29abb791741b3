#include <cmath>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/report/ranked_run.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

std::string Table(const ModelRanking& ranking) {
  TextTable table({"model", "parameters", "fitted NMSE, %", "validation NMSE, %", "AICc", "BIC"});
  for (const FittedModel& model : ranking.models)
    table.Add({model.name, std::to_string(model.criteria.parameters), Rounded(model.fitted_percent, 3),
               Rounded(model.validation_percent, 3), Rounded(model.criteria.aicc, 5), Rounded(model.criteria.bic, 5)});
  return table.Format();
}

std::string RankingJson(const ModelRanking& ranking) {
  Json models = Json::array();
  for (const FittedModel& model : ranking.models)
    models.push_back({{"name", model.name},
                      {"parameters", model.criteria.parameters},
                      {"fitted_nmse_percent", NumberOrNull(model.fitted_percent)},
                      {"validation_nmse_percent", NumberOrNull(model.validation_percent)},
                      {"aicc", NumberOrNull(model.criteria.aicc)},
                      {"bic", NumberOrNull(model.criteria.bic)}});
  const Json warnings = WarningsJson(ranking.warnings);
  // The form of 0.1.0, for one version.
  Json remarks = Json::array();
  for (const Json& warning : warnings) remarks.push_back(warning["text"]);
  const Json json = {{"chosen", ranking.models.front().name},
                     {"reason", ranking.reason},
                     {"warnings", warnings},
                     {"remarks", remarks},
                     {"models", models}};
  return JsonText(json);
}

}  // namespace

int Run(const RankCommand& command) {
  Diagnostics diagnostics;
  std::vector<FittedModel> models =
      FittedModels(ComparedRuns(ReadRuns(command.runs), AllExperimentReports()), diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  const ModelRanking ranking = Rank(std::move(models));
  const std::string warnings = ranking.warnings.items().empty() ? "" : ranking.warnings.Format() + "\n";
  if (command.json) Print(RankingJson(ranking));
  else PrintText(Table(ranking) + "\n" + ranking.reason + "\n" + warnings);
  return kGood;
}

}  // namespace fourpost
