#pragma once

#include <span>

namespace fourpost {

/// What ISO 2631-1 makes of a weighted acceleration a over a duration T.
struct WeightedAcceleration {
  /// sqrt(1/T integral of a^2 dt) [m/s^2].
  double rms = 0;
  /// Maximum transient vibration value: largest running rms over a second, max over t of
  /// sqrt(1/(1 s) integral of a^2 from t - 1 s to t) [m/s^2], a = 0 before the start.
  double mtvv = 0;
  /// Vibration dose value: (integral of a^4 dt)^(1/4) [m/s^1.75].
  double vdv = 0;
  double duration_s = 0;

  /// Above these the rms understates shocks, and MTVV or VDV belongs beside it (ISO 2631-1, 6.3.3).
  static constexpr double kMostMtvv = 1.5;
  static constexpr double kMostVdv = 1.75;

  /// MTVV / rms; zero without motion.
  double MtvvRatio() const;
  /// VDV / (rms T^(1/4)); zero without motion.
  double VdvRatio() const;
  bool RmsSuffices() const { return MtvvRatio() <= kMostMtvv && VdvRatio() <= kMostVdv; }
};

/// Of a weighted acceleration's samples. The integrals are those of the cubic spline through them: for n samples per
/// period they err by the order of (2 pi / n)^4 / 100. Throws std::invalid_argument for fewer than two samples or a
/// rate that is not positive.
WeightedAcceleration MeasuresOf(std::span<const double> weighted, double rate_Hz);

/// Most likely fourth power mean of a stationary random acceleration of this rms: (3 T)^(1/4) rms, that of a normal
/// distribution [m/s^1.75].
double VibrationDoseOfRandom(double rms, double duration_s);

}  // namespace fourpost
