#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/condensed/port.h"

namespace fourpost {

/// Response of a linear vehicle to unit forces at its nonlinear elements and to unit motion of the posts, at any
/// frequency:
///   [s x](w) = Z(w)^-1 (-P f + (K_post + i w C_post) shape a),   e = P' [s x] + share a
/// P: directions of the elements, f: their tensions, a: amplitude of the posts, share: of each element's own post.
///
/// Uses the poles of the state matrix, so that a frequency costs a sum over them instead of a factorisation:
///   Z^-1 = sum over poles of u_k w_k' / (i w - l_k).
/// Factorises instead if two poles are so close that their shapes no longer span all motion.
class Receptance {
 public:
  /// Held ones do not move: forces at the elements move the series springs alone, and only Ports() may be asked for.
  enum class Coordinates { kFree, kHeld };

  /// `shape`: of the posts, see Excitation.
  Receptance(const CondensedModel& model, const std::vector<Port>& ports, const std::vector<double>& shape,
             Coordinates coordinates = Coordinates::kFree);

  /// Of harmonics 0..H of `omega`: (H + 1) x ports^2, column i + ports j: - P_i' Z^-1 P_j, extension of port i per
  /// tension of port j.
  void Ports(double omega, int harmonics, Eigen::MatrixXcd& receptance) const;

  /// [s x] per unit tension of each port, and per unit amplitude of the posts: size x (ports + 1).
  Eigen::MatrixXcd UnitMotions(double omega) const;

  /// Number of poles in the upper half plane and on the real axis; 0 if poles are not used.
  Eigen::Index pole_count() const { return poles_ ? poles_->values.size() : 0; }

  /// |row u_k| of each pole k, rows x poles. `rows`: n x size.
  Eigen::MatrixXd ModalSizes(const Eigen::MatrixXd& rows) const;

  /// A bound of y = row [s x] caused by tensions. `sizes`: amplitudes of their harmonics 0, 1, .. of `omega`, in rows,
  /// x ports. The amplitudes of all harmonics of y from the second on add up to at most ModalSizes(row) times the first
  /// column, those of y' to that times the second. Poles x 2.
  Eigen::MatrixX2d ModalReach(double omega, const Eigen::MatrixXd& sizes) const;

  /// Extensions of the ports per unit amplitude of the posts, for this motion of [s x].
  Eigen::VectorXcd Driven(const Eigen::VectorXcd& motion) const;

  /// [s x] at one frequency, for these tensions of the ports and this amplitude of the posts.
  Eigen::VectorXcd Motion(double omega, const Eigen::VectorXcd& tensions, double post_amplitude) const;

  /// Of [s x].
  Eigen::Index size() const { return vehicle_.size(); }

  /// [s x] of harmonics 0, 1, .. of `omega` under forces on it, in rows.
  Eigen::MatrixXcd MotionBy(double omega, const Eigen::MatrixXcd& forces) const;

  /// Z^-1 of harmonics 0..H of `omega`: (H + 1) x size^2, column i + size j. The first call costs more.
  void Compliance(double omega, int harmonics, Eigen::MatrixXcd& compliance);

  const LinearVehicle& vehicle() const { return vehicle_; }

  /// Of the ports, size x ports.
  const Eigen::MatrixXd& directions() const { return directions_; }

  /// Whether poles are used.
  bool by_poles() const { return poles_.has_value(); }

 private:
  /// Poles of upper half plane and real axis. The sum of a pole a / (i w - l) and its conjugate is
  /// g (i w alpha + beta), g = 1 / (|l|^2 - w^2 - 2 i w Re l), alpha = 2 Re a, beta = -2 Re(a conj l); of a real pole
  /// g = 1 / (i w - l), alpha = 0, beta = a.
  struct Poles {
    Eigen::VectorXcd values;
    /// size x poles, of [s x]; poles x (ports, posts' heights, posts' velocities).
    Eigen::MatrixXcd shapes;
    Eigen::MatrixXcd inputs;
    /// Amplitudes of the inputs at the ports.
    Eigen::MatrixXd input_sizes;
    /// 2 poles x ports^2, 2 poles x size (ports + 2): alpha, beta of Ports() and of the motion per unit input.
    Eigen::MatrixXd residues;
    Eigen::MatrixXd motion_residues;
  };

  void HeldPorts(double omega, Eigen::MatrixXcd& receptance) const;
  std::optional<Poles> FindPoles() const;
  static Eigen::MatrixXd ResiduesOf(const Poles& poles, const Eigen::MatrixXcd& shapes, Eigen::Index inputs);
  bool Reproduces(const Poles& poles) const;
  Eigen::MatrixXd ComplianceResidues() const;
  bool Inverts(const Eigen::MatrixXd& residues) const;
  /// Of harmonics `first`..`last`, in rows.
  void SumResidues(double omega, int first, int last, const Eigen::MatrixXd& residues, Eigen::MatrixXcd& sum) const;
  static Eigen::VectorXcd SumOverPoles(const Poles& poles, double omega, const Eigen::VectorXcd& inputs);
  Eigen::VectorXcd Inputs(double omega, const Eigen::VectorXcd& tensions, double post_amplitude) const;

  LinearVehicle vehicle_;
  Coordinates coordinates_;
  Eigen::MatrixXd directions_;
  Eigen::VectorXd post_share_;
  /// size x (ports, 1, 1): forces on [s x] per unit tension, post height and post velocity.
  Eigen::MatrixXd forces_;
  std::optional<Poles> poles_;
  /// 2 poles x size^2: alpha, beta of Z^-1, once requested; empty if poles are not used.
  std::optional<Eigen::MatrixXd> compliance_residues_;
};

}  // namespace fourpost
