#pragma once

#include <complex>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/condensed/port.h"
#include "vehicles/condensed/receptance.h"
#include "vehicles/response/port_cycle.h"

namespace fourpost {

/// The force that a reduced vehicle needs, beside those of its own elements and posts, to move in a given periodic way:
///   F = mass s'' + damping s' + stiffness s + sum of element forces - posts
/// at the first harmonic. Nonlinear elements are evaluated over the cycle, as harmonic balance does; extensions of
/// series springs follow from the balance of spring and dashpot.
class NeededForce {
 public:
  /// `shape`: of the posts, see Excitation. The model must outlive this object.
  NeededForce(const CondensedModel& model, const std::vector<double>& shape);
  NeededForce(const NeededForce&) = delete;
  NeededForce& operator=(const NeededForce&) = delete;

  /// Harmonics of the motion that count.
  static constexpr int kHarmonics = 17;

  /// `motion`: harmonics 0, 1, .. of s in rows; any number of them, the others are zero. `posts`: complex amplitude of
  /// the reference post [m]. Empty where a series damper has no periodic motion.
  std::optional<Eigen::VectorXcd> At(double frequency_Hz, std::complex<double> posts, const Eigen::MatrixXcd& motion) {
    return At(frequency_Hz, posts, motion, SamplesFor(frequency_Hz, posts, motion));
  }
  /// With as many samples per cycle as for another motion or model: so that differences are not those of sampling.
  /// `start`: Yielded() of a motion or a model next to this one; that of other ports does not count.
  std::optional<Eigen::VectorXcd> At(double frequency_Hz, std::complex<double> posts, const Eigen::MatrixXcd& motion,
                                     int samples, const Eigen::MatrixXcd& start = {});

  /// What nonlinear forces changed in the ports' extensions in the last motion: harmonics x ports.
  const Eigen::MatrixXcd& Yielded() const { return yielded_; }

  /// 2n x 2n: change of [Re F, Im F] by [Re s, Im s] of the first harmonic, by differences of `step` [m].
  std::optional<Eigen::MatrixXd> Slope(double frequency_Hz, std::complex<double> posts, const Eigen::MatrixXcd& motion,
                                       int samples, double step);

  /// Enough that friction takes its step in more than one sample.
  int SamplesFor(double frequency_Hz, std::complex<double> posts, const Eigen::MatrixXcd& motion) const;

 private:
  /// Extensions of the ports without nonlinear forces.
  Eigen::MatrixXcd Driven(const Eigen::MatrixXcd& linear, std::complex<double> posts) const;
  /// Harmonics of the ports' nonlinear forces; none where a series damper has no periodic motion.
  const Eigen::MatrixXcd* Remainders(double omega, const Eigen::MatrixXcd& driven, int samples,
                                     const Eigen::MatrixXcd& start);
  /// Whether no two ports share a series spring: then each one's force depends on its own driven extension alone.
  static bool AreApart(const std::vector<Port>& ports, Eigen::Index series);
  std::optional<Eigen::MatrixXd> SlopeByCoordinates(double frequency_Hz, std::complex<double> posts,
                                                    const Eigen::MatrixXcd& motion, int samples, double step);
  /// Of all harmonics, for motion s, with the series springs' extensions as in the linear vehicle: [s x].
  Eigen::MatrixXcd WithSeries(double omega, const Eigen::MatrixXcd& motion) const;

  const CondensedModel& model_;
  Eigen::VectorXd shape_;
  LinearVehicle vehicle_;
  std::vector<Port> ports_;
  /// With coordinates that no force moves.
  Receptance held_;
  /// By their samples.
  std::map<int, PortCycle> cycles_;
  bool are_apart_;
  Eigen::MatrixXcd yielded_;
};

}  // namespace fourpost
