#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/condensed/port.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

class CondensedVehicle;

/// Derivatives of a reduced model by one of its parameters, by a difference: matrices are linear in most parameters and
/// smooth in all. Or its difference from another model. A matrix without rows does not change.
struct ModelChange {
  /// Change of an element's law within the difference.
  struct Law {
    /// Index among the vehicle's nonlinear elements; -1: an element that is linear without the difference.
    int port = -1;
    /// Empty: an element that is linear with the difference, and no longer a port.
    std::optional<Port> changed;
  };

  /// Of LinearVehicle with centre rates: n x n, then size x size.
  Eigen::MatrixXd mass;
  Eigen::MatrixXd damping;
  Eigen::MatrixXd stiffness;
  /// n x posts.
  Eigen::MatrixXd post_stiffness;
  Eigen::MatrixXd post_damping;
  /// sensors x n, sensors x posts.
  Eigen::MatrixXd on_position;
  Eigen::MatrixXd on_velocity;
  Eigen::MatrixXd on_acceleration;
  Eigen::MatrixXd on_post_height;
  Eigen::MatrixXd on_post_velocity;
  Eigen::MatrixXd on_post_acceleration;
  /// Those that change.
  std::vector<Law> laws;
  /// Difference of the parameter for `laws`.
  double step = 0;
};

/// Difference of a parameter at this value [SI]: small enough for what is not linear in it, and large against what a
/// model is computed to.
double DifferenceOf(const Parameter& parameter, double value);

/// A reduced vehicle at given values of its parameters, prepared to compute the change with any of them.
class ModelChanges {
 public:
  /// Both must outlive this object.
  ModelChanges(const CondensedVehicle& vehicle, std::span<const double> values);

  const CondensedModel& model() const { return model_; }

  /// Throws std::invalid_argument for an index beyond the parameters, and if a damper gains or loses its series spring
  /// with the parameter.
  ModelChange By(std::size_t parameter) const;

  /// All the way to another model, as if in one step; nothing where it has other coordinates, posts, sensors or series
  /// springs.
  std::optional<ModelChange> To(const CondensedModel& other) const;

 private:
  ModelChange To(const CondensedModel& other, const LinearVehicle& linear, double step) const;
  std::vector<ModelChange::Law> ChangedLaws(const std::vector<Port>& changed) const;

  const CondensedVehicle& vehicle_;
  std::vector<double> values_;
  CondensedModel model_;
  LinearVehicle linear_;
  std::vector<Port> ports_;
};

}  // namespace fourpost
