#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/element_lines.h"
#include "vehicles/loops/link_motion.h"

namespace fourpost {

/// A coordinate of a car by its name: motion q = shape times its amount.
struct NamedCoordinate {
  /// "pitch of link 'chassis'"
  std::string name;
  /// Whether its force is a moment [N m].
  bool is_turn = false;
  Eigen::VectorXd shape;
};

/// At one frequency of one recording: how a car with n coordinates q moved, as its sensors say, and the force that its
/// equations lack in that motion. Complex amplitudes.
struct ForceSample {
  std::size_t run = 0;
  double frequency_Hz = 0;
  /// Of the reference post.
  double amplitude_m = 0;
  /// n; [m] or [rad].
  Eigen::VectorXcd motion;
  /// Harmonics 0, 1, .. in rows, x n; those of the fitted model, without the first.
  Eigen::MatrixXcd overtones;
  /// One per post [m].
  Eigen::VectorXcd posts;
  /// n; [N] or [N m].
  Eigen::VectorXcd force;
  /// 2n x 2n: change of [Re force, Im force] by [Re motion, Im motion].
  Eigen::MatrixXd slope;
  /// n x n: inverse covariance that the sensors' noise gives to the real, and to the imaginary, part of the motion.
  Eigen::MatrixXd information;
  /// n; the motion of the fitted model, empty: it has none; and for it, 2n x free parameters: change of
  /// [Re force, Im force] by one standard deviation of each.
  Eigen::VectorXcd modelled;
  Eigen::MatrixXd by_parameters;
  /// 2n x (what may be off): change of [Re force, Im force] by one standard deviation of a free parameter or of what a
  /// good rig may be off by.
  Eigen::MatrixXd nuisance;

  double omega() const;
};

struct ForceRecord {
  /// Recordings.
  std::vector<std::string> runs;
  std::vector<NamedCoordinate> coordinates;
  std::vector<ElementLine> lines;
  std::vector<LinkMotion> links;
  /// In the order of frequencies within each recording.
  std::vector<ForceSample> samples;
  /// For each recording, motions that its sensors do not determine, by name.
  std::vector<std::vector<std::string>> not_measured;
};

/// Per metre of the reference post, no coordinate moves by more: what a motion is known to when no sensor sees it.
inline constexpr double kMostMotion = 10;
/// Standard deviation per metre of the reference post beyond which a motion counts as not measured.
inline constexpr double kNotMeasured = 1;

/// Covariance of the real part of a sample's motion.
Eigen::MatrixXd MotionCovariance(const ForceSample& sample);

/// Orthonormal columns: motions of a sample that no sensor determines.
Eigen::MatrixXd UnmeasuredMotion(const ForceSample& sample);

/// Extension of a line in a sample [m].
std::complex<double> ExtensionOf(const ElementLine& line, const ForceSample& sample);

}  // namespace fourpost
