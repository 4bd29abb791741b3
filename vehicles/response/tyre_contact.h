#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/response/linearised_cycle.h"

namespace fourpost {

/// Vertical forces over a cycle of tyres that are modelled as linear: c(t) = preload + stiffness e + damping e', e the
/// deflection, see CondensedModel::Liftoff.
class TyreContact {
 public:
  /// All must outlive this object.
  TyreContact(const std::vector<CondensedModel::Liftoff>& tyres, const LinearisedCycle& cycle);

  /// Whether no tyre pulls in the cycle's last solution, also between samples. May be false if one nearly does. Cheap
  /// if forces stay well above zero.
  bool Presses() const;

  /// (H + 1) x tyres, of the last solution: harmonics of the deflections [m].
  Eigen::MatrixXcd Squeezes() const;

  /// Least force of each tyre over a cycle of these deflections [N], at the samples.
  std::vector<double> LeastForces(const Eigen::MatrixXcd& squeezes) const;

 private:
  bool PressesByFirstHarmonic() const;
  Eigen::VectorXcd ForcesOf(std::size_t tyre, const Eigen::VectorXcd& squeeze) const;
  std::complex<double> PostShare(std::size_t tyre) const;

  const std::vector<CondensedModel::Liftoff>& tyres_;
  const LinearisedCycle& cycle_;
  /// Tyres x ports: force of the mean per tension [1].
  Eigen::MatrixXd mean_gain_;
  /// Tyres x poles of the receptance, see Receptance::ModalSizes.
  Eigen::MatrixXd modal_sizes_;
};

}  // namespace fourpost
