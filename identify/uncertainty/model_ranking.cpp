#include "identify/uncertainty/model_ranking.h"

#include <algorithm>
#include <cmath>

#include "analysis/text/short_number.h"
#include "identify/uncertainty/findings.h"

namespace fourpost {
namespace {

/// Of the least validation error.
constexpr double kAlike = 1.1;
/// What no other recording would confirm.
constexpr double kSame = 1.02;

const FittedModel& LeastBic(const std::vector<FittedModel>& models) {
  return *std::min_element(models.begin(), models.end(),
                           [](const FittedModel& a, const FittedModel& b) { return a.criteria.bic < b.criteria.bic; });
}

/// "; b is equally good, 2.98 %" of models that predict as well with as many parameters.
std::string EquallyGood(const std::vector<FittedModel>& models) {
  const FittedModel& chosen = models.front();
  std::string text;
  for (auto model = models.begin() + 1; model != models.end(); ++model)
    if (model->validation_percent <= kSame * chosen.validation_percent &&
        model->criteria.parameters == chosen.criteria.parameters)
      text += "; " + model->name + " is equally good, " + ShortNumber(model->validation_percent) + " %";
  return text;
}

std::string Reason(const std::vector<FittedModel>& models, double least, bool validated) {
  const FittedModel& chosen = models.front();
  if (models.size() == 1)
    return chosen.name + (validated ? ": prediction error " : ": fit error ") +
           ShortNumber(validated ? chosen.validation_percent : chosen.fitted_percent) +
           (validated ? " %" : " %; keep recordings for validation");
  if (!validated)
    return chosen.name + ": lowest BIC; no common validation recording, so the runs cannot be ranked by prediction";
  std::string reason = chosen.name + ": ";
  if (chosen.validation_percent == least) reason += "lowest prediction error of all models, ";
  else
    reason +=
        "fewest parameters of the models within 10 % of the lowest prediction error, " + ShortNumber(least) + " %: ";
  reason += ShortNumber(chosen.validation_percent) + " %" + EquallyGood(models);
  if (std::any_of(models.begin(), models.end(),
                  [](const FittedModel& model) { return std::isnan(model.criteria.bic); }))
    return reason;
  const std::string& by_bic = LeastBic(models).name;
  if (by_bic == chosen.name) return reason + "; also the lowest BIC";
  return reason + "; " + by_bic +
         " has the lowest BIC, so it fits the fitted recordings better, but predicts the others worse: trust the "
         "prediction";
}

Diagnostics WarningsOf(const std::vector<FittedModel>& models) {
  Diagnostics warnings;
  if (models.size() == 1) warnings.Report(kRankedAlone, {});
  for (const FittedModel& model : models)
    if (model.termination != "converged")
      warnings.Report(model.termination == "interrupted" ? kRankedInterrupted : kRankedNotConverged, {}, {model.name});
  for (const FittedModel& model : models)
    if (!model.explains) warnings.Report(kRankedUnexplained, {}, {model.name});
  return warnings;
}

}  // namespace

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
  Diagnostics warnings = WarningsOf(models);
  return {std::move(models), std::move(reason), std::move(warnings)};
}

}  // namespace fourpost
