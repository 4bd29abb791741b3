#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "analysis/text/diagnostics.h"
#include "analysis/text/found.h"

namespace fourpost {

/// So many faults of a kind are reported one by one.
inline constexpr int kMostSampleFaults = 5;

/// "0.002 s", rounded to the digits of a file.
std::string SecondsText(double time_s);

/// Differences of neighbours.
std::vector<double> StepsOf(const std::vector<double>& times);

/// The middle one of steps; where times have a digit too few, so that steps have two sizes of which none is the
/// recorder's, their mean.
double UsualStep(const std::vector<double>& steps);

/// Whether times step back more than here and there.
bool DoStepBack(const std::vector<double>& steps);

/// Of times of which most are equal to the one before.
Found FaultOfStanding(const std::vector<double>& times);

/// Of a table's evenly spaced times, [s]. Reports fewer than four, those that step back or stand, gaps, and steps that
/// add up to another rate; nothing when there was one.
std::optional<double> EvenStepOf(const RecordedTable& table, const std::vector<double>& times,
                                 Diagnostics& diagnostics);

}  // namespace fourpost
