#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/fit/held_parameters.h"
#include "identify/refine/refine.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/uncertainty/covariance.h"
#include "identify/uncertainty/model_error_estimate.h"
#include "identify/uncertainty/residual_noise.h"

namespace fourpost {

/// What is known of an objective's calibrations at an optimum, in units of their standard deviations.
struct Calibrated {
  /// What one standard deviation of each changes in the residuals, those of priors left out, N x calibrations.
  Eigen::MatrixXd changes;
  /// Of the statement and the data together.
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  /// By what the parameters give way to the mean, n in FitVariables.
  Eigen::VectorXd step;

  /// By the statement alone.
  void TakeAsStated() {
    mean.setZero();
    covariance.setIdentity();
    step.setZero();
  }
};

/// What was fitted, in terms of one optimum, in FitVariables. `judged`: places of parameters that have a deviation.
class Optimum {
 public:
  /// `input_noise`: N x n, what noise of the inputs adds to the gradient; empty: nothing.
  Optimum(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best, const RobustLoss& loss,
          const Eigen::MatrixXd& input_noise);

  Covariance NoiseCovariance(const std::vector<Eigen::Index>& held) const;
  ModelErrorEstimate ModelError(const std::vector<Eigen::Index>& judged) const;
  /// What one standard deviation of each held parameter changes in the data's residuals.
  Eigen::MatrixXd ByHeld(const HeldParameters& held) const;
  /// judged x causes: by what the judged parameters give way to changes of the data's residuals.
  Eigen::MatrixXd MovedBy(const Eigen::MatrixXd& changes, const std::vector<Eigen::Index>& judged) const;

  /// What the data say of unknowns of unit variance that change the residuals, the judged parameters following:
  /// q = K u + e with K = (G - J D)'W (G - J D) + D'R'R D, D what the parameters give way by, e of the noise's
  /// covariance V, and the pull
  ///   q = -(G - J D)'W r + D' R' p + n
  /// with the priors' derivatives R and residuals p: -G'W r at the optimum, beside which noise of inputs may have moved
  /// the parameters; n is what that noise adds to the gradients by u and, through D, by the parameters, and its scatter
  /// is part of V. `input_noise`: of the former, N x causes; empty: nothing. With the unit variance of u
  ///   E u = P K' V^-1 q,  P = (1 + K' V^-1 K)^-1 its covariance.
  Calibrated Calibrate(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& input_noise,
                       const std::vector<Eigen::Index>& judged) const;

 private:
  Eigen::MatrixXd Hessian(const Eigen::VectorXd& weights) const;
  /// Places of causes whose changes the parameters take up but for what derivatives are off by.
  std::vector<Eigen::Index> UnseenOf(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& left) const;
  /// Covariance of sum_i G_i r_i of the noise, N x causes: over time by the residuals' own correlation; else by their
  /// stated deviations, larger where the residuals are.
  Eigen::MatrixXd ScoreOf(const Eigen::MatrixXd& changes) const;
  Eigen::MatrixXd Score() const;

  Eigen::Index data_;
  Eigen::MatrixXd jacobian_;
  Eigen::MatrixXd priors_;
  Eigen::VectorXd residuals_;
  Eigen::VectorXd prior_residuals_;
  Eigen::VectorXd weights_;
  Eigen::VectorXd curvatures_;
  Eigen::VectorXd slopes_;
  ResidualStructure structure_;
  Eigen::Index unmeasured_ = 0;
  double cost_;
  Eigen::MatrixXd input_noise_;
  ResidualNoise noise_;
  std::vector<bool> is_relative_;
};

}  // namespace fourpost
