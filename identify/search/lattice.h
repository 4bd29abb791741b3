#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// One parameter of the search space, discretised: lower, lower + precision, ... up to upper (parameter's SI unit).
struct LatticeAxis {
  std::string name;
  double lower = 0;
  double upper = 0;
  double precision = 0;
  /// Nothing lies between its values: a number of teeth, a place in a catalogue.
  bool discrete = false;
};

/// A chromosome: one index e = 1..ne per axis, as in the thesis. The tuple itself is the identifier: a single number
/// made of it would overflow 64 bits for the vehicles of the thesis.
using LatticePoint = std::vector<std::int64_t>;

/// Everything that is wrong with these axes, one message each; empty when they make a lattice.
std::vector<std::string> LatticeFaults(const std::vector<LatticeAxis>& axes);

/// The search space: value = lower + (e - 1) precision, e = 1..ne, ne = floor((upper - lower) / precision) + 1
/// (thesis eq. 2.1).
class Lattice {
 public:
  /// Throws std::invalid_argument with all of LatticeFaults, one per line.
  explicit Lattice(std::vector<LatticeAxis> axes);

  const std::vector<LatticeAxis>& axes() const { return axes_; }
  /// Number of parameters.
  std::size_t size() const { return axes_.size(); }
  /// ne of an axis; at least 2.
  std::int64_t count(std::size_t axis) const { return counts_[axis]; }

  bool Contains(const LatticePoint& point) const;

  /// Throws std::invalid_argument when the point is not on the lattice.
  Eigen::VectorXd Values(const LatticePoint& point) const;

  /// The values, those of discrete axes moved to the nearest one on the lattice. Throws as Nearest().
  Eigen::VectorXd RoundDiscrete(const Eigen::VectorXd& values) const;

  /// The nearest point; values beyond a bound go to the bound. Throws std::invalid_argument for a wrong size or NaN.
  LatticePoint Nearest(const Eigen::VectorXd& values) const;

 private:
  std::vector<LatticeAxis> axes_;
  std::vector<std::int64_t> counts_;
};

/// Largest difference of two points over the axes, each as a share of its axis' range: 0..1.
double LatticeDistance(const Lattice& lattice, const LatticePoint& a, const LatticePoint& b);

}  // namespace fourpost
