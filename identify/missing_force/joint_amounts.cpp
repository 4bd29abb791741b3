#include "identify/missing_force/joint_amounts.h"

#include <algorithm>
#include <cmath>

namespace fourpost {
namespace {

void SetAmounts(const WeighedForces& forces, std::vector<ForceExplanation>& found) {
  const auto [amounts, covariance] = forces.Amounts();
  const double noise = std::max(1.0, forces.Squares() / forces.degrees());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    if (found[i].amount != 0) found[i].most_N *= std::abs(amounts[j] / found[i].amount);
    found[i].amount = amounts[j];
    found[i].sd = std::sqrt(noise * covariance(j, j));
  }
}

/// Standard deviations of it that there are; of one that is not allowed at most none.
double StrengthOf(const ForceExplanation& one, const ForceRecord& record) {
  const double deviations = one.amount / one.sd;
  return one.mechanism.Allows(one.amount, record) ? deviations : std::min(0.0, deviations);
}

}  // namespace

WeighedForces EstimateTogether(const ForceRecord& record, std::vector<ForceExplanation>& found) {
  constexpr double kThere = 3;
  while (true) {
    WeighedForces forces(record);
    for (const ForceExplanation& one : found) forces.TakeOut(one.mechanism);
    if (found.empty()) return forces;
    SetAmounts(forces, found);
    const auto weakest =
        std::min_element(found.begin(), found.end(), [&](const ForceExplanation& a, const ForceExplanation& b) {
          return StrengthOf(a, record) < StrengthOf(b, record);
        });
    if (StrengthOf(*weakest, record) > kThere) return forces;
    found.erase(weakest);
  }
}

}  // namespace fourpost
