#pragma once

#include <array>
#include <string_view>

namespace fourpost {

/// Whether a fitted parameter has a standard deviation and an interval, and if not, why.
enum class ParameterState {
  kNotComputed,
  kDetermined,
  /// Neither data nor a prior determine it.
  kUndetermined,
  /// A bound holds it there, not the data.
  kAtBound,
  /// Residuals jump between neighbouring values of it, so that no difference of them is a derivative.
  kNoise,
};

/// As in result.json, in the order of ParameterState.
inline constexpr std::array<std::string_view, 5> kParameterStateNames = {"not_computed", "determined", "undetermined",
                                                                         "at_bound", "noise"};

}  // namespace fourpost
