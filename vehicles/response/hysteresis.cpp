#include "vehicles/response/hysteresis.h"

#include <algorithm>

namespace fourpost {

bool HasHysteresis(const CondensedModel& model) {
  // Of the rates of the vehicle's dampers; and how much steeper friction is as it turns round.
  constexpr double kFaint = 0.05;
  constexpr double kSteep = 10;
  double rate = 0;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots) rate = std::max(rate, dashpot.law.LeastRate());
  return std::any_of(model.dashpots.begin(), model.dashpots.end(), [&](const CondensedModel::Dashpot& dashpot) {
    const double least = dashpot.law.LeastRate();
    return dashpot.HasSeries() && least < kFaint * rate && dashpot.law.GreatestRate() > kSteep * least;
  });
}

}  // namespace fourpost
