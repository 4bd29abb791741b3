#pragma once

#include <complex>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/condensed/port.h"
#include "vehicles/condensed/receptance.h"
#include "vehicles/response/port_cycle.h"

namespace fourpost {

/// The force that a reduced vehicle needs, beside those of its own elements and posts, to move in a given periodic way:
///   F = mass s'' + damping s' + stiffness s + sum of element forces - posts
/// at the first harmonic. Nonlinear elements are evaluated over the cycle, as harmonic balance does; extensions of
/// series springs follow from the balance of spring and dashpot.
class NeededForce {
 public:
  /// `shape`: of the posts, see Excitation. The model must outlive this object.
  NeededForce(const CondensedModel& model, const std::vector<double>& shape);
  NeededForce(const NeededForce&) = delete;
  NeededForce& operator=(const NeededForce&) = delete;

  /// Harmonics of the motion that count.
  static constexpr int kHarmonics = 17;

  /// `motion`: harmonics 0, 1, .. of s in rows; any number of them, the others are zero. `posts`: complex amplitude of
  /// the reference post [m]. Empty where a series damper has no periodic motion.
  std::optional<Eigen::VectorXcd> At(double frequency_Hz, std::complex<double> posts, const Eigen::MatrixXcd& motion);

 private:
  /// Of all harmonics, for motion s, with the series springs' extensions as in the linear vehicle: [s x].
  Eigen::MatrixXcd WithSeries(double omega, const Eigen::MatrixXcd& motion) const;

  const CondensedModel& model_;
  Eigen::VectorXd shape_;
  LinearVehicle vehicle_;
  std::vector<Port> ports_;
  /// With coordinates that no force moves.
  Receptance held_;
  PortCycle cycle_;
};

}  // namespace fourpost
