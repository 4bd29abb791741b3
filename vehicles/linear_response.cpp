#include "vehicles/linear_response.h"

#include <complex>
#include <numbers>

#include <Eigen/LU>

namespace fourpost {

Eigen::MatrixXcd LinearResponse(const CondensedModel& model, double frequency_Hz) {
  const std::complex<double> iw(0, 2 * std::numbers::pi * frequency_Hz);
  Eigen::MatrixXcd impedance = model.stiffness + iw * model.damping + iw * iw * model.mass;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots) {
    std::complex<double> rate = dashpot.law.MeanRate();
    // In series with a spring k a dashpot c carries c / (1 + i w c / k).
    if (dashpot.series_stiffness > 0) rate /= 1.0 + iw * rate / dashpot.series_stiffness;
    impedance += iw * rate * dashpot.direction * dashpot.direction.transpose();
  }
  const Eigen::MatrixXcd motion = impedance.partialPivLu().solve(model.post_stiffness + iw * model.post_damping);
  return (model.on_position + iw * model.on_velocity + iw * iw * model.on_acceleration) * motion +
         (model.on_post_height + iw * model.on_post_velocity + iw * iw * model.on_post_acceleration);
}

}  // namespace fourpost
