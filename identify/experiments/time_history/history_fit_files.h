#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/time_history/history_data.h"
#include "identify/residuals/history_misfit.h"

namespace fourpost {

/// Measurement and model side by side as comma-separated text: names, units, then a row per sample of each recording's
/// window; fields of signals that a recording has not are empty. Means over the window are taken away.
std::string HistoryFitCsv(const std::vector<MeasuredHistory>& histories, const std::vector<Eigen::MatrixXd>& modelled);

/// Measurement and model of a recording as an SVG document: a row of panels per signal, titled with its misfit. All of
/// the window by the least and greatest value of some hundred slices, the model by its outline; the second in which
/// most happens in its first and in its second half; and the error throughout, on the scale of the signal. `misfits`:
/// one per signal.
std::string HistoryFitSvg(const MeasuredHistory& history, const Eigen::MatrixXd& modelled,
                          const std::vector<HistoryMisfit>& misfits);

}  // namespace fourpost
