#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "identify/missing_force/force_mechanism.h"

namespace fourpost {

/// As much of a mechanism as lowers the squares that are left most.
struct TriedForce {
  ForceMechanism mechanism;
  double amount = 0;
  /// Inverse variance of the amount where noise is as stated.
  double information = 0;
  /// Of the squares, less what the numbers are worth that are chosen beside the amount.
  double fall = 0;
};

/// The missing force of a record as a vector over all samples, each entry over its noise, and products with forces of
/// mechanisms in which what parameters and the rig may be off by counts as noise: a . b = a' C^-1 b, C = I + N N'.
/// Forces of one place have the same directions, so that their products are found once a place.
class WeighedForces {
 public:
  /// The record must outlive this object.
  explicit WeighedForces(const ForceRecord& record);

  /// What squares would be if nothing were missing.
  double degrees() const { return degrees_; }
  double Squares() const { return Product(rest_, rest_); }

  /// Whether free parameters can do the same in the model's own motion: then the fit has found how much of it there is.
  /// In the measured one they could multiply the whole force down to nothing together.
  bool IsFree(const ForceMechanism& mechanism);

  TriedForce Try(const ForceMechanism& mechanism);

  /// With all that was taken out before.
  void TakeOut(const ForceMechanism& mechanism);

  /// Amounts of all that were taken out, and their covariance where noise is as stated.
  std::pair<Eigen::VectorXd, Eigen::MatrixXd> Amounts() const;

  /// Number of neighbouring frequencies whose rests count as one, (1 + r) / (1 - r) of their correlation r, once this
  /// much of a mechanism is taken out: rests of a model that lacks more are smooth.
  double Correlated(const TriedForce& tried);

  /// What each sample contributes to the fall of squares by a mechanism, and to the squares that are left.
  std::vector<double> FallBySample(const TriedForce& tried);
  std::vector<double> SquaresBySample() const;

 private:
  /// The k directions of a place, real and imaginary for each sample: 2k columns a sample, and their products.
  struct Place {
    /// Of each sample.
    std::vector<Eigen::MatrixXd> columns;
    std::vector<Eigen::MatrixXd> squares;
    /// With the columns of shared_ and of free_.
    Eigen::MatrixXd shared;
    Eigen::MatrixXd free;
    /// By what was taken out, and with what is left.
    std::vector<Eigen::VectorXd> along;
    Eigen::VectorXd rest;
  };
  using PlaceKey = std::tuple<bool, bool, std::vector<std::size_t>, std::size_t>;

  Place& PlaceOf(const ForceMechanism& mechanism);
  /// Of the columns of a place in the measured or in the model's motion, real before imaginary for each sample.
  Eigen::VectorXd Amplitudes(const ForceMechanism& mechanism, const std::vector<ForceSample>& samples) const;
  Eigen::VectorXd Weighed(const ForceMechanism& mechanism);
  Eigen::VectorXd Times(const Place& place, const Eigen::VectorXd& amplitudes) const;
  Eigen::VectorXd ProductsWith(const Place& place, const Eigen::VectorXd& weighed) const;
  void FindFree();
  double Product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  /// C^-1 a.
  Eigen::VectorXd LessShared(const Eigen::VectorXd& a) const;

  const ForceRecord& record_;
  /// Its samples in the model's own motion.
  std::vector<ForceSample> own_;
  std::vector<Eigen::MatrixXd> weights_;
  Eigen::MatrixXd shared_;
  Eigen::MatrixXd free_;
  std::map<PlaceKey, Place> places_;
  /// At first, and less what was taken out.
  Eigen::VectorXd whole_;
  Eigen::VectorXd rest_;
  std::vector<Eigen::VectorXd> forces_;
  /// Of what was taken out: of length 1, at right angles.
  std::vector<Eigen::VectorXd> directions_;
  double degrees_ = 0;
};

}  // namespace fourpost
