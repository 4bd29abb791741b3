#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// A device of a rig whose channels share a scale and a clock.
enum class Device { kAccelerometers, kStruts, kDisplacements, kGyros, kLoadCells };

/// A channel that reads the motion of a car with n coordinates q alone, whatever its masses and rates are.
struct AuditedSensor {
  std::string name;
  Device device = Device::kAccelerometers;
  /// 1 x n. Reading over what it is normalised by (acceleration: -w^2, velocity: i w, displacement: 1):
  /// (motion - tilt / w^2) q.
  Eigen::RowVectorXd motion;
  /// What an accelerometer takes of gravity.
  Eigen::RowVectorXd tilt;
  /// Change of `motion` per metre that the sensor is moved along x, y, z of the car; empty of a sensor between two
  /// points.
  std::array<Eigen::RowVectorXd, 3> motion_by_place;
};

/// A tyre on its post: force on the post = (rate + i w damping) (height of the post - foot q).
struct AuditedTyre {
  std::string name;
  /// 1 x n, height of the foot.
  Eigen::RowVectorXd foot;
  std::size_t post = 0;
  /// 1 / rate of the vehicle's file [m/N].
  double compliance = 0;
  /// Name of its load cell; empty: none.
  std::string cell;
  /// Mass between load cell and tyre in the vehicle's file [kg].
  double wheelpan = 0;
  /// Its change by each parameter of AuditedCar::reach [kg per unit]; empty: none.
  Eigen::VectorXd wheelpan_slope;
};

/// The car moves up as a whole, without any inner deformation: tyre forces balance inertia and gravity,
/// sum_t lever_t F_t = (-w^2 inertia + gravity) q. Slopes: one per parameter.
struct AuditedBalance {
  /// One per tyre.
  Eigen::VectorXd lever;
  Eigen::RowVectorXd inertia;
  Eigen::RowVectorXd gravity;
  std::vector<Eigen::RowVectorXd> inertia_slope;
  std::vector<Eigen::RowVectorXd> gravity_slope;
  /// Inertia of the car's other motions as a whole (pitch, roll): what a centre of mass that is elsewhere adds.
  std::vector<Eigen::RowVectorXd> others;
};

/// Weight of the car at rest, measured and of the vehicle's file [N].
struct AuditedWeight {
  double measured = 0;
  double sd = 0;
  double modelled = 0;
  /// One per parameter.
  Eigen::VectorXd slope;
};

/// What is known of a car without a fit.
struct AuditedCar {
  Eigen::Index coordinates = 0;
  std::vector<AuditedSensor> sensors;
  std::vector<AuditedTyre> tyres;
  std::optional<AuditedBalance> balance;
  /// How far each parameter of inertia or of wheelpans may be from its value in the vehicle's file, as a standard
  /// deviation.
  Eigen::VectorXd reach;
};

/// A recording: complex amplitudes per metre of the reference post. Absent channels are NaN.
struct AuditedRun {
  std::string name;
  std::vector<double> frequency_Hz;
  /// Posts x frequencies: heights.
  Eigen::MatrixXcd posts;
  /// Sensors x frequencies, normalised as AuditedSensor says; standard deviations of a real part.
  Eigen::MatrixXcd motions;
  Eigen::MatrixXd motion_sd;
  /// Tyres x frequencies: readings of the load cells [N/m] without the inertia of the file's wheelpans, more load
  /// positive.
  Eigen::MatrixXcd forces;
  Eigen::MatrixXd force_sd;
  /// Whether standard deviations are those of noise that was measured.
  bool is_noise_known = true;
};

struct AuditSubject {
  AuditedCar car;
  std::vector<AuditedRun> runs;
  std::optional<AuditedWeight> weight;
};

}  // namespace fourpost
