#pragma once

#include <string>
#include <vector>

#include "identify/fit.h"
#include "identify/fit_verdict.h"
#include "identify/loaded_study.h"
#include "identify/misfit.h"

namespace fourpost {

/// The outcome of a fit as JSON text; numbers in SI. A deviation is null where a parameter has none, its `state` says
/// why; `identifiability` is with all deviations when the fit ended before they could be computed. A parameter has a
/// `prior` when its vehicle file gives it one. `seed`: that of the search; `tyre_loads`: at rest, one per tyre of the
/// vehicle [N]; `warnings`: what the fit told of its inputs and of what they leave (WarningTexts).
std::string ResultJson(const LoadedStudy& study, std::uint64_t seed, const FitResult& fit, const Misfits& misfits,
                       const FitVerdict& verdict, const std::vector<std::string>& warnings);

}  // namespace fourpost
