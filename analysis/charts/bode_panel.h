#pragma once

#include <complex>
#include <string>
#include <vector>

#include "analysis/charts/chart_axis.h"
#include "analysis/charts/svg_chart.h"

namespace fourpost {

// Gain and phase of frequency responses as series and axes of SvgPanel.

/// Gain [dB].
SvgSeries GainSeries(const std::vector<double>& frequency_Hz, const std::vector<std::complex<double>>& response,
                     const SvgStyle& style);

/// Phase [deg] as a curve on a cylinder, cut open at the edges of PhaseAxis: it is drawn once for each turn that shows,
/// so that it leaves at one edge and comes back at the other, and two curves are always next to each other.
SvgSeries PhaseSeries(const std::vector<double>& frequency_Hz, const std::vector<std::complex<double>>& response,
                      const SvgStyle& style);

/// Logarithmic, with a margin for dots at the ends.
ChartAxis FrequencyAxis(double lowest_Hz, double highest_Hz);

/// One for all panels, so that they compare; at most 80 dB down from the largest gain.
ChartAxis GainAxis(const std::vector<SvgPanel>& panels);

/// From -180 to 180 and somewhat more.
ChartAxis PhaseAxis();

/// What to say of the gains of a channel of this unit, "gain re 1 N/m": responses are per metre of the post; those of
/// displacements and accelerations are plain ratios and need no word.
std::string GainReference(const std::string& unit);

}  // namespace fourpost
