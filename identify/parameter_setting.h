#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Gives a parameter of the vehicle another value: "k_front=40 kN/m". Adds an error for what is no such text, for an
/// unknown parameter, for a unit of another dimension, and for a value outside the parameter's bounds whose sign the
/// file's value has not; a warning for any other value outside. `option` is what the findings are about: "--set".
void SetParameter(const std::string& text, const std::string& option, Vehicle& vehicle, Diagnostics& diagnostics);

/// Several of them; adds an error for a parameter that is set twice.
void SetParameters(const std::vector<std::string>& texts, Vehicle& vehicle, Diagnostics& diagnostics);

/// A parameter and the values it shall go through.
struct ParameterRange {
  /// Index in Vehicle::parameters.
  std::size_t parameter = 0;
  /// SI, in equal steps.
  std::vector<double> values;
};

/// Reads "k_front", 25 values from bound to bound, or "k_front=20kN/m:80kN/m:13". Nothing after an error; findings as
/// of SetParameter.
std::optional<ParameterRange> ReadParameterRange(const std::string& text, const std::string& option,
                                                 const Vehicle& vehicle, Diagnostics& diagnostics);

/// Several of them, those without a fault; adds an error for a parameter that is varied twice.
std::vector<ParameterRange> ReadParameterRanges(const std::vector<std::string>& texts, const Vehicle& vehicle,
                                                Diagnostics& diagnostics);

}  // namespace fourpost
