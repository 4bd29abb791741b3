#include "vehicles/ride/vehicle_summary.h"

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/mode_names.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

double VehicleSummary::Weight_N() const { return mass_kg * kGravity; }

double VehicleSummary::TyreLoad_N() const {
  double sum = 0;
  for (const CornerLoad& corner : corner_loads) sum += corner.load_N;
  return sum;
}

std::optional<double> VehicleSummary::SprungMass_kg() const {
  if (!ride.unsprung_mass_kg) return std::nullopt;
  return mass_kg - *ride.unsprung_mass_kg;
}

VehicleSummary Summarise(const Vehicle& vehicle, std::span<const double> parameters) {
  const CondensedVehicle condensed(vehicle);
  const CondensedModel model = condensed.At(parameters);
  const Kinematics pose = DesignKinematics(vehicle);
  VehicleSummary summary;
  summary.dof = condensed.size();
  summary.suspension = SuspensionOf(vehicle, pose, parameters);
  std::vector<MassProperties> masses;
  for (const BodyMotion& body : summary.suspension.bodies) masses.push_back(body.mass);
  const MassProperties whole = Joined(masses);
  summary.mass_kg = whole.mass;
  summary.com = whole.com;
  summary.inertia = whole.inertia;
  for (std::size_t i = 0; i < vehicle.tyres.size(); ++i)
    summary.corner_loads.push_back({vehicle.tyres[i].name, model.preloads.tyre[i]});
  summary.spring_tension = model.preloads.spring;
  const HeldChassis held(summary.suspension, StiffnessWithoutTyres(vehicle, pose, parameters, model));
  summary.ride = RideGeometryOf(vehicle, pose, summary.suspension, held, model.preloads.tyre, parameters);
  summary.chassis =
      ChassisNumbersOf(vehicle, pose, summary.suspension, held, summary.ride, model.preloads.tyre, whole, parameters);
  summary.modes = ModesOf(model);
  NameModes(vehicle, pose, summary.suspension, held, summary.modes);
  if (!model.rubbings.empty()) {
    summary.stuck_modes = ModesOf(model.Stuck());
    NameModes(vehicle, pose, summary.suspension, held, summary.stuck_modes);
  }
  summary.growth_rate = EigenvaluesOf(StateMatrix(model)).real().maxCoeff();
  summary.views = ParameterViews(vehicle, condensed, parameters);
  return summary;
}

}  // namespace fourpost
