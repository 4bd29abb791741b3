#pragma once

#include <string_view>

namespace fourpost {

/// Style and scripts of a report: bundle/report.css and bundle/report.js, which web/ makes.
extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

}  // namespace fourpost
