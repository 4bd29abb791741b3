#pragma once

#include <string_view>

namespace fourpost {

/// Style and scripts of a report: bundle/report.css and bundle/report.js, which web/ makes.
extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;
/// The script that draws the vehicle, gzip in base 64, and the digest of its text in base 64.
extern const std::string_view kReportStage;
extern const std::string_view kReportStageSha256;

}  // namespace fourpost
