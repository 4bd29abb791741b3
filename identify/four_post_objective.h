#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/frequency_response.h"
#include "identify/four_post_data.h"
#include "identify/search/evaluation.h"
#include "identify/study.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How far a vehicle is from four-post recordings, as whitened residuals:
/// - per channel, recording and frequency the difference of the complex responses, resolved along and across the
///   measured phasor: to first order the error of gain and of phase, but without a jump at 180 degrees and finite where
///   a gain passes through zero. Each is divided by the root of the measured variance plus the model error squared;
/// - mean strut offsets over the model error of means: they alone tell bump from rebound;
/// - static tyre loads over their standard deviations: they pin the common scale of masses and rates, which ratios of
///   accelerations leave open;
/// - priors, last: (p - value) / prior_sd for each free parameter that has one.
/// Immutable; may be evaluated from several threads at once.
class FourPostObjective {
 public:
  /// `free`: indices of the parameters that vary. `runs` hold only the frequencies to fit. Throws std::invalid_argument
  /// for a prior_sd that is not above zero.
  FourPostObjective(Vehicle vehicle, std::vector<MeasuredRun> runs, std::vector<MeasuredLoad> static_loads,
                    std::vector<std::size_t> free, ModelError model_error);

  /// The search problem over the free parameters. The objective must outlive it.
  Problem MakeProblem() const;

  /// `values`: SI, one per free parameter. Throws TimedOut.
  Evaluation Evaluate(const Eigen::VectorXd& values, const Deadline& deadline = {}) const;

  /// The residuals of the priors alone, with which those of Evaluate() end.
  Eigen::VectorXd PriorResiduals(const Eigen::VectorXd& values) const;

  /// All parameters of the vehicle for these values of the free ones.
  std::vector<double> AllParameters(const Eigen::VectorXd& values) const;

  const std::vector<std::size_t>& free() const { return free_; }
  const Vehicle& vehicle() const { return vehicle_; }
  const CondensedVehicle& condensed() const { return condensed_; }
  /// Priors included.
  Eigen::Index residual_count() const { return residual_count_; }
  Eigen::Index prior_count() const { return static_cast<Eigen::Index>(priors_.size()); }

 private:
  /// What is known of the value that stands at `index` of the free ones.
  struct Prior {
    Eigen::Index index = 0;
    double value = 0;
    double sd = 0;
  };

  void CollectPriors();
  void AddRun(const MeasuredRun& run, const FrequencyResponse& modelled, double*& out) const;

  Vehicle vehicle_;
  CondensedVehicle condensed_;
  std::vector<MeasuredRun> runs_;
  std::vector<MeasuredLoad> static_loads_;
  std::vector<std::size_t> free_;
  ModelError model_error_;
  std::vector<Prior> priors_;
  Eigen::Index residual_count_ = 0;
};

}  // namespace fourpost
