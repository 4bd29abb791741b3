#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace fourpost {

/// Frequency weightings of acceleration: how strongly it is felt.
///   Wk  vertical, on a seat, standing or lying: ISO 2631-1
///   Wd  fore-aft and lateral, on a seat, standing or lying: ISO 2631-1
///   We  rotations of a seat [rad/s^2]: ISO 2631-1
///   Wf  motion sickness, vertical, below 0.5 Hz: ISO 2631-1
///   Wb  vertical, of trains and in British use: ISO 2631-4, BS 6841
enum class Weighting { kWk, kWd, kWe, kWf, kWb };

inline constexpr std::array kWeightings = {Weighting::kWk, Weighting::kWd, Weighting::kWe, Weighting::kWf,
                                           Weighting::kWb};

/// "Wk" ...
std::string_view WeightingName(Weighting weighting);

/// The one of this name; nothing for another.
std::optional<Weighting> WeightingNamed(std::string_view name);

/// A weighting as an analogue filter, with p = 2 pi i f and w_k = 2 pi f_k:
///   high pass   p^2 / (p^2 + sqrt(2) w1 p + w1^2)
///   low pass    1 / (1 + sqrt(2) p/w2 + (p/w2)^2)
///   transition  (1 + p/w3) / (1 + p/(Q4 w4) + (p/w4)^2)
///   step        (w5/w6)^2 (1 + p/(Q5 w5) + (p/w5)^2) / (1 + p/(Q6 w6) + (p/w6)^2)
/// Constants: ISO 2631-1:1997, annex A; of Wb: ISO 2631-4:2001 and BS 6841:1987, gain such that the step starts from
/// 0.4. At the nominal frequencies of third octaves it reproduces the tables of ISO 2631-1 to their digits.
class WeightingFilter {
 public:
  explicit WeightingFilter(Weighting weighting);

  /// W(f), f >= 0 [Hz].
  std::complex<double> Response(double frequency_Hz) const;

  /// The weighted signal at the samples: the filter's exact response to the cubic spline through them (UniformSpline),
  /// which stood at the first value before. A sine of n samples per period errs by (2 pi / n)^4 / 720 of its amplitude:
  /// 3e-5 at 30 Hz, 1.4e-3 at 80 Hz of 500 samples a second. Throws std::invalid_argument for fewer than two samples or
  /// a rate that is not positive.
  std::vector<double> Apply(std::span<const double> signal, double rate_Hz) const;

 private:
  /// (b0 + b1 q + b2 q^2) / (1 + a1 q + q^2), q = p / corner.
  struct Section {
    double corner = 0;  // 1/s
    double b0 = 0;
    double b1 = 0;
    double b2 = 0;
    double a1 = 0;
  };

  std::vector<Section> sections_;
};

}  // namespace fourpost
