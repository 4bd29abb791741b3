#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/response/harmonic_balance_options.h"
#include "vehicles/response/port_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {

/// One cycle of a condensed vehicle at one frequency, by the method of SolveHarmonicBalance; keeps its memory from one
/// frequency to the next. Harmonics are those of y(t) = Re sum_h Y_h exp(i h w t).
class LinearisedCycle {
 public:
  /// `shape`: of the posts, see Excitation. `ports`: PortsOf() the model, or HeldPortsOf() it, with tyres that pull.
  /// The model must outlive this object.
  LinearisedCycle(const CondensedModel& model, const std::vector<double>& shape, const HarmonicBalanceOptions& options,
                  std::vector<Port> ports);

  /// Whether the iteration converged and more harmonics would change nothing that matters. A vehicle whose springs or
  /// tyres are not linear may have several answers: the one next to the frequency before is taken, or with `start` the
  /// one next to these harmonics of the ports' extensions.
  bool Solve(double frequency_Hz, double amplitude_m, const Eigen::MatrixXcd& start = {});

  /// Solves again from the last solution, with as many harmonics, under more forces: `added` has the harmonics of the
  /// motion [s x] that they would cause in the linear vehicle, (any number) x size. Whether it converged.
  bool SolveWith(const Eigen::MatrixXcd& added);

  // For the last solution.

  /// Sensors x 3: mean, first and second harmonic.
  SensorHarmonics Sensors() const { return SensorsBy(cycle().remainder()); }
  /// The same where the ports' remainders have these harmonics in place of their own.
  SensorHarmonics SensorsBy(const Eigen::MatrixXcd& remainder) const;
  /// (H + 1) x size: small motion s and extensions x of the series springs, see LinearVehicle.
  Eigen::MatrixXcd Coordinates(int harmonics) const;
  /// One harmonic of these.
  Eigen::VectorXcd CoordinatesOf(int h) const;
  /// (H + 1) x ports: harmonics of the ports' extensions.
  const Eigen::MatrixXcd& extension() const { return cycle().extension(); }
  /// (H + 1) x ports: harmonics of the ports' remainders, and what a transform of other samples would find them; zero
  /// of laws with memory.
  const Eigen::MatrixXcd& remainder() const { return cycle().remainder(); }
  Eigen::MatrixXcd RemainderBy(const CycleTransform& transform) const { return cycle().RemainderBy(transform); }
  const std::vector<Port>& ports() const { return ports_; }
  /// What forces on [s x] cause in the linear vehicle at this frequency, harmonics in rows.
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
  /// What it needed.
  int harmonics() const { return cycle().harmonics(); }
  /// Steps of a cycle in which it took laws with memory through it.
  Eigen::Index steps() const { return cycle().steps(); }
  int iterations() const { return iterations_; }

 private:
  bool SolveLevel(std::size_t level, const Eigen::MatrixXcd& start, double tolerance);
  bool TrySolve(const Eigen::MatrixXcd& given = {});
  bool SolveByWayOf(const std::vector<double>& shares);
  void SetAmplitude(double amplitude_m);
  /// What the sensors read of motions [s x] in columns, each at its frequency w; the posts' own apart.
  Eigen::MatrixXcd ReadingsOf(const Eigen::RowVectorXd& w, const Eigen::MatrixXcd& coordinates) const;
  void NoteUnits();
  /// Tyres in the air press nothing: that is missing in what the linear vehicle reads.
  void AddLiftoffs(int h, const Eigen::MatrixXcd& remainder, Eigen::Ref<Eigen::VectorXcd> readings) const;
  /// Of the first harmonic: the norm of its motion by root masses, and what the sensors read.
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
  /// Each with twice as many samples, and about twice as many harmonics, as the one before; made when needed.
  std::vector<std::unique_ptr<PortCycle>> levels_;
  std::size_t level_ = 0;
  /// Whether a solution depends on where the iteration starts.
  bool has_memory_ = false;
  bool has_steps_ = false;
  /// Share of the last doubling's change that is left after it, at most. Harmonics of a kinked force fall with their
  /// square, their way back through the motion takes more: a doubling leaves an eighth to a third of the error.
  double left_ = 1;
  /// The sensors' rows on position, velocity and acceleration, one below the other.
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
  /// Of the first harmonic, per unit tension of each port and per unit amplitude of the posts: [s x], and what the
  /// sensors read.
  Eigen::MatrixXcd unit_motion_;
  Eigen::MatrixXcd unit_readings_;
  /// The posts' own share of the latter.
  Eigen::VectorXcd post_readings_;
  /// Harmonics of the ports' extensions and of [s x] that the posts, and added forces, cause in the linear vehicle.
  Eigen::MatrixXcd driven_;
  Eigen::MatrixXcd added_;
  int iterations_ = 0;
};

}  // namespace fourpost
