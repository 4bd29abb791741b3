#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace fourpost {

/// Whether a fitted parameter has a standard deviation and an interval, and if not, why.
enum class ParameterState {
  kNotComputed,
  kDetermined,
  /// Neither data nor a prior determine it, its standard deviation is as large as it, see RelativeSd(), or its interval
  /// fills the range between its bounds, see FillsBounds(): they limit it then, not the data.
  kUndetermined,
  /// A bound holds it there, not the data.
  kAtBound,
  /// Residuals jump between neighbouring values of it, so that no difference of them is a derivative.
  kNoise,
};

/// As in result.json, in the order of ParameterState.
inline constexpr std::array<std::string_view, 5> kParameterStateNames = {"not_computed", "determined", "undetermined",
                                                                         "at_bound", "noise"};

/// Standard deviation as a share of the value, or of the range between bounds of either sign, whose value may be zero.
inline double RelativeSd(double sd, double value, double lower, double upper) {
  return sd / (lower < 0 && upper > 0 ? upper - lower : std::abs(value));
}

/// Above it a value is not determined.
inline constexpr double kUndeterminedShare = 1;

/// Whether an interval says next to nothing beyond the bounds. A value of which nothing is known but that it lies
/// between them, all alike, has 95 % of its probability within 95 % of the range.
inline bool FillsBounds(double from, double to, double lower, double upper) {
  constexpr double kNearlyAll = 0.9;
  return upper > lower && std::min(to, upper) - std::max(from, lower) >= kNearlyAll * (upper - lower);
}

/// At which bounds an interval was cut: its end is the bound itself, and would lie beyond; empty: at none.
inline std::string_view IntervalCutAt(double from, double to, double lower, double upper) {
  if (from == lower && to == upper) return "both bounds";
  return from == lower ? "lower bound" : to == upper ? "upper bound" : "";
}

}  // namespace fourpost
