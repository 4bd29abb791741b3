#pragma once

#include <functional>

#include <Eigen/Core>

namespace fourpost {

/// Directions are exact to rounding: projections leave about 1e-15 of them. A motion that nothing holds leaves a share
/// set by the geometry, centimetres in metres at the least.
inline constexpr double kHeldShare = 1e-9;

/// Rates k of what holds, one per preload, and where they follow the preloads p the slack of each, p - k l: the preload
/// at which the tangent of its length l(p) is zero. Empty: lengths are p / k.
struct HolderTangents {
  Eigen::VectorXd rates;
  Eigen::VectorXd slack;
};

/// The preloads p that equilibrium sets: of all that hold a generalised force w, H p + w = 0, those of least strain
/// energy, sum of p_i^2 / (2 k_i), or of the integral of l_i where the length l_i is not p_i / k_i, as of a tyre. On a
/// statically indeterminate car, springs and tyres thus share the load by their rates k, as after lowering the unloaded
/// car onto them: lateral load transfer follows roll stiffness.
///   p = p_0 - N (N' C N)^-1 N' C (p_0 - slack),  p_0 = -H^+ w,  C = diag(1 / k),  N: preloads that balance each other,
///   H N = 0.
class PreloadMap {
 public:
  PreloadMap() = default;
  /// `holders`: H, generalised force per unit of each preload, in columns; there may be none.
  explicit PreloadMap(const Eigen::MatrixXd& holders);

  /// Whether forces alone determine the preloads, for any rates.
  bool IsDeterminate() const { return redundant_.cols() == 0; }

  /// `rates`: not negative, one per preload; a preload without rate takes only what no other can.
  Eigen::VectorXd At(const Eigen::VectorXd& force, const Eigen::VectorXd& rates) const {
    return At(force, {rates, {}});
  }

  /// By Newton's method where rates follow the preloads; `tangents` at any preloads.
  Eigen::VectorXd At(const Eigen::VectorXd& force,
                     const std::function<HolderTangents(const Eigen::VectorXd&)>& tangents) const;

 private:
  Eigen::VectorXd At(const Eigen::VectorXd& force, const HolderTangents& tangents) const;

  /// -H^+.
  Eigen::MatrixXd least_;
  /// N, orthonormal.
  Eigen::MatrixXd redundant_;
};

}  // namespace fourpost
