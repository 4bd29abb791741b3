#include "vehicles/condensed_model.h"

namespace fourpost {

std::vector<const CondensedModel::Dashpot*> CondensedModel::SeriesDampers() const {
  std::vector<const Dashpot*> series;
  for (const Dashpot& dashpot : dashpots)
    if (dashpot.series_stiffness > 0) series.push_back(&dashpot);
  return series;
}

}  // namespace fourpost
