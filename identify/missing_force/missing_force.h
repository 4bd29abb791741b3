#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "identify/missing_force/force_explanation.h"
#include "identify/missing_force/force_parts.h"

namespace fourpost {

/// `missing_force` of result.json: what was found, and why a recording says nothing.
nlohmann::ordered_json MissingForceJson(const ForceRecord& record, const ForceExplanations& explanations);

/// missing_force.csv: a row per recording, coordinate or line, and frequency; SI, extension and tension positive.
std::string MissingForceCsv(const ForceRecord& record, const std::vector<ForceCurve>& curves);

/// missing_force.svg: parts in line with displacement and with speed over frequency, a column per recording; along
/// lines where these are unique, else by coordinate. Empty where nothing could be determined.
std::string MissingForceSvg(const ForceRecord& record, const std::vector<ForceCurve>& curves);

/// A line per explanation for a terminal; empty without one.
std::string MissingForceText(const nlohmann::ordered_json& json);

}  // namespace fourpost
