#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "identify/fit/fit.h"
#include "identify/report/fit_overview.h"
#include "identify/run/fit_verdict.h"

namespace fourpost {

/// In per cent, milliseconds or newtons. `unit`: of CalibrationEstimate.
std::string InstrumentNumber(double value, const std::string& unit);

/// What `fourpost fit` prints on a terminal: tables of the parameters and of their profiles, `sections` (tables of what
/// was measured), how the fit ended, what it is worth in the words of its page (`overview`), what could be added
/// (`missing` of result.json), the least identifiable direction, and the conclusions.
std::string FitText(const FitResult& fit, const FitOverview& overview, const FitVerdict& verdict,
                    const Diagnostics& conclusions, const std::string& sections, const nlohmann::ordered_json& missing);

}  // namespace fourpost
