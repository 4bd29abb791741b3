#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "identify/audit/audit_subject.h"
#include "identify/experiments/subject.h"

namespace fourpost {

/// A vehicle as an audit sees it, and what experiments add of their recordings.
class AuditedVehicle {
 public:
  /// Throws FaultyInput when the vehicle cannot be assembled or held.
  explicit AuditedVehicle(const Subject& subject);

  const Vehicle& vehicle() const { return vehicle_; }

  /// A recording without any reading: posts at rest, sensors and load cells absent.
  AuditedRun Blank(std::string name, std::vector<double> frequency_Hz) const;

  /// Puts a sensor's reading of one frequency into a run: accelerations over the square of the frequency and lengths
  /// per metre of the reference post, turn rates and forces per metre. `sd`: of a real part. Posts come first, since
  /// load cells feel wheelpans.
  void Put(AuditedRun& run, std::size_t sensor, std::size_t frequency, std::complex<double> reading, double sd);

  /// `amplitude_m`: of the reference post. Forces at which a tyre would pull are left out: where it lifts off, force
  /// and squeeze are no longer proportional. Not where it would at most frequencies, which is a matter of scale.
  void Add(AuditedRun run, const std::vector<double>& amplitude_m);
  /// At rest, of one tyre after the other.
  void AddLoad(double load, double sd);

  const AuditSubject& audited() const { return audited_; }

 private:
  void AddSensors(const Subject& subject);
  void AddTyres();
  void AddInertia(const Subject& subject);
  void AddWheelpans();

  const Vehicle& vehicle_;
  CondensedModel model_;
  AuditSubject audited_;
  /// Of each sensor of the vehicle its place among the audited ones, or its tyre; -1: neither.
  std::vector<int> place_of_sensor_;
  /// Of each sensor of the vehicle, as AuditedTyre::wheelpan_slope.
  std::vector<Eigen::VectorXd> wheelpan_slopes_;
  /// Of the loads so far.
  AuditedWeight weight_;
  std::size_t loads_ = 0;
};

}  // namespace fourpost
