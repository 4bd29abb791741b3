#pragma once

#include <span>
#include <vector>

#include "vehicles/condensed/condense.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/reduced_vehicle.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/loops/link_motion.h"

namespace fourpost {

/// A vehicle with its ReducedVehicle, computed once from its multibody system. Immutable after construction; one object
/// serves any number of threads.
class CondensedVehicle {
 public:
  /// Throws as Condense().
  explicit CondensedVehicle(const Vehicle& vehicle) : vehicle_(vehicle), reduced_(Condense(vehicle)) {}

  /// Degrees of freedom.
  int size() const { return reduced_.data().coordinates; }

  /// The vehicle that this model reduces.
  const Vehicle& vehicle() const { return vehicle_; }
  const ReducedVehicle& reduced() const { return reduced_; }

  // See ReducedVehicle. `parameters`: SI, in the order of Vehicle::parameters.

  CondensedModel At(std::span<const double> parameters) const { return reduced_.At(parameters); }
  Preloads PreloadsAt(std::span<const double> parameters) const { return reduced_.PreloadsAt(parameters); }
  std::vector<LinkMotion> LinkMotions(std::span<const double> parameters) const {
    return reduced_.LinkMotions(parameters);
  }

 private:
  Vehicle vehicle_;
  ReducedVehicle reduced_;
};

}  // namespace fourpost
