#pragma once

#include <string>
#include <vector>

#include "identify/fit.h"
#include "identify/loaded_study.h"
#include "identify/misfit.h"

namespace fourpost {

/// The outcome of a fit as JSON text; numbers in SI, null where the data do not determine a deviation.
/// `seed`: that of the search.
std::string ResultJson(const LoadedStudy& study, std::uint64_t seed, const FitResult& fit,
                       const std::vector<ChannelMisfit>& misfits);

}  // namespace fourpost
