#include "vehicles/description/chassis.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace fourpost {

int AxleCount(std::vector<double> stations) {
  std::sort(stations.begin(), stations.end(), std::greater<>());
  int count = 0;
  double first = 0;
  for (const double station : stations) {
    if (count > 0 && first - station <= kSameStation_m) continue;
    first = station;
    ++count;
  }
  return count;
}

int ChassisOf(std::span<const TyreCarrier> bodies) {
  std::vector<double> all;
  for (const TyreCarrier& body : bodies) all.insert(all.end(), body.stations.begin(), body.stations.end());
  const int axles = AxleCount(all);
  int chassis = -1;
  double heaviest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int own = AxleCount(bodies[i].stations);
    if (own > 1 && own == axles) return static_cast<int>(i);
    if (own == 1 || bodies[i].mass <= heaviest) continue;
    chassis = static_cast<int>(i);
    heaviest = bodies[i].mass;
  }
  return chassis;
}

}  // namespace fourpost
