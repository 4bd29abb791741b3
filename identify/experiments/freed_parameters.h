#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/uncertainty/parameter_spread.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The free parameters of a fit among all of a vehicle.
class FreedParameters {
 public:
  FreedParameters(const ParameterSpread& spread, const Vehicle& vehicle);

  /// Whether the vehicle has them all.
  bool AreKnown() const { return places_.size() == count_; }
  /// Of one of the free parameters among all.
  std::size_t Place(Eigen::Index free) const { return places_[static_cast<std::size_t>(free)]; }
  /// All values of the vehicle's file but for these of the free ones.
  std::vector<double> AllWith(const Eigen::VectorXd& free) const;

 private:
  std::vector<double> values_;
  std::vector<std::size_t> places_;
  std::size_t count_;
};

}  // namespace fourpost
