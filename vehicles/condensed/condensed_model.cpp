#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

std::vector<const CondensedModel::Dashpot*> CondensedModel::SeriesDampers() const {
  std::vector<const Dashpot*> series;
  for (const Dashpot& dashpot : dashpots)
    if (dashpot.HasSeries()) series.push_back(&dashpot);
  return series;
}

}  // namespace fourpost
