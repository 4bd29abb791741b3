#pragma once

#include <string>

#include "identify/report/run_contents.h"

namespace fourpost {

/// The report of a run as one self-contained HTML file; `run` needs a result.json of `fourpost fit`. Throws FaultyInput
/// for one that is none, naming what it is instead.
std::string ReportPage(const RunContents& run);

}  // namespace fourpost
