#pragma once

#include <complex>
#include <string>
#include <vector>

#include "identify/missing_force/force_record.h"

namespace fourpost {

/// A missing force over the frequencies of one recording: the tension that an element along a line would have to have,
/// or the force that would have to hold a coordinate to the ground, extension and tension positive. Complex amplitudes;
/// NaN where sensors do not determine it.
struct ForceCurve {
  std::size_t run = 0;
  /// "damper 'front'", "pitch of link 'chassis'"
  std::string of;
  bool is_line = false;
  bool is_turn = false;
  std::vector<double> frequency_Hz;
  /// [N], moments [N m].
  std::vector<std::complex<double>> force;
  /// Standard deviation of a real part.
  std::vector<double> force_sd;
  /// Extension or coordinate [m], turns [rad].
  std::vector<std::complex<double>> motion;
};

/// Force in line with its motion, and with its speed: what a spring and what a damper would have.
struct ForceParts {
  double with_displacement = 0;
  double with_speed = 0;
  /// As a spring [N/m], damper [N s/m], dry friction [N] and mass [kg]; of turns per radian.
  double stiffness = 0;
  double damping = 0;
  double friction = 0;
  double mass = 0;
};
ForceParts PartsOf(const ForceCurve& curve, std::size_t i);

/// Whether each missing force has one share of it along each line: there are no more lines than coordinates.
bool AreLinesUnique(const ForceRecord& record);

/// Coordinates first, then lines, recording by recording. Forces along lines are those that come nearest to the missing
/// force, weighed by its noise, with the least sum of squares where several do.
std::vector<ForceCurve> ForceCurves(const ForceRecord& record);

}  // namespace fourpost
