#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/response/harmonic_balance_options.h"
#include "vehicles/response/port_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {

/// One cycle of a reduced vehicle at one frequency, by the method of SolveHarmonicBalance; keeps its memory from one
/// frequency to the next. Harmonics are those of y(t) = Re sum_h Y_h exp(i h w t).
class LinearisedCycle {
 public:
  /// `shape`: of the posts, see Excitation. `ports`: PortsOf() the model, or HeldPortsOf() it, with tyres that pull.
  /// The model must outlive this object.
  LinearisedCycle(const CondensedModel& model, const std::vector<double>& shape, const HarmonicBalanceOptions& options,
                  std::vector<Port> ports);

  /// Whether the iteration converged and more harmonics would make no significant change. A vehicle with nonlinear
  /// springs or tyres may have several solutions: the one next to the previous frequency is taken, or with `start` the
  /// one next to these harmonics of the ports' extensions.
  bool Solve(double frequency_Hz, double amplitude_m, const Eigen::MatrixXcd& start = {});

  /// Solves again from the last solution, with as many harmonics, under additional forces: `added` has the harmonics of
  /// the motion [s x] that they would cause in the linear vehicle, (any number) x size. Returns whether it converged.
  bool SolveWith(const Eigen::MatrixXcd& added);

  // For the last solution.

  /// Sensors x 3: mean, first and second harmonic.
  SensorHarmonics Sensors() const { return SensorsBy(cycle().remainder()); }
  /// The same if the nonlinear forces have these harmonics instead of their own.
  SensorHarmonics SensorsBy(const Eigen::MatrixXcd& remainder) const;
  /// (H + 1) x size: small motion s and extensions x of the series springs, see LinearVehicle.
  Eigen::MatrixXcd Coordinates(int harmonics) const;
  /// One harmonic of these.
  Eigen::VectorXcd CoordinatesOf(int h) const;
  /// (H + 1) x ports: harmonics of the ports' extensions.
  const Eigen::MatrixXcd& extension() const { return cycle().extension(); }
  /// (H + 1) x ports: harmonics of the nonlinear forces, and those that a transform of other samples would find; zero
  /// for laws with memory.
  const Eigen::MatrixXcd& remainder() const { return cycle().remainder(); }
  Eigen::MatrixXcd RemainderBy(const CycleTransform& transform) const { return cycle().RemainderBy(transform); }
  const std::vector<Port>& ports() const { return ports_; }
  bool has_friction() const { return has_friction_; }
  /// Motion of the linear vehicle under forces on [s x] at this frequency, harmonics in rows.
  Eigen::MatrixXcd MotionBy(const Eigen::MatrixXcd& forces) const { return receptance_.MotionBy(omega_, forces); }
  /// Its ports.
  const PortCycle& cycle() const { return *levels_[level_]; }
  double omega() const { return omega_; }
  /// Of the posts.
  const Eigen::VectorXd& shape() const { return shape_; }
  double amplitude_m() const { return amplitude_; }
  const Receptance& receptance() const { return receptance_; }
  const LinearVehicle& vehicle() const { return receptance_.vehicle(); }
  /// Of the ports, size x ports.
  const Eigen::MatrixXd& directions() const { return receptance_.directions(); }
  /// See Receptance.
  void Compliance(int harmonics, Eigen::MatrixXcd& compliance) {
    receptance_.Compliance(omega_, harmonics, compliance);
  }
  /// Counts of the last solution.
  int harmonics() const { return cycle().harmonics(); }
  /// Steps per cycle for laws with memory.
  Eigen::Index steps() const { return cycle().steps(); }
  int iterations() const { return iterations_; }

 private:
  bool SolveLevel(std::size_t level, const Eigen::MatrixXcd& start, double tolerance);
  int MostHarmonicsOf(std::size_t level) const;
  bool TrySolve(const Eigen::MatrixXcd& given = {});
  bool SolveWithFew(const Eigen::MatrixXcd& start);
  bool SolveByWayOf(const std::vector<double>& shares);
  void SetAmplitude(double amplitude_m);
  /// Sensor readings of motions [s x] in columns, each at its frequency w; the posts' direct part is separate.
  Eigen::MatrixXcd ReadingsOf(const Eigen::RowVectorXd& w, const Eigen::MatrixXcd& coordinates) const;
  void NoteUnits();
  /// Corrects the readings of the linear vehicle for the nonlinear parts of tyres' forces, on their load cells.
  void AddTyreForces(int h, const Eigen::MatrixXcd& remainder, Eigen::Ref<Eigen::VectorXcd> readings) const;
  /// Of the first harmonic: the norm of its mass-weighted motion, and the sensor readings.
  struct First {
    double motion = 0;
    Eigen::VectorXcd readings;
  };
  First FirstHarmonic() const;
  double Change(const First& before, const First& now) const;

  const CondensedModel& model_;
  Eigen::VectorXd shape_;
  HarmonicBalanceOptions options_;
  std::vector<Port> ports_;
  Receptance receptance_;
  /// Each with twice as many samples, and about twice as many harmonics, as the one before; created when needed.
  std::vector<std::unique_ptr<PortCycle>> levels_;
  std::size_t level_ = 0;
  /// Whether a solution depends on where the iteration starts.
  bool has_memory_ = false;
  bool has_friction_ = false;
  bool has_steps_ = false;
  /// Upper bound of the error after the last doubling, as a share of its change. Harmonics of a kinked force fall with
  /// their square, their effect on the motion faster: a doubling leaves an eighth to a third of the error.
  double left_ = 1;
  /// The sensors' rows on position, velocity and acceleration, stacked.
  Eigen::MatrixXd sensors_;
  /// Square roots of the masses on the diagonal, and the norms of the sensors' rows per unit of root-mass motion.
  Eigen::VectorXd root_mass_;
  Eigen::VectorXd position_norm_;
  Eigen::VectorXd velocity_norm_;
  Eigen::VectorXd acceleration_norm_;
  bool solved_before_ = false;
  double omega_ = 0;
  double amplitude_ = 0;
  Eigen::VectorXcd unit_driven_;
  /// Of the first harmonic, per unit tension of each port and per unit amplitude of the posts: [s x], and the sensor
  /// readings.
  Eigen::MatrixXcd unit_motion_;
  Eigen::MatrixXcd unit_readings_;
  /// The posts' direct part of the latter.
  Eigen::VectorXcd post_readings_;
  /// Harmonics of the ports' extensions and of [s x] due to the posts, and to added forces, in the linear vehicle.
  Eigen::MatrixXcd driven_;
  Eigen::MatrixXcd added_;
  int iterations_ = 0;
};

}  // namespace fourpost
