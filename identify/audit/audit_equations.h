#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "identify/audit/audit_subject.h"
#include "identify/audit/rig_fault.h"

namespace fourpost {

/// What coordinates are multiplied by to give a sensor's reading, 1 x n.
Eigen::RowVectorXd MotionRow(const AuditedSensor& sensor, double omega);

/// Standard deviation of the real part of a sensor's reading: of its repeats, with what a good rig may be off by from
/// one frequency to the next.
double ReadingSd(const AuditedCar& car, const AuditedRun& run, const RigTolerance& tolerance, std::size_t sensor,
                 std::size_t frequency);

/// Equations that the readings of a good rig satisfy whatever springs, dampers and friction the car has:
/// - sensors: at each frequency the readings of all sensors follow from n coordinates q;
/// - tyres: foot q = height of the post - (a + b i w - c w^2) force, with a, b, c of each tyre unknown, which is the
///   reciprocal of rate + i w damping up to its square;
/// - forces: see AuditedBalance, with masses unknown within their reach, and unknown shares of the inertia of other
///   motions, for a centre of mass that is elsewhere, and of all as w^2 grows, for parts that give way (a power unit on
///   its mounts);
/// - weight at rest: that of the same masses.
/// A load cell feels its wheelpan beside the force, of a mass that is unknown within its reach where a parameter sets
/// it. What the readings leave over, over its standard deviation, is free of q; the unknown numbers are common to all
/// recordings and frequencies.
class AuditEquations {
 public:
  /// What one entry of Misclosures() belongs to; each complex one has two.
  struct Row {
    enum class Kind { kSensor, kTyre, kBalance, kWeight, kPrior };
    Kind kind = Kind::kSensor;
    std::size_t member = 0;
    std::size_t run = 0;
    std::size_t frequency = 0;
    /// Standard deviation [as the reading].
    double sd = 0;
  };

  AuditEquations(const AuditSubject& subject, const RigTolerance& tolerance);

  /// Readings over their standard deviations, without the part that coordinates explain. Standard deviations and the
  /// part explained are those of the subject this was made of; `subject` may have other readings and places.
  Eigen::VectorXd Misclosures(const AuditSubject& subject, const Eigen::VectorXd& unknowns) const;

  Eigen::Index unknowns() const { return unknowns_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// Entries less coordinates.
  double degrees() const { return degrees_; }

 private:
  /// Of one frequency of one recording.
  struct Point {
    std::size_t run = 0;
    std::size_t frequency = 0;
    std::vector<std::size_t> sensors;
    std::vector<std::size_t> tyres;
    /// Of sensors, then tyres.
    Eigen::VectorXd sd;
    Eigen::MatrixXd shape;
    /// To coordinates, and to what they leave over, of readings over their standard deviations.
    Eigen::MatrixXd to_coordinates;
    Eigen::MatrixXd to_rest;
    /// 0 where a force is missing or the frequency is too high.
    double balance_sd = 0;
  };

  void AddPoint(const AuditSubject& subject, const RigTolerance& tolerance, std::size_t run, std::size_t frequency);
  /// `deviations`: times its transpose the covariance of coordinates.
  void AddBalance(const AuditSubject& subject, const RigTolerance& tolerance, const Eigen::MatrixXd& deviations,
                  Point& point) const;
  /// What coordinates are multiplied by, over the square of the frequency.
  Eigen::RowVectorXd BalanceRow(const Eigen::VectorXd& unknowns, double omega) const;
  void AddRows(const AuditSubject& subject);

  std::vector<Point> points_;
  std::vector<Row> rows_;
  AuditedCar car_;
  Eigen::Index unknowns_ = 0;
  double degrees_ = 0;
};

}  // namespace fourpost
