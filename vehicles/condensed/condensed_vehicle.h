#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condensed_body.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/preload_map.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/loops/link_motion.h"

namespace fourpost {

struct IdleElement;

/// Geometry of a vehicle about its design pose, computed once from its multibody system. A reduced model for other
/// masses, inertias, rates and laws then costs microseconds and no Simbody call.
///
/// Preloads follow from equilibrium, see PreloadMap. If forces alone determine them, all matrices are linear in masses,
/// inertias and rates:
///   mass      = sum over links of m J'J + W' I W,
///   stiffness = sum k b b' (b = dL/ds) + preloads times the second derivatives of their lengths
///               + sum m g times the second derivatives of the heights of the centres of mass.
/// L is the length of a spring, minus the height of a tyre's foot or its position on the platform, a displacement or
/// turn of a bushing, the difference of an anti-roll bar's two lines. Springs count with their rate in the design pose;
/// the nonlinear parts of their laws are kept separately. Immutable after construction; one object serves any number of
/// threads.
class CondensedVehicle {
 public:
  /// Throws FaultyInput if the loops cannot be assembled, if nothing can move, or if weights and given preloads have no
  /// static equilibrium in the design pose, at the file's values or within the bounds of its parameters (names the
  /// elements).
  explicit CondensedVehicle(const Vehicle& vehicle);

  /// Degrees of freedom.
  int size() const { return size_; }

  /// The vehicle that this model reduces.
  const Vehicle& vehicle() const { return vehicle_; }

  /// `parameters`: SI, in the order of Vehicle::parameters. Here and below, any other number of them throws
  /// std::invalid_argument.
  CondensedModel At(std::span<const double> parameters) const;

  Preloads PreloadsAt(std::span<const double> parameters) const;

  /// Of all links but the ground, at these values.
  std::vector<LinkMotion> LinkMotions(std::span<const double> parameters) const;

 private:
  /// An element that carries a force in the design pose: a spring, a tyre in the vertical, a translation of a bushing.
  struct Held {
    std::string element;
    int source_line = 0;
    DesignShape shape;
    std::optional<Scalar> preload;
    /// Instead of a preload: the law has no tension at this length.
    std::optional<Scalar> free_length;
    SpringDescription law;
    /// Index among the preloads that equilibrium sets; -1 for a given one.
    int unknown = -1;

    bool IsGiven() const { return preload || free_length; }
    double GivenAt(std::span<const double> parameters) const;
    std::vector<int> Parameters() const;
  };
  /// A linear spring-damper along `direction`, unloaded in the design pose.
  struct Bond {
    Scalar stiffness;
    Scalar damping;
    /// Adds damping = loss_time stiffness [s].
    Scalar loss_time;
    Eigen::VectorXd direction;
  };

  void AddBonds(const Kinematics& pose);
  std::vector<IdleElement> IdleElements(std::span<const double> parameters) const;
  void SolvePreloads();
  Eigen::VectorXd HolderRates(std::span<const double> parameters) const;
  double PreloadOf(const Held& element, const Eigen::VectorXd& held, std::span<const double> parameters) const;
  Eigen::VectorXd GivenForces(std::span<const double> parameters) const;
  void AddSprings(std::span<const double> parameters, CondensedModel& model) const;
  void AddTyres(std::span<const double> parameters, CondensedModel& model) const;
  std::vector<int> LoadCellsUnder(std::size_t tyre) const;
  void AddDashpots(std::span<const double> parameters, CondensedModel& model) const;
  void AddHydraulic(const Damper& damper, const Eigen::VectorXd& direction, std::span<const double> parameters,
                    CondensedModel& model) const;
  void AddLoadCells(std::span<const double> parameters, CondensedModel& model) const;

  Vehicle vehicle_;
  int size_ = 0;
  std::vector<CondensedBody> bodies_;
  /// Springs, tyres (minus the height of the foot), then three translations of each bushing.
  std::vector<Held> held_;
  std::vector<Bond> bonds_;
  std::vector<Eigen::VectorXd> damper_directions_;
  /// See CondensedModel.
  Eigen::MatrixXd actuators_;
  std::vector<int> post_of_tyre_;
  /// Number of preloads that equilibrium sets.
  int holders_ = 0;
  /// Maps given forces and rates to the preloads that equilibrium sets.
  PreloadMap preload_map_;
  /// Sensor rows that do not depend on parameters.
  CondensedModel sensors_;
};

}  // namespace fourpost
