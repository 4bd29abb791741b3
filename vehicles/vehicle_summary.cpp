#include "vehicles/vehicle_summary.h"

#include <Eigen/Eigenvalues>

#include "vehicles/condensed_vehicle.h"

namespace fourpost {

VehicleSummary Summarise(const Vehicle& vehicle, std::span<const double> parameters) {
  const CondensedVehicle condensed(vehicle);
  VehicleSummary summary;
  summary.dof = condensed.size();
  for (const CondensedVehicle::LinkMotion& link : condensed.LinkMotions(parameters)) {
    summary.mass_kg += link.mass;
    summary.com += link.mass * link.com;
  }
  if (summary.mass_kg > 0) summary.com /= summary.mass_kg;
  const Preloads preloads = condensed.PreloadsAt(parameters);
  for (std::size_t i = 0; i < vehicle.tyres.size(); ++i)
    summary.corner_loads.push_back({vehicle.tyres[i].name, preloads.tyre[i]});
  summary.modes = ModesOf(condensed, parameters);
  summary.growth_rate = StateMatrix(condensed.At(parameters)).eigenvalues().real().maxCoeff();
  return summary;
}

}  // namespace fourpost
