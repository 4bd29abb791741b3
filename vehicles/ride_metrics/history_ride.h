#pragma once

#include <span>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/ride_metrics/ride_instruments.h"
#include "vehicles/ride_metrics/ride_metrics.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// Ride metrics of a time history of the instruments' vehicle, all its sensors sampled without a filter. `model`, at
/// these values: static loads and laws. Peaks are those that occur. Rates are slopes of the splines through the
/// samples. Power of a dashpot is the mean of f(v) v at the speed of its line; of dampers in series with a spring and
/// of hydraulic ones it is NaN. Bands of ride by Welch's method. Throws std::invalid_argument for fewer than four
/// samples.
RideMetrics RideOfHistory(const RideInstruments& instruments, const CondensedModel& model,
                          std::span<const double> values, const TimeHistory& history);

}  // namespace fourpost
