#pragma once

#include <optional>
#include <string>

#include "analysis/diagnostics.h"
#include "analysis/units.h"

namespace fourpost {

// Numbers on the command line. Faults are about the option: "--amplitude".

enum class Sign { kPositive, kAny };

/// SI value of "5 mm" or "5mm". An acceleration may be told in g, 9.80665 m/s^2; a frequency is in Hz, not rad/s.
/// Nothing after an error: no number of this dimension with its unit, one that is not above zero.
std::optional<double> ReadQuantity(const std::string& text, const Dimension& dimension, const std::string& option,
                                   Diagnostics& diagnostics, Sign sign = Sign::kPositive);

/// "1%" as 0.01; without % it could mean either. Nothing after an error: other text, a share not above zero or above
/// 100 %.
std::optional<double> ReadShare(const std::string& text, const std::string& option, Diagnostics& diagnostics);

/// "0.5Hz:30Hz"; nothing after an error.
struct FrequencyRange {
  double first_Hz = 0;
  double last_Hz = 0;
};
std::optional<FrequencyRange> ReadFrequencyRange(const std::string& text, const std::string& option,
                                                 Diagnostics& diagnostics);

}  // namespace fourpost
