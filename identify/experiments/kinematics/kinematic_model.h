#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/deadline.h"
#include "identify/experiments/kinematics/kinematic_sweep.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/poses/one_axle.h"

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
    /// Of what the vehicle has not.
    std::size_t curve = 0;
  };
  std::optional<Refusal> refusal;
};

/// Axles of a vehicle on a rig, in full geometry. Immutable; one object serves any number of threads.
class KinematicModel {
 public:
  /// Throws FaultyInput if the vehicle cannot be assembled or held.
  KinematicModel(const Vehicle& vehicle, std::vector<KinematicSweep> sweeps);

  const std::vector<KinematicSweep>& sweeps() const { return sweeps_; }

  /// With points where `values` have them [SI, order of Vehicle::parameters]. Compliance is that of the design pose,
  /// proportional to the load. Throws FaultyInput if the vehicle cannot be assembled or held there, and TimedOut.
  KinematicAnswer At(const std::vector<double>& values, const Deadline& deadline = {}) const;

 private:
  class Evaluation;

  Preloads PreloadsAt(const std::vector<double>& values) const;

  Vehicle vehicle_;
  std::vector<KinematicSweep> sweeps_;
  /// Of each axle that is measured what the rig needs; its place there is 0, but where nothing was left out.
  std::map<std::size_t, OneAxle> axles_;
  std::map<std::size_t, std::size_t> place_in_;
  /// Of each sweep and curve, place in AxleStation::wheels, lengths or ratios of that axle alone.
  std::vector<std::vector<std::size_t>> of_;
  /// At the points as drawn; null where parameters move them.
  std::shared_ptr<const CondensedVehicle> condensed_;
};

/// What was measured less the model: the offset that fits a curve best, where it has one; else 0.
double FittedOffset(const KinematicCurve& curve, const Eigen::VectorXd& modelled);

}  // namespace fourpost
