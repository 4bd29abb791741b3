#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

std::vector<const CondensedModel::Dashpot*> CondensedModel::SeriesDampers() const {
  std::vector<const Dashpot*> series;
  for (const Dashpot& dashpot : dashpots)
    if (dashpot.HasSeries()) series.push_back(&dashpot);
  return series;
}

CondensedModel CondensedModel::Stuck() const {
  CondensedModel stuck = *this;
  stuck.rubbings.clear();
  for (const Rubbing& friction : rubbings)
    if (friction.law.force > 0)
      stuck.stiffness += friction.law.stiffness * friction.direction * friction.direction.transpose();
  return stuck;
}

}  // namespace fourpost
