#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "analysis/process/work_hooks.h"
#include "identify/experiments/experiment.h"
#include "identify/study/study.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A fit's vehicle, and the study that it was fitted by.
struct FittedRun {
  std::filesystem::path folder;
  Vehicle vehicle;
  Study study;
};

/// Of the folder of a fit. Throws FaultyInput.
FittedRun LoadFittedRun(const std::filesystem::path& folder);

/// How the vehicle predicts another recording of a kind that the study has, with bands where the run has a covariance;
/// `run` and `spread` of the request are filled in. Nothing where it was interrupted. Throws FaultyInput.
std::optional<ExperimentResults> PredictRecording(const FittedRun& run, PredictionRequest request,
                                                  const WorkHooks& hooks);

/// See schema/predict.json. `beside`: more keys, such as those of a load that was added.
std::string PredictionJson(const FittedRun& run, const std::filesystem::path& recording,
                           const nlohmann::ordered_json& beside, const ExperimentResults& results);

}  // namespace fourpost
