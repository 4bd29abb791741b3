#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "identify/fit/fit.h"
#include "identify/study/loaded_study.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The vehicle, its fitted parameters stating where their values come from, without priors; values as in its file.
Vehicle WithSources(const LoadedStudy& loaded, std::uint64_t seed, const FitResult& fit);

/// Values of the file, as those of parts on their benches, and fitted ones side by side; SI. Comma-separated, one row
/// per parameter. `confidence`: of the intervals, "95 %".
std::string ParametersCsv(const Vehicle& vehicle, const std::vector<FittedParameter>& parameters,
                          const std::string& confidence);

/// `starts`: by name, SI; in place of where these parameters started.
void CallStarts(const std::map<std::string, double>& starts, FitResult& fit);

}  // namespace fourpost
