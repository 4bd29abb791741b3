#include "identify/uncertainty/model_ranking.h"

#include <algorithm>
#include <cmath>

#include "analysis/text/short_number.h"

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

/// "; b is as good, 2.98 %" of models that foretell as well with as many parameters.
std::string AsGood(const std::vector<FittedModel>& models) {
  const FittedModel& chosen = models.front();
  std::string text;
  for (auto model = models.begin() + 1; model != models.end(); ++model)
    if (model->validation_percent <= kSame * chosen.validation_percent &&
        model->criteria.parameters == chosen.criteria.parameters)
      text += "; " + model->name + " is as good, " + ShortNumber(model->validation_percent) + " %";
  return text;
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
  reason += ShortNumber(chosen.validation_percent) + " %" + AsGood(models);
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
  for (const FittedModel& model : models)
    if (!model.explains)
      remarks.push_back(model.name + " does not explain the data that it was fitted to: its report says why.");
  return remarks;
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
  std::vector<std::string> remarks = Remarks(models);
  return {std::move(models), std::move(reason), std::move(remarks)};
}

}  // namespace fourpost
