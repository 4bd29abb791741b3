#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fourpost {

/// One pole over the values of a parameter.
struct PoleCurve {
  std::string name;
  /// [1/s], on or above the real axis; one that is not finite interrupts the curve.
  std::vector<std::complex<double>> pole;
};

/// Paths of poles in the complex plane.
struct PoleChart {
  std::string title;
  /// The parameter at the first and the last pole of each curve, and at `marked`: "20 kN/m".
  std::string first;
  std::string last;
  std::string marked_value;
  /// Index of a value that gets a mark of its own, as that of a file.
  std::optional<std::size_t> marked;
  std::vector<PoleCurve> curves;
  /// Poles farther from the origin are not shown.
  double highest_Hz = 30;
};

/// The paths as an SVG document: real part across, imaginary part up, both over 2 pi [Hz], so that the distance from
/// the origin is the undamped frequency; with lines of constant frequency and of constant damping ratio. Poles that
/// barely move are grey crosses, the others curves with a dot per value, a ring at the first and a disc at the last,
/// named at the last. Real poles much faster than all that oscillate are cut off. Throws std::invalid_argument for
/// curves of unlike lengths, and for a chart without a pole to show.
std::string PoleSvg(const PoleChart& chart);

}  // namespace fourpost
