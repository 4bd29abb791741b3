#include "vehicles/condensed/linear_response.h"

#include <complex>
#include <numbers>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/linear_vehicle.h"

namespace fourpost {

Eigen::MatrixXcd LinearResponse(const CondensedModel& model, double frequency_Hz) {
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  const std::complex<double> iw(0, omega);
  const LinearVehicle vehicle(model, LinearVehicle::Rates::kMean);
  Eigen::MatrixXcd forces = Eigen::MatrixXcd::Zero(vehicle.size(), model.post_stiffness.cols());
  forces.topRows(model.mass.rows()) = model.post_stiffness + iw * model.post_damping;
  const Eigen::MatrixXcd motion = Solved(vehicle.Impedance(omega), forces).topRows(model.mass.rows());
  return (model.on_position + iw * model.on_velocity + iw * iw * model.on_acceleration) * motion +
         (model.on_post_height + iw * model.on_post_velocity + iw * iw * model.on_post_acceleration);
}

}  // namespace fourpost
