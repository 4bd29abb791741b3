#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "identify/residuals/residual_block.h"
#include "identify/search/evaluation.h"
#include "identify/study_file/calibration.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How far a vehicle is from the data of a study: the residuals of its blocks one after the other, then those of
/// priors: of each free parameter with a prior_sd (p - value) / prior_sd, and of each two parameters p and q that are
/// `like` each other, one of them free, (ln(p / q) - that of their values) / like_sd. Immutable; may be evaluated from
/// several threads at once.
class VehicleObjective {
 public:
  /// `free`: indices of the parameters that vary. Throws std::invalid_argument for a prior_sd that is not above zero.
  VehicleObjective(Vehicle vehicle, std::vector<std::size_t> free, std::vector<ResidualBlock> blocks,
                   std::vector<Calibration> calibrations = {});

  /// The search problem over the free parameters. The objective must outlive it.
  Problem MakeProblem() const;

  /// `values`: SI, one per free parameter. Throws TimedOut.
  Evaluation Evaluate(const Eigen::VectorXd& values, const Deadline& deadline = {}) const;

  /// d residuals / d values, N x n. To be called only where all blocks differentiate.
  Eigen::MatrixXd Jacobian(const Eigen::VectorXd& values) const;

  /// Of the blocks' coarse residuals, for a refinement's way to the minimum; nothing where no block has any, or one
  /// that takes its time has none.
  std::optional<VehicleObjective> Coarse() const;

  /// The residuals of the priors alone, with which those of Evaluate() end.
  Eigen::VectorXd PriorResiduals(const Eigen::VectorXd& values) const;

  /// All parameters of the vehicle for these values of the free ones.
  std::vector<double> AllParameters(const Eigen::VectorXd& values) const;

  /// Values of the free parameters as the vehicle file has them.
  Eigen::VectorXd FileValues() const;

  const std::vector<std::size_t>& free() const { return free_; }
  const Vehicle& vehicle() const { return vehicle_; }
  const std::vector<ResidualBlock>& blocks() const { return blocks_; }
  /// Of the instruments; blocks know what they change.
  const std::vector<Calibration>& calibrations() const { return calibrations_; }
  /// Priors included.
  Eigen::Index residual_count() const { return residual_count_; }
  /// Of these, those that are 0 whatever the values, so that no statistics count them.
  Eigen::Index unmeasured_count() const { return unmeasured_count_; }
  Eigen::Index prior_count() const { return static_cast<Eigen::Index>(priors_.size()); }

 private:
  /// What is known of one parameter, or of the ratio of one to `other`, places among all.
  struct Prior {
    std::size_t parameter = 0;
    std::optional<std::size_t> other = {};
    /// Of the parameter, or of the logarithm of the ratio.
    double value = 0;
    double sd = 0;

    double At(const std::vector<double>& all) const;
    /// Derivative of that by the parameter `index`.
    double SlopeBy(std::size_t index, const std::vector<double>& all) const;
  };

  void CollectPriors();

  Vehicle vehicle_;
  std::vector<std::size_t> free_;
  std::vector<ResidualBlock> blocks_;
  std::vector<Calibration> calibrations_;
  std::vector<Prior> priors_;
  Eigen::Index residual_count_ = 0;
  Eigen::Index unmeasured_count_ = 0;
};

}  // namespace fourpost
