#include "vehicles/lint/bench_vehicle.h"

namespace fourpost {

bool IsBenchVehicle(const Vehicle& vehicle) {
  // The ground and the piston's rod.
  constexpr std::size_t kLinks = 2;
  return vehicle.links.size() == kLinks && !vehicle.dampers.empty() && vehicle.tyres.empty() &&
         vehicle.sensors.empty();
}

}  // namespace fourpost
