#pragma once

#include "analysis/text/finding.h"

// What data leave open of parameters, before the search of a fit.
namespace fourpost {

inline const Finding kScaleUnidentified{
    "scale-unidentified", Severity::kError,
    "the data do not change when these parameters change together: {}; accelerations and strut motions stay the same "
    "when all masses and rates are scaled alike",
    "measure a force (tyre forces or static loads), remove a mass from `free`, or give one a prior_sd; if a force is "
    "measured already, another channel outweighs it by far, so check the units; or pass --accept-unidentified"};
inline const Finding kDirectionUnidentified{
    "direction-unidentified", Severity::kError, "the data do not change when these parameters change together: {}",
    "remove one of them from `free`, give it a prior_sd, or measure a channel or a pattern of the posts that "
    "distinguishes them; or pass --accept-unidentified"};

}  // namespace fourpost
