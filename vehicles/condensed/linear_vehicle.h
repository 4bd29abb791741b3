#pragma once

#include <complex>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// A reduced vehicle with linear dashpots; all other elements keep their rates in the design pose:
///   mass s'' + (damping [s' x'] + stiffness [s x])_s = forces,  (damping [s' x'] + stiffness [s x])_x = 0
/// with the n independent coordinates s and the extensions x of the series springs, which have no mass. All matrices
/// are symmetric.
struct LinearVehicle {
  enum class Rates {
    /// DashpotLaw::MeanRate: the rate for small motion.
    kMean,
    /// CondensedModel::Dashpot::CentreRate.
    kCentre,
  };

  LinearVehicle(const CondensedModel& model, Rates rates);

  /// Of s and x together.
  Eigen::Index size() const { return stiffness.rows(); }
  Eigen::Index series() const { return stiffness.rows() - mass.rows(); }

  /// stiffness + i w damping - w^2 mass, size x size.
  Eigen::MatrixXcd Impedance(double omega) const;

  /// Of [s, s', x].
  Eigen::MatrixXd StateMatrix() const;

  /// Rate of [s, s', x] by forces on s and x, in columns.
  Eigen::MatrixXd StateInput(const Eigen::MatrixXd& forces) const;

  Eigen::MatrixXd mass;       // n x n
  Eigen::MatrixXd damping;    // size x size
  Eigen::MatrixXd stiffness;  // size x size
};

/// Directions of the forces of the model's dashpots on s and x, size x dashpots: a dashpot in series acts between s and
/// x.
Eigen::MatrixXd DashpotDirections(const CondensedModel& model);

}  // namespace fourpost
