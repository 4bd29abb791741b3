#pragma once

#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

/// How a model that is compared with recordings balances harmonics: nine of them wherever no law takes a step. A fit
/// differentiates, and more harmonics at one point than at the next would look like a slope. They leave 7e-4 of a
/// response at the most, 2e-4 in the mean; the iteration's own error has to be small against that.
inline constexpr HarmonicBalanceOptions kFitBalance{.error = 1e9, .tolerance = 1e-6};

}  // namespace fourpost
