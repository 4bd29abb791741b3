#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "identify/search/draws.h"
#include "identify/search/population.h"
#include "identify/search/search_method.h"

namespace fourpost {

/// Settings of Cmaes.
struct CmaesOptions {
  /// Samples a generation; 0: 4 + floor(3 ln n), at least.
  int population = 0;
  /// Initial deviation, share of the range; in (0, 1].
  double deviation = 0.3;
  /// Deviations do not fall below this many steps of the lattice; in [0, 10].
  double least_steps = 0.3;
  /// Restart after this many generations without a better cost since the last restart; 0 turns it off.
  int restart_after = 20;
  /// Parameters that are positive and not discrete vary by ratios, so that a deviation is a share of ln(upper / lower).
  bool logarithmic = true;
  /// What the tutorial's rates of learning the covariance are multiplied by; in (0, 10]. They are chosen for any kind
  /// of function; smooth ones allow more.
  double learning = 1;
  /// Points drawn at random, of which the best is the mean to start from.
  int scouts = 1;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Evolution by a normal distribution that learns its covariance (CMA-ES with rank-one, rank-mu and negative updates:
/// Hansen, "The CMA Evolution Strategy: A Tutorial", arXiv:1604.00772) in the unit cube of ranges, samples rounded to
/// the lattice. Samples that leave the cube are drawn again, at last moved to its bound. Restarts elsewhere.
class Cmaes : public SearchMethod {
 public:
  /// Equal seeds give equal searches. The lattice must outlive it.
  /// Throws std::invalid_argument for options out of bounds.
  Cmaes(const Lattice& lattice, const CmaesOptions& options, std::uint64_t seed);

  const std::vector<LatticePoint>& Ask() const override { return asked_; }
  void Tell(const std::vector<Score>& scores) override;
  bool EndsGeneration() const override { return true; }
  MethodState state() const override { return state_; }

 private:
  void SetWeights();
  void Restart();
  void AskSamples();
  void Update(const std::vector<std::size_t>& order);
  void Decompose();
  void CountGain(const Score& best);
  LatticePoint Rounded(const Eigen::VectorXd& unit) const;
  Eigen::VectorXd Unit(const LatticePoint& point) const;
  // ln(upper / lower) of an axis that varies by ratios, else 0.
  double Ratio(Eigen::Index axis) const;
  // A step of the lattice here, as a share of the axis.
  double Step(Eigen::Index axis, double unit) const;
  Eigen::VectorXd Sample(Draws& draws) const;

  const Lattice* lattice_;
  CmaesOptions options_;
  std::uint64_t seed_;
  Eigen::Index n_;
  int lambda_;
  int mu_;
  Eigen::VectorXd weights_;
  double mu_eff_ = 0, c_sigma_ = 0, d_sigma_ = 0, c_c_ = 0, c_1_ = 0, c_mu_ = 0, chi_n_ = 0;

  bool scouting_ = true;
  Eigen::VectorXd mean_;
  double sigma_ = 0;
  Eigen::MatrixXd covariance_, axes_;
  Eigen::VectorXd scales_, path_sigma_, path_c_;
  int since_restart_ = 0;
  std::vector<Eigen::VectorXd> samples_;
  std::vector<LatticePoint> asked_;
  Score best_ever_, best_since_restart_;
  int since_gain_ = 0;
  int generation_ = 0;
  MethodState state_;
};

}  // namespace fourpost
