#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/port.h"
#include "vehicles/random_response/post_spectra.h"
#include "vehicles/random_response/spectral_grid.h"
#include "vehicles/random_response/statistical_gain.h"

namespace fourpost {

struct RandomOptions {
  /// Iterates until no deviation of a nonlinear element changes by more than this share, and its mean by more than this
  /// share of the deviation.
  double tolerance = 1e-4;
  int most_iterations = 100;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// A vehicle's stationary response to random posts. Amplitudes are those of the sources, frequency by frequency, per
/// sqrt(Hz): outputs x (frequencies sources), sources of a frequency side by side, as in PostSpectra.
struct RandomResponse {
  bool converged = false;
  int iterations = 0;
  /// One per nonlinear element, in the order of PortsOf().
  std::vector<PortMotion> ports;
  std::vector<StatisticalGain> gains;
  /// Of the model's sensors, and their means from the design pose.
  Eigen::MatrixXcd readings;
  Eigen::VectorXd mean_readings;
  /// Of the extensions of the model's dashpots [m].
  Eigen::MatrixXcd dashpots;
};

/// A reduced vehicle on random posts: its linear part (LinearVehicle, centre rates) is solved once at all frequencies
/// of a grid; its nonlinear elements are replaced by their StatisticalGain, which a low-rank update adds at each
/// frequency,
///   e = (I + R D)^-1 e0,   R = P' Z^-1 P,   D = diag(by_extension + i w by_rate)
/// with e0 their extensions and R their receptance without D; and their mean forces move the vehicle's mean position
/// (jacking) by its stiffness. Deviations and means are iterated to a fixed point (AndersonAcceleration). Exact for
/// linear vehicles but for the grid; an estimate for others, since their response is not normal. Immutable; one object
/// serves any number of threads.
class RandomVehicle {
 public:
  RandomVehicle(const CondensedModel& model, SpectralGrid grid);

  /// `posts`: at the grid's frequencies. Throws std::invalid_argument for another number of posts or frequencies.
  RandomResponse Solve(const PostSpectra& posts, const RandomOptions& options = {}) const;

  /// Of the linear vehicle that these gains make, one per port; means are zero. Throws as Solve() does, and for another
  /// number of gains.
  RandomResponse Respond(const PostSpectra& posts, const std::vector<StatisticalGain>& gains) const;

  const SpectralGrid& grid() const { return grid_; }
  const std::vector<Port>& ports() const { return ports_; }

 private:
  class Iteration;
  /// Largest extension of a port per unit tension of its own, and per unit of its rate's tension.
  struct Reach {
    double by_stiffness = 0;
    double by_damping = 0;
  };

  void RequireFitting(const PostSpectra& posts) const;
  Eigen::Index frequencies() const { return static_cast<Eigen::Index>(grid_.size()); }
  void SolveLinearPart(const CondensedModel& model);
  void SolveAtRest(const CondensedModel& model);
  void FindReach();

  SpectralGrid grid_;
  std::vector<Port> ports_;
  Eigen::Index sensors_ = 0;
  /// (ports + sensors + dashpots) x frequencies (ports + posts): extensions and readings per unit force of a port, as a
  /// force on [s x], and per unit height of a post.
  Eigen::MatrixXcd receptance_;
  /// (ports + sensors) x ports: the same at rest per unit mean force of a port.
  Eigen::MatrixXd at_rest_;
  std::vector<Reach> reach_;
};

}  // namespace fourpost
