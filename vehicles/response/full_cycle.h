#pragma once

#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/lacking_forces.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/contact_cycle.h"
#include "vehicles/response/cycle_transform.h"
#include "vehicles/response/full_balance_options.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {

/// One cycle of the full multibody system at one frequency, by the method of SolveFullBalance. Harmonics are those of
/// y(t) = Re sum_h Y_h exp(i h w t), in rows; the motion is that of [s x], see LinearVehicle.
class FullCycle {
 public:
  /// `shape`: of the posts, see Excitation. All must outlive this object.
  FullCycle(Multibody& multibody, const CondensedModel& model, const std::vector<double>& shape,
            const FullBalanceOptions& options);

  /// Whether the iterations of both the linearised cycle and this one converged.
  bool Solve(double frequency_Hz, double amplitude_m);

  /// For the last solution, sensors x 3: mean, first and second harmonic. Without one, those of the linearised cycle.
  const SensorHarmonics& Sensors() const { return sensors_; }

 private:
  /// Per cycle.
  struct Sampling {
    int harmonics = 0;
    int samples = 0;
  };

  bool SolveByWayOfLess(double frequency_Hz, double amplitude_m);
  bool TryAt(double amplitude_m);
  void Take(const Sampling& sampling);
  bool DepartsFrom(const SensorHarmonics& linearised, double amplitude_m) const;
  bool Iterate();
  Eigen::MatrixXcd Departure(const Eigen::MatrixXcd& motion, bool read);
  /// Lacking force of the full system at each sample, in the columns of [s x], and, if requested, the readings of its
  /// sensors.
  void SampleCycle(const Eigen::MatrixXcd& motion, bool read);
  /// Memory of the elements that have one at each sample. Throws std::runtime_error if a hydraulic damper has none.
  void FindMemory(const Eigen::MatrixXd& position);
  /// A cycle of an element with a memory, in `stride` steps per sample.
  struct SteppedCycle {
    Eigen::Index stride = 1;
    Eigen::MatrixXd extensions;
    Eigen::MatrixXd rates;
  };
  SteppedCycle StepsOf(const Eigen::VectorXcd& extension) const;
  void FindPressures(std::size_t damper, const SteppedCycle& steps);
  void FindFriction(std::size_t friction, const SteppedCycle& steps);
  void NoteAliases(std::size_t port, const Eigen::MatrixXd& tensions);
  Eigen::VectorXcd Rates(Eigen::Index highest) const;
  LinearisedCycle& cycle() { return contact_.cycle(); }
  const LinearisedCycle& cycle() const { return contact_.cycle(); }

  Multibody& multibody_;
  const std::vector<double>& shape_;
  const FullBalanceOptions& options_;
  LackingForces full_;
  ContactCycle contact_;
  Sampling fine_;
  /// Whether that suffices.
  Sampling coarse_;
  /// For the current sampling.
  const CycleTransform* transform_ = nullptr;
  /// Of s.
  Eigen::Index coordinates_ = 0;
  /// See EnergyWeights.
  Eigen::VectorXd stiffness_;
  Eigen::VectorXd mass_;
  double omega_ = 0;
  /// (H + 1) x size: motion of the linear vehicle under the forces that linear kinematics leave out.
  Eigen::MatrixXcd added_;
  /// Samples in rows.
  Eigen::MatrixXd lacking_;
  Eigen::MatrixXd readings_;
  /// At the samples, see LackingForces::Motion.
  Eigen::MatrixXd memory_;
  /// (H + 1) x ports: error of the samples' harmonics of the tensions of elements with a memory.
  Eigen::MatrixXcd tension_aliases_;
  SensorHarmonics sensors_;
  /// Difference of the sensor readings from the full system.
  SensorHarmonics sensor_departure_;
};

}  // namespace fourpost
