#pragma once

#include <array>
#include <complex>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/model_change.h"
#include "vehicles/response/linearised_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {

/// Sensitivity of the harmonic balance: change of a solved cycle's harmonics with parameters of its vehicle. S are the
/// harmonics of the motion, R those of the nonlinear forces, F those of the posts' forces; Z S = F - P R at each
/// harmonic. Differentiated, for all parameters at once:
///   Z dS = dF - dZ S - P (dR at the same motion + T de),   de = P' dS
/// T: effect of the slopes of the nonlinear forces on the harmonics of a change of extensions. Solved for T de at the
/// nonlinear elements, with the harmonics that count; Z is inverted by the poles of the linear vehicle.
class BalanceChange {
 public:
  /// `shape`: of the posts, see Excitation. `model`: that of the cycle, which may hold its tyres. All except the shape
  /// must outlive this object. `error`: that of the cycle, see HarmonicBalanceOptions.
  BalanceChange(LinearisedCycle& cycle, const CondensedModel& model, const std::vector<double>& shape,
                const std::vector<ModelChange>& changes, double error);

  /// For the cycle's last solution, for posts of this amplitude [m].
  void Find(double amplitude_m);

  /// Mean, first and second harmonic of the sensors by one of the parameters, sensors x 3.
  SensorHarmonics Sensors(std::size_t change) const;

 private:
  /// Change of a law with a parameter.
  struct LawChange {
    Eigen::Index change = 0;
    const ModelChange::Law* law = nullptr;
    std::vector<PortKink> kinks;
    double per_step = 0;
  };
  /// Real and imaginary parts, each size x (H + 1).
  struct Parts {
    Eigen::MatrixXd real;
    Eigen::MatrixXd imag;
  };

  int FindHarmonics() const;
  double Feedback(int h) const;
  void AddLinearForces(double amplitude_m);
  void AddPostForces(double amplitude_m);
  void AddLawForces(double amplitude_m);
  void FindRemainder(const LawChange& law, double amplitude_m, Eigen::Index column);
  void AddTension(Eigen::Index h, const Eigen::VectorXd& direction, int port, Eigen::Index change,
                  std::complex<double> tension);
  void FindSlopes();
  void AddSlopeForces();
  void FindReadings(double amplitude_m);
  Eigen::MatrixXcd ComplianceOf(Eigen::Index h) const;

  LinearisedCycle& cycle_;
  const CondensedModel& model_;
  Eigen::VectorXd shape_;
  const std::vector<ModelChange>& changes_;
  double left_out_;
  std::vector<LawChange> laws_;
  Eigen::MatrixXcd directions_;
  /// Of each port.
  Eigen::VectorXd slope_range_;
  /// Of the last solution.
  int harmonics_ = 0;
  Parts motion_;
  Eigen::MatrixXcd compliance_;
  /// One per harmonic, size x parameters.
  std::vector<Eigen::MatrixXcd> forces_;
  /// Of the laws: samples x laws, harmonics x laws.
  Eigen::MatrixXd law_time_;
  Eigen::MatrixXcd law_harmonics_;
  /// Of the ports whose remainders have slopes: T on real, then imaginary parts of harmonics 0..H.
  std::vector<Eigen::Index> active_;
  std::vector<Eigen::MatrixXd> slopes_;
  /// Of harmonics 0, 1, 2: ports x parameters, sensors x parameters.
  std::array<Eigen::MatrixXcd, 3> tensions_;
  std::array<Eigen::MatrixXcd, 3> readings_;
};

}  // namespace fourpost
