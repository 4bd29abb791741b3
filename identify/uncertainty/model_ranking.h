#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"

#include "identify/uncertainty/model_criteria.h"

namespace fourpost {

/// A fitted model as the result.json of its run states it.
struct FittedModel {
  std::string name;
  /// Mean normalised mean square errors of the recordings that were fitted, and of those that were not [%]; NaN without
  /// validation.
  double fitted_percent = 0;
  double validation_percent = 0;
  ModelCriteria criteria;
  /// How its fit ended, as result.json has it: "converged", ...
  std::string termination = "converged";
  /// Whether it explains what it was fitted to, see FitVerdict.
  bool explains = true;
};

/// Models of the same recordings, the one to choose first.
struct ModelRanking {
  std::vector<FittedModel> models;
  /// Why it is the first.
  std::string reason;
  /// Why that is doubtful: fits that did not converge, nothing to compare with.
  Diagnostics warnings;
};

/// By the error of recordings that the fit has not seen, least first; without validation by BIC. Of models within 10 %
/// of the least error the one of fewest parameters comes first: more is not worth what it costs in certainty. Models
/// without a BIC (NaN) need validation.
ModelRanking Rank(std::vector<FittedModel> models);

}  // namespace fourpost
