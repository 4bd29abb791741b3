#pragma once

#include "analysis/text/finding.h"
#include "identify/uncertainty/derivative_noise.h"

// What limits what is known of a fitted model, by itself and among others.
namespace fourpost {

inline const Finding kDerivativeNoise{"derivative-noise", Severity::kWarning,
                                      "the derivative with respect to {} is noise", kNoiseRemedy};

// Ranking of models.

inline const Finding kRankedAlone{"ranked-alone", Severity::kWarning, "only one run was given",
                                  "fit other models to the same recordings for a comparison"};
inline const Finding kRankedInterrupted{
    "ranked-interrupted", Severity::kWarning,
    "the fit of {} was interrupted, so its errors may be larger than those of the model",
    "let it end before you judge the model"};
inline const Finding kRankedNotConverged{
    "ranked-not-converged", Severity::kWarning,
    "the fit of {} did not converge, so its errors may be larger than those of the model",
    "let it converge before you judge the model"};
inline const Finding kRankedUnexplained{"ranked-unexplained", Severity::kWarning,
                                        "{} does not explain the data that it was fitted to",
                                        "see its report for the reasons"};

}  // namespace fourpost
