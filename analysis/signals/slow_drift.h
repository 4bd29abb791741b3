#pragma once

#include <optional>
#include <span>

namespace fourpost {

/// By how much a signal's level rises from begin to end of a record, as of a sensor that warms up, beside its motion;
/// nothing where that is not certain: beyond ten standard deviations of the levels' scatter and 3 % of the signal's
/// deviation. Levels are means under 19 Hann windows that overlap by half. A level that goes with the size or the rate of
/// the motion is no drift, as where a damper's two sides differ and the motion fades; where these change with time as
/// steadily as a drift would, in a sweep or a fade, nothing is certain.
std::optional<double> SlowDrift(std::span<const double> signal);

}  // namespace fourpost
