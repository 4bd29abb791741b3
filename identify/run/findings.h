#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a run, and what its fit is worth.
namespace fourpost {

// The request.

inline const Finding kProfileUnknown{"profile-unknown", Severity::kError, "the study frees no parameter '{}'{}"};
inline const Finding kPostsContradictStudy{"posts-contradict-study", Severity::kError,
                                           "the recordings contradict the study",
                                           "correct what the errors name, or pass --accept-implausible"};
inline const Finding kArchiveOfOtherState{
    "archive-of-other-state", Severity::kError,
    "cannot resume, because the evaluations in {} were made with another state of: {}",
    "undo the change, or leave --resume out to start a new fit beside it"};
inline const Finding kFolderOfOtherResult{"folder-of-other-result", Severity::kError,
                                          "folder holds the results of `fourpost {}`, which would be lost",
                                          "name a new or an empty folder"};
inline const Finding kFolderOfForeignResult{
    "folder-of-foreign-result", Severity::kError,
    "folder holds a result.json that fourpost did not write, which would be lost", "name a new or an empty folder"};

// Its end.

inline const Finding kFitWithoutResults{"fit-without-results", Severity::kError, "fit {}: {} no results are written",
                                        "check the vehicle with `fourpost check`, then narrow the bounds"};
inline const Finding kFitInterrupted{"fit-interrupted", Severity::kWarning, "fit {}: {} no results are written",
                                     "the same command continues from its archive"};

inline const Finding kGrowthInterrupted{"growth-interrupted", Severity::kWarning,
                                        "growth was interrupted after step {} ({}); not done: {}",
                                        "the same command goes on there"};

// What the fit explains.

inline const Finding kModelUnexplaining{"model-unexplaining", Severity::kWarning,
                                        "this model does not explain these data: {}", "", Weight::kGrave};
inline const Finding kChannelUnexplained{"channel-unexplained", Severity::kWarning,
                                         "channel '{}' has an NMSE of {} %, worse than no model (100 %)",
                                         "check sign, scale, delay and position, then extend the model"};
inline const Finding kRecordingUnexplained{"recording-unexplained", Severity::kWarning,
                                           "recording '{}' in {} has an NMSE of {} %, worse than no model (100 %)",
                                           "check sign, scale, delay and position, then extend the model"};
inline const Finding kImplausibleUnexplained{
    "implausible-unexplained", Severity::kWarning,
    "implausible values were accepted, and residuals are {} times what noise and the stated model error explain",
    "correct what the check of the recordings names, and fit without --accept-implausible"};
inline const Finding kParametersAtBounds{
    "parameters-at-bounds", Severity::kWarning,
    "{} of {} parameters are at their bounds, and residuals are {} times what noise and the stated model error explain",
    "widen bounds that are guesses, or add the missing mechanism"};
inline const Finding kMostChannelsPoor{
    "most-channels-poor", Severity::kWarning,
    "{} of {} fitted channels have an NMSE above {} %, and residuals are {} times what noise and the stated model "
    "error "
    "explain",
    "check sign, scale, delay and position, then extend the model (`fourpost suggest`)"};

// How far its numbers can be trusted.

inline const Finding kImplausibleAccepted{
    "implausible-accepted", Severity::kWarning,
    "implausible values were accepted (--accept-implausible), and the parameters are right only if these are: {}",
    "correct the study or the recordings, and fit without the option", Weight::kGrave};
inline const Finding kFitNotConverged{"fit-not-converged", Severity::kWarning, "the refinement did not converge ({})",
                                      "fit again from the vehicle.urdf of these results", Weight::kGrave};
inline const Finding kCompromiseWithoutDeviations{
    "compromise-without-deviations", Severity::kWarning,
    "no standard deviations, because the compromise cost weights outputs by their own errors instead of noise",
    "fit by 'cost: whitened'"};
inline const Finding kEndedWithoutDeviations{"ended-without-deviations", Severity::kWarning,
                                             "the fit ended before standard deviations could be computed",
                                             "run the same command again, it continues from its archive"};
inline const Finding kDirectionUndetermined{"direction-undetermined", Severity::kWarning,
                                            "the data do not change when these parameters change together: {}",
                                            "fix one, give it a prior, or measure a force"};
inline const Finding kEndedAtBounds{"ended-at-bounds", Severity::kWarning, "parameters ended at their bounds: {}",
                                    "widen bounds that are guesses; else check zeros, signs and units of what was "
                                    "measured, or the model lacks something"};
inline const Finding kFarFromPrior{"far-from-prior", Severity::kWarning, "fitted values contradict their priors: {}",
                                   "check the prior, the scale of forces and posts, and what is held; a model that "
                                   "lacks something moves parameters as well"};
inline const Finding kWithoutEffect{"without-effect", Severity::kWarning, "the data do not change with {}",
                                    "fix it, give it a prior, or record a motion that excites its element"};
inline const Finding kIntervalFillsBounds{"interval-fills-bounds", Severity::kWarning,
                                          "intervals reach from bound to bound, so the data do not determine: {}",
                                          "widen bounds that are guesses, or measure a channel that depends on them"};
inline const Finding kHeldFillsBounds{"held-fills-bounds", Severity::kWarning,
                                      "intervals span the bounds because of held parameters: {}",
                                      "measure what is held and state its 'prior_sd'"};
inline const Finding kParameterUndetermined{"parameter-undetermined", Severity::kWarning,
                                            "the data do not change with the one free parameter",
                                            "measure a channel that depends on it"};

inline const Finding kCalibrationBeyond{
    "calibration-beyond", Severity::kWarning, "the data ask for calibrations beyond what is stated: {}",
    "check first whether the model lacks something, then these instruments, and correct their 'scale' or 'delay'"};
inline const Finding kPostNoiseImplausible{
    "post-noise-implausible", Severity::kWarning,
    "the noise of the recorded posts, as stated or estimated, would shift the parameters by more than noise can; the "
    "shift "
    "was not corrected",
    "correct the 'noise' of the posts; if it is right, the vehicle lacks something, see `fourpost suggest`"};
inline const Finding kCalibrationUnused{
    "calibration-unused", Severity::kWarning,
    "the calibrations could not be estimated from the data; the intervals use their stated standard deviations where "
    "the "
    "model can be evaluated with them",
    "check whether the vehicle lacks something, or state smaller standard deviations"};
inline const Finding kHeldLeftOut{
    "held-left-out", Severity::kWarning,
    "the intervals take these held parameters as exactly known, because they are outside their ranges or the model "
    "cannot be evaluated beside their values: {}",
    "correct their values or ranges; look at them with `fourpost check MODEL --set P=VALUE`"};
inline const Finding kRefinementsDisagree{
    "refinements-disagree", Severity::kWarning,
    "only {} of {} refinements ended in the best optimum, so a better one may exist",
    "raise 'evaluations' and 'starts' of 'search', or narrow bounds that are guesses"};
inline const Finding kOtherOptima{"other-optima", Severity::kWarning, "the data also allow {}, of cost {} beside {}",
                                  "draw about all by `fourpost draws` with --study, or measure what they differ in"};

// Draws of its parameters, and predictions.

inline const Finding kRunWithoutCovariance{"run-without-covariance", Severity::kError,
                                           "the run holds no covariance of its parameters",
                                           "fit again with this version; 'cost: compromise' gives none"};
inline const Finding kRunCovarianceDamaged{"run-covariance-damaged", Severity::kError,
                                           "the covariance in this file cannot be read",
                                           "run `fourpost fit` with -o on its folder again"};
inline const Finding kDrawsWithoutStudy{"draws-without-study", Severity::kError,
                                        "draws of the likelihood need the fitted study", "name it by --study"};
inline const Finding kDrawsOtherParameters{"draws-other-parameters", Severity::kError,
                                           "the study does not free the parameters that the run fitted",
                                           "name the study of that run"};
inline const Finding kDrawsOtherCost{"draws-other-cost", Severity::kError,
                                     "the study's cost at the fitted values is {}, the run's {}",
                                     "name the study of that run, or fit again if its files have changed"};
inline const Finding kDrawsWithoutDerivatives{"draws-without-derivatives", Severity::kError,
                                              "the model cannot be evaluated about the fitted values",
                                              "check run/vehicle.urdf with `fourpost check`"};
inline const Finding kDrawsHeld{"draws-held", Severity::kWarning,
                                "these parameters have no standard deviation and stay at their fitted values: {}",
                                "widen bounds that are guesses, give priors, or measure more"};
inline const Finding kRunFileMissing{"run-file-missing", Severity::kError, "{} is missing, which a fit writes",
                                     "run `fourpost fit` with -o on this folder again"};
inline const Finding kRecordingOfOtherKind{
    "recording-of-other-kind", Severity::kError,
    "the model was fitted to recordings of other kinds ({}), so the study maps no channels of this one",
    "give a recording of one of these kinds"};
inline const Finding kBandsWithoutParameters{
    "bands-without-parameters", Severity::kWarning, "the bands leave out parameters without a standard deviation: {}",
    "widen bounds that are guesses, give priors, or fit a recording that determines them"};
inline const Finding kDrawsCutOff{"draws-cut-off", Severity::kWarning, "ranges cut off part of the distribution of: {}",
                                  "widen ranges that are guesses", Weight::kSlight};
inline const Finding kOptimaLeftOut{"optima-left-out", Severity::kWarning,
                                    "{} within what the data allow, and all draws are about the best",
                                    "name the study by --study to draw about all"};
inline const Finding kDrawsNotNormal{"draws-not-normal", Severity::kWarning,
                                     "the likelihood is not normal: {} normal draws are worth {} after weighting",
                                     "these draws come from an ensemble sampler; expect the intervals of the fit to "
                                     "be off"};
inline const Finding kDrawsNotMixed{"draws-not-mixed", Severity::kWarning,
                                    "after {} generations the ensemble still correlates by {} with its earlier state",
                                    "allow more evaluations"};

// What could be added to its vehicle.

inline const Finding kSuggestionUnknown{"suggestion-unknown", Severity::kError,
                                        "there is no suggestion {}; {} are listed",
                                        "give the number of a row of `fourpost suggest`"};

}  // namespace fourpost
