#pragma once

#include <string>
#include <vector>

#include "identify/report/compared_run.h"

namespace fourpost {

// Tables of a comparison of runs as HTML; empty where there is nothing to show.

/// A row per run: what was fitted, how much it took and how well it went.
std::string RunTableHtml(const std::vector<ComparedRun>& runs);

/// A row per group of channels, a column per run [%]. `joined`: what recordings are whose channels are judged together.
std::string ErrorTableHtml(const std::vector<ComparedRun>& runs, std::map<ChannelGroup, double> ComparedRun::*errors,
                           const std::string& joined);

/// A row per parameter, a column per run: value and interval of 95 %, blank where a run did not fit it.
std::string ParametersSideBySideHtml(const std::vector<ComparedRun>& runs);

}  // namespace fourpost
