#pragma once

#include <Eigen/Core>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/covered_ranges.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A vehicle whose sensors are at its dampers, springs and tyres, to see how far a motion takes them.
class ProbedVehicle {
 public:
  explicit ProbedVehicle(Vehicle vehicle);

  const Vehicle& vehicle() const { return vehicle_; }

  /// Of a stepped sine: by amplitudes of the fundamental about the mean offsets.
  void AddSteady(const FrequencyResponse& response, const CondensedModel& model, CoveredRanges& ranges) const;
  /// Of a motion in time: samples x sensors.
  void AddMotion(const Eigen::MatrixXd& readings, double rate_Hz, const CondensedModel& model,
                 CoveredRanges& ranges) const;

 private:
  Vehicle vehicle_;
  Eigen::Index dampers_ = 0;
  Eigen::Index springs_ = 0;
};

}  // namespace fourpost
