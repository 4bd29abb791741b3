#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "identify/experiments/kinematics/kinematic_model.h"
#include "identify/residuals/error_share.h"

namespace fourpost {

/// How a vehicle follows one measured curve; SI.
struct KinematicMisfit {
  const KinematicSweep* sweep = nullptr;
  const KinematicCurve* curve = nullptr;
  Eigen::VectorXd modelled;
  /// See FittedOffset().
  double offset = 0;
  /// Root mean square of measured less modelled and offset.
  double rms = 0;
  /// Root of the residuals' squares over their number: about 1 is expected.
  double misfit = 0;
};

/// Of an answer without a refusal.
std::vector<KinematicMisfit> KinematicMisfits(std::span<const KinematicSweep> sweeps, const KinematicAnswer& answer);

/// For the terminal; empty without any.
std::string KinematicTable(std::span<const KinematicMisfit> misfits);

/// `kinematics` of result.json.
nlohmann::ordered_json KinematicJson(std::span<const KinematicMisfit> misfits);

/// A row per point: recording, axle, motion, quantity and whose it is, position, measured and modelled, the offset
/// added to the model.
std::string KinematicCsv(std::span<const KinematicMisfit> misfits);

std::vector<ErrorShare> KinematicShares(std::span<const KinematicMisfit> misfits);

}  // namespace fourpost
