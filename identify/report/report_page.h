#pragma once

#include <string>

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// The report of a run as one self-contained HTML file, with what each kind of experiment shows; `run` needs a
/// result.json of `fourpost fit`. Throws FaultyInput for one that is none, naming what it is instead.
std::string ReportPage(const RunContents& run, ExperimentReports experiments);

/// Likewise what `fourpost response` finds of a study: the vehicle as its file has it beside the recordings, with a
/// slider for every parameter. `run` needs its result.json, the files beside it and a vehicle.
std::string StudyResponsePage(const RunContents& run, ExperimentReports experiments);

}  // namespace fourpost
