#pragma once

#include <optional>
#include <string>

#include "analysis/text/diagnostics.h"
#include "analysis/text/units.h"

namespace fourpost {

// Numbers on the command line. Errors name the option: "--amplitude".

enum class OptionSign { kPositive, kAny };

/// SI value of "5 mm" or "5mm". An acceleration may be given in g, 9.80665 m/s^2; a frequency is in Hz, not rad/s.
/// Empty after an error: not a number of this dimension with its unit, or not above zero.
std::optional<double> ReadQuantity(const std::string& text, const Dimension& dimension, const std::string& option,
                                   Diagnostics& diagnostics, OptionSign sign = OptionSign::kPositive);

/// "1%" as 0.01; a number without % is ambiguous and refused. Empty after an error: other text, a share not above zero
/// or above 100 %.
std::optional<double> ReadShare(const std::string& text, const std::string& option, Diagnostics& diagnostics);

/// "0.5Hz:30Hz"; empty after an error.
struct FrequencyRange {
  double first_Hz = 0;
  double last_Hz = 0;
};
std::optional<FrequencyRange> ReadFrequencyRange(const std::string& text, const std::string& option,
                                                 Diagnostics& diagnostics);

}  // namespace fourpost
