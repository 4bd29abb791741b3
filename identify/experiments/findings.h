#pragma once

#include "analysis/text/finding.h"

// What can be wrong with recordings, whatever they are of, and with the files of a fit's folder.
namespace fourpost {

inline const Finding kChannelLength{"channel-length", Severity::kError, "column '{}' has {} samples, the times {}",
                                    "save channels of one rate together"};
inline const Finding kFitColumnMissing{"fit-column-missing", Severity::kError, "no column '{}'", "fit again"};

inline const Finding kReleaseOfOtherKind{"release-of-other-kind", Severity::kError,
                                         "{} is no time history, and the option is for those", "leave it out"};

// What a prediction leaves that its fit has covered.

inline const Finding kSpeedsNotCovered{"speeds-not-covered", Severity::kWarning,
                                       "damper speeds are beyond those of the fit: {}",
                                       "damper laws are extrapolated there; fit a recording that is as fast"};
inline const Finding kTravelsNotCovered{
    "travels-not-covered", Severity::kWarning, "spring travels are beyond those of the fit: {}",
    "spring laws and stops are extrapolated there; fit a recording that goes as far"};
inline const Finding kLoadsNotCovered{"loads-not-covered", Severity::kWarning,
                                      "tyre loads are beyond those of the fit: {}",
                                      "tyre laws are extrapolated there; fit a recording with these loads"};
inline const Finding kFrequenciesNotCovered{"frequencies-not-covered", Severity::kWarning,
                                            "frequencies are beyond those of the fit: {}",
                                            "the model is untested there; fit a recording with these frequencies"};
inline const Finding kAmplitudesNotCovered{"amplitudes-not-covered", Severity::kWarning,
                                           "post amplitudes are beyond those of the fit: {}",
                                           "friction and damping change with amplitude; fit a recording with these"};

}  // namespace fourpost
