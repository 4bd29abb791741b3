#pragma once

#include <string>

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// The report of a run as one self-contained HTML file, with what each kind of experiment shows; `run` needs a
/// result.json of `fourpost fit`. Throws FaultyInput for one that is none, naming what it is instead.
std::string ReportPage(const RunContents& run, ExperimentReports experiments);

}  // namespace fourpost
