#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "vehicles/condensed_model.h"
#include "vehicles/cycle_transform.h"
#include "vehicles/harmonic_balance.h"
#include "vehicles/response_recorder.h"

namespace fourpost {

/// One cycle of a condensed vehicle at one frequency, by the method of SolveHarmonicBalance; keeps its memory from one
/// frequency to the next. Harmonics are those of y(t) = Re sum_h Y_h exp(i h w t), h = 0..H in rows.
class LinearisedCycle {
 public:
  /// `shape`: of the posts, see Excitation. The model must outlive this object.
  LinearisedCycle(const CondensedModel& model, const std::vector<double>& shape, const HarmonicBalanceOptions& options);

  /// Whether the iteration converged.
  bool Solve(double frequency_Hz, double amplitude_m);

  // For the last solution.

  /// Sensors x (H + 1).
  SensorHarmonics Sensors() const;
  /// (H + 1) x n: small motion s.
  Eigen::MatrixXcd Motion() const;
  /// (H + 1) x dampers with a series spring, in file order: extension of that spring [m].
  Eigen::MatrixXcd SeriesExtensions() const;

 private:
  const CondensedModel::Dashpot& Dashpot(Eigen::Index j) const;
  void Linear();
  void Velocities(Eigen::MatrixXcd& velocity) const;
  bool Iterate();
  void Remainders();
  Eigen::VectorXcd MotionAt(int h) const;

  const CondensedModel& model_;
  Eigen::VectorXd shape_;
  HarmonicBalanceOptions options_;
  CycleTransform transform_;
  Eigen::Index dashpots_;
  Eigen::MatrixXd directions_;
  Eigen::VectorXd rates_;
  double omega_ = 0;
  Eigen::VectorXd post_height_;
  Eigen::MatrixXcd impedance_;
  Eigen::PartialPivLU<Eigen::MatrixXcd> factors_;
  std::vector<Eigen::MatrixXcd> compliance_;  // per harmonic, n x dashpots
  std::vector<Eigen::MatrixXcd> mobility_;    // per harmonic, dashpots x dashpots
  std::vector<Eigen::VectorXcd> series_share_;
  std::vector<Eigen::VectorXcd> series_leak_;
  Eigen::VectorXcd driven_;
  Eigen::MatrixXcd remainder_;
  Eigen::MatrixXcd velocity_;
  Eigen::MatrixXcd next_;
  Eigen::MatrixXd time_;
};

}  // namespace fourpost
