#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// "above" or "below": the side of zero that this value of a parameter is not on and would have to be, outside its
/// bounds: that of its present value or, where that is zero, of its range. Empty where the value is possible.
std::string MissedSideOfZero(const Parameter& parameter, double value);

/// Sets a parameter of the vehicle to another value: "k_front=40 kN/m". Adds an error for invalid text, an unknown
/// parameter, a unit of another dimension, and a value outside the parameter's bounds on a MissedSideOfZero(); a
/// warning for any other value outside. Findings name `option`: "--set".
void SetParameter(const std::string& text, const std::string& option, Vehicle& vehicle, Diagnostics& diagnostics);

/// Several of them; adds an error for a parameter that is set twice.
void SetParameters(const std::vector<std::string>& texts, Vehicle& vehicle, Diagnostics& diagnostics);

/// A parameter and the values to vary it over.
struct ParameterRange {
  /// Index in Vehicle::parameters.
  std::size_t parameter = 0;
  /// SI, in equal steps.
  std::vector<double> values;
};

/// Reads "k_front", 25 values from bound to bound, or "k_front=20kN/m:80kN/m:13". Empty after an error; findings as in
/// SetParameter.
std::optional<ParameterRange> ReadParameterRange(const std::string& text, const std::string& option,
                                                 const Vehicle& vehicle, Diagnostics& diagnostics);

/// Several of them, those without an error; adds an error for a parameter that is varied twice.
std::vector<ParameterRange> ReadParameterRanges(const std::vector<std::string>& texts, const Vehicle& vehicle,
                                                Diagnostics& diagnostics);

}  // namespace fourpost
