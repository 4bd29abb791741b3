#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/deadline.h"
#include "identify/experiments/kinematics/kinematic_sweep.h"

namespace fourpost {

/// What a vehicle does on a rig.
struct KinematicAnswer {
  /// Of each sweep and curve its points, SI.
  std::vector<std::vector<Eigen::VectorXd>> sweeps;
  /// The first thing that the vehicle cannot do; the answer ends there.
  struct Refusal {
    enum class Kind { kNotReached, kRigid, kNotThere };
    Kind kind = Kind::kNotReached;
    std::size_t sweep = 0;
    /// Travel that is not reached [m].
    double position = 0;
    const KinematicCurve* curve = nullptr;
  };
  std::optional<Refusal> refusal;
};

/// In full geometry, with points where `values` have them. Compliance is that of the design pose, proportional to the
/// load. Throws FaultyInput if the vehicle cannot be assembled or held, and TimedOut.
KinematicAnswer AnswerKinematics(const Vehicle& vehicle, std::span<const KinematicSweep> sweeps,
                                 const std::vector<double>& values, const Deadline& deadline = {});

/// What was measured less the model: the offset that fits a curve best, where it has one; else 0.
double FittedOffset(const KinematicCurve& curve, const Eigen::VectorXd& modelled);

}  // namespace fourpost
