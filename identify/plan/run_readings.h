#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/plan/experiment_design.h"
#include "identify/plan/known_parameters.h"
#include "identify/plan/rig_file.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/balance_sensitivity.h"

namespace fourpost {

/// What a car answers to a run, and its derivatives by the parameters, at the values of its file.
struct AnsweredRun {
  ResponseSensitivity sensitivity;
  std::vector<double> amplitude_m;
  /// Why there is no answer.
  std::string failure;
};

AnsweredRun AnswerTo(const RigRun& run, const CondensedVehicle& car, const KnownParameters& parameters);

/// Largest amplitude of each sensor in all runs that have an answer, in its unit. `answers`: to `rig.runs`.
Eigen::VectorXd LargestAmplitudes(const Vehicle& vehicle, const RigFile& rig, const std::vector<AnsweredRun>& answers);

/// What is read in a run, weighed as the residuals of a study are: each phasor along and across it, and mean offsets of
/// struts, which noise blurs as well.
PossibleRun ReadingsOf(const RigRun& run, const AnsweredRun& answer, const Vehicle& vehicle, const RigFile& rig,
                       const KnownParameters& parameters);

/// One number, once.
PossibleRun ReadingsOf(const DirectMeasurement& measurement, const Vehicle& vehicle, const KnownParameters& parameters);

}  // namespace fourpost
