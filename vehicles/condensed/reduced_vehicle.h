#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_body.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/preload_map.h"
#include "vehicles/condensed/reduced_data.h"
#include "vehicles/loops/link_motion.h"

namespace fourpost {

/// A vehicle about its design pose, without its multibody system: a reduced model at other values of the parameters
/// costs microseconds.
///
/// Preloads follow from equilibrium, see PreloadMap. If forces alone determine them, all matrices are linear in masses,
/// inertias and rates, but for those of tyres that follow the load:
///   mass      = sum over links of m J'J + W' I W,
///   stiffness = sum k b b' (b = dL/ds) + preloads times the second derivatives of their lengths
///               + sum m g times the second derivatives of the heights of the centres of mass.
/// L is the length of a held element (ReducedData::Held), a turn of a bushing, the difference of an anti-roll bar's two
/// lines. Springs count with their rate in the design pose; the nonlinear parts of their laws are kept separately.
/// Immutable after construction; one object serves any number of threads.
class ReducedVehicle {
 public:
  explicit ReducedVehicle(ReducedData data);

  const ReducedData& data() const { return data_; }
  const std::vector<CondensedBody>& bodies() const { return bodies_; }
  /// n x preloads that equilibrium sets: generalised force per unit of each.
  const Eigen::MatrixXd& holders() const { return holders_; }

  /// `parameters`: SI, in the order of ReducedData::parameters. Here and below, any other number of them throws
  /// std::invalid_argument.
  CondensedModel At(std::span<const double> parameters) const;

  Preloads PreloadsAt(std::span<const double> parameters) const;

  /// Of all links but the ground, at these values.
  std::vector<LinkMotion> LinkMotions(std::span<const double> parameters) const;

 private:
  void RequireAll(std::span<const double> parameters) const;
  const TyreDescription* CurveOf(std::size_t held) const;
  HolderTangents TangentsAt(std::span<const double> parameters, const Eigen::VectorXd& preloads) const;
  Eigen::VectorXd GivenForces(std::span<const double> parameters) const;
  /// Of all held elements.
  std::vector<double> HeldPreloads(std::span<const double> parameters) const;
  void AddSprings(std::span<const double> parameters, CondensedModel& model) const;
  void AddTyres(std::span<const double> parameters, CondensedModel& model) const;
  double TyreRate(std::size_t tyre, std::span<const double> parameters, const Preloads& preloads) const;
  std::vector<int> LoadCellsUnder(std::size_t tyre) const;
  void AddDashpots(std::span<const double> parameters, CondensedModel& model) const;
  void AddHydraulic(const ReducedData::Damper& damper, std::span<const double> parameters, CondensedModel& model) const;
  void AddLoadCells(std::span<const double> parameters, CondensedModel& model) const;

  ReducedData data_;
  std::vector<CondensedBody> bodies_;
  Eigen::MatrixXd holders_;
  /// Maps given forces and rates to the preloads that equilibrium sets.
  PreloadMap preload_map_;
};

}  // namespace fourpost
