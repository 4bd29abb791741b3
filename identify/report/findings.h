#pragma once

#include "analysis/text/finding.h"

// What can be wrong with runs that are reported, compared and ranked.
namespace fourpost {

inline const Finding kResultMissing{"result-missing", Severity::kError, "result.json is missing",
                                    "give a folder that `fourpost fit` wrote"};
inline const Finding kResultNotJson{"result-not-json", Severity::kError, "not JSON that `fourpost fit` wrote",
                                    "fit again"};
inline const Finding kResultTooLarge{"result-too-large", Severity::kError, "larger than {}, so not the result of a fit",
                                     "fit again"};
inline const Finding kResultNotOfFit{"result-not-of-fit", Severity::kError, "not the result of a fit",
                                     "give a folder that `fourpost fit` wrote"};
inline const Finding kResultNotUnderstood{
    "result-not-understood", Severity::kError, "not understood, perhaps of another version of fourpost ({})",
    "run `fourpost fit` with -o on this folder again, it reuses evaluations of the archive where it can"};

inline const Finding kRunNotOfBench{
    "run-not-of-bench", Severity::kError, "not the result of a fit to bench recordings",
    "give folders that `fourpost fit` wrote for a study with 'bench', or compare these by `fourpost report RUN RUN -o "
    "FILE`"};
inline const Finding kRunOfOtherData{"run-of-other-data", Severity::kError,
                                     "fitted or validated with other recordings, or other settings for them, than {}",
                                     "rank models of the same data"};

}  // namespace fourpost
