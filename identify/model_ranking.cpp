#include "identify/model_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "analysis/short_number.h"
#include "analysis/text_file.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

/// Of the least validation error.
constexpr double kAlike = 1.1;

double Number(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// NaN of an empty list.
double MeanError(const Json& list) {
  double sum = 0;
  for (const Json& entry : list) sum += Number(entry.at("nmse_percent"));
  return sum / static_cast<double>(list.size());
}

std::set<std::string> Recordings(const Json& list) {
  std::set<std::string> names;
  for (const Json& entry : list) names.insert(entry.at("recording").get<std::string>());
  return names;
}

/// What of a result decides whether another one can be compared with it.
struct Data {
  std::set<std::string> fitted;
  std::set<std::string> validation;
  std::size_t residuals = 0;

  bool operator==(const Data&) const = default;
};

struct ReadModel {
  FittedModel model;
  Data data;
};

ReadModel ModelOf(const Json& json) {
  const Json validation = json.value("validation", Json::array());
  const Json& criteria = json.at("criteria");
  FittedModel model{.name = std::filesystem::path(json.at("study").get<std::string>()).stem().string(),
                    .fitted_percent = MeanError(json.at("channels")),
                    .validation_percent = MeanError(validation),
                    .criteria = {.residuals = criteria.at("residuals").get<std::size_t>(),
                                 .parameters = criteria.at("parameters").get<std::size_t>(),
                                 .aicc = Number(criteria.at("aicc")),
                                 .bic = Number(criteria.at("bic"))},
                    .termination = json.at("termination").get<std::string>()};
  const Data data{Recordings(json.at("channels")), Recordings(validation), model.criteria.residuals};
  return {std::move(model), data};
}

std::optional<ReadModel> Read(const std::filesystem::path& run, Diagnostics& diagnostics) {
  const std::filesystem::path file = run / "result.json";
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) return std::nullopt;
  try {
    return ModelOf(Json::parse(*text));
  } catch (const Json::exception&) {
    diagnostics.Error(file.string(), 0,
                      "is not the result of a fit to bench recordings; give folders that `fourpost fit` wrote for a "
                      "study with 'bench'");
    return std::nullopt;
  }
}

const FittedModel& LeastBic(const std::vector<FittedModel>& models) {
  return *std::min_element(models.begin(), models.end(),
                           [](const FittedModel& a, const FittedModel& b) { return a.criteria.bic < b.criteria.bic; });
}

std::string Reason(const std::vector<FittedModel>& models, double least, bool validated) {
  const FittedModel& chosen = models.front();
  if (models.size() == 1)
    return chosen.name + ": misses " + ShortNumber(validated ? chosen.validation_percent : chosen.fitted_percent) +
           (validated ? " % of what it was not fitted to"
                      : " % of what it was fitted to; keep recordings for validation");
  if (!validated)
    return chosen.name + ": its BIC is the least; no recording was kept for validation, which would tell more";
  std::string reason = chosen.name + ": ";
  if (chosen.validation_percent == least) reason += "of all models it misses least of what it was not fitted to, ";
  else
    reason += "it has the fewest parameters of those within 10 % of the least validation error, " + ShortNumber(least) +
              " %: ";
  reason += ShortNumber(chosen.validation_percent) + " %";
  if (std::any_of(models.begin(), models.end(),
                  [](const FittedModel& model) { return std::isnan(model.criteria.bic); }))
    return reason;
  const std::string& by_bic = LeastBic(models).name;
  if (by_bic == chosen.name) return reason + "; its BIC is the least, too";
  return reason + "; the least BIC has " + by_bic +
         ", which the fitted recordings favour and the others do not: trust the others";
}

std::vector<std::string> Remarks(const std::vector<FittedModel>& models) {
  std::vector<std::string> remarks;
  if (models.size() == 1)
    remarks.push_back("This is the only run given: fit other models to the same recordings to know what it is worth.");
  for (const FittedModel& model : models)
    if (model.termination != "converged")
      remarks.push_back("The fit of " + model.name +
                        (model.termination == "interrupted" ? " was interrupted" : " did not converge") +
                        ": it may miss more than the model does; let it end before you judge it.");
  return remarks;
}

}  // namespace

std::vector<FittedModel> ReadFittedModels(const std::vector<std::filesystem::path>& runs, Diagnostics& diagnostics) {
  std::vector<FittedModel> models;
  std::optional<Data> first;
  for (const std::filesystem::path& run : runs) {
    std::optional<ReadModel> read = Read(run, diagnostics);
    if (!read) continue;
    if (first && *first != read->data)
      diagnostics.Error((run / "result.json").string(), 0,
                        "was fitted or validated with other recordings than " + runs.front().string() +
                            ": errors and criteria compare models of the same data only");
    if (!first) first = read->data;
    models.push_back(std::move(read->model));
  }
  return models;
}

ModelRanking Rank(std::vector<FittedModel> models) {
  const bool validated = std::none_of(models.begin(), models.end(),
                                      [](const FittedModel& model) { return std::isnan(model.validation_percent); });
  const auto error = [&](const FittedModel& model) {
    return validated ? model.validation_percent : model.criteria.bic;
  };
  std::stable_sort(models.begin(), models.end(),
                   [&](const FittedModel& a, const FittedModel& b) { return error(a) < error(b); });
  const double least = error(models.front());
  if (validated) {
    const auto alike = std::partition_point(models.begin(), models.end(), [&](const FittedModel& model) {
      return model.validation_percent <= kAlike * least;
    });
    const auto simplest = std::min_element(models.begin(), alike, [](const FittedModel& a, const FittedModel& b) {
      return a.criteria.parameters < b.criteria.parameters;
    });
    std::rotate(models.begin(), simplest, simplest + 1);
  }
  std::string reason = Reason(models, least, validated);
  std::vector<std::string> remarks = Remarks(models);
  return {std::move(models), std::move(reason), std::move(remarks)};
}

}  // namespace fourpost
