#pragma once

#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

/// How a model that is compared with recordings balances harmonics. Few of them leave 7e-4 of a response at the most,
/// 2e-4 in the mean, with friction 2e-3 of a channel's largest; the iteration's own error has to be small against that.
inline constexpr HarmonicBalanceOptions kFitBalance{.few_harmonics = true, .tolerance = 1e-6};

}  // namespace fourpost
