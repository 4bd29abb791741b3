#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a command: its words, the files it is given, and how it ends.
namespace fourpost {

// Words.

inline const Finding kArgumentMisspelt{"argument-misspelt", Severity::kError, "{} does not take '{}'",
                                       "did you mean '{}'?"};
inline const Finding kArgumentUnknown{"argument-unknown", Severity::kError, "{} does not take '{}'", "see `{} --help`"};
inline const Finding kUsageWrong{"usage", Severity::kError, "{}", "see `{} --help`"};
inline const Finding kValueUnknown{"value-unknown", Severity::kError, "'{}' is not a valid value{}"};
inline const Finding kEngineFormer{"engine-former", Severity::kWarning, "'{}' is the earlier name of the engine '{}'",
                                   "rename it", Weight::kSlight};
inline const Finding kNotWholeNumber{"not-a-whole-number", Severity::kError,
                                     "'{}' is not a whole number from 0 to 2^62", "write digits, no leading zeros"};
inline const Finding kHelpTopicUnknown{"help-topic-unknown", Severity::kError,
                                       "'{}' is neither a command nor the id of a finding{}",
                                       "see `fourpost --help`, or `fourpost help findings`"};
inline const Finding kOptionOfVehicle{"option-of-vehicle", Severity::kError,
                                      "only for a vehicle file, and {} is a study",
                                      "leave it out, the study's recordings and vehicle define this"};

inline const Finding kPostChannelMalformed{"post-channel-malformed", Severity::kError,
                                           "'{}' does not name a channel and its post", "write it as CHANNEL=FL"};

inline const Finding kChannelUnitMalformed{
    "channel-unit-malformed", Severity::kError, "'{}' does not name a channel and its unit{}",
    "write it as CHANNEL=mm, with a unit such as m, mm, N, kN, g, m/s^2 or deg/s"};

// Folders of fits.

inline const Finding kRunNamedTwice{"run-named-twice", Severity::kError,
                                    "named twice, and a run is not compared with itself", "name each run once"};
inline const Finding kRunNotThere{"run-not-there", Severity::kError, "not a folder of `fourpost fit -o`{}",
                                  "name the folder that -o of the fit named"};
inline const Finding kRunEmpty{"run-empty", Severity::kError, "empty folder", "give one that `fourpost fit -o` wrote"};
inline const Finding kRunUnfinished{"run-unfinished", Severity::kError, "no result.json, which a fit writes at its end",
                                    "run `fourpost fit` with -o on this folder again, it continues from its archive"};
inline const Finding kRunNotFitted{"run-not-fitted", Severity::kError, "a study without results",
                                   "fit it first, by `fourpost fit {} -o run`, and give that folder"};
inline const Finding kRunWithoutResult{"run-without-result", Severity::kError,
                                       "no result.json, so not a complete folder of `fourpost fit -o`",
                                       "give another one, or fit again"};
inline const Finding kRunFileDamaged{"run-file-damaged", Severity::kError, "this file of a fit is damaged",
                                     "run `fourpost fit` with -o on its folder again"};
inline const Finding kVehicleNotShown{"vehicle-not-shown", Severity::kWarning,
                                      "the report does not show the vehicle ({})",
                                      "see `fourpost check` of the vehicle.urdf in its folder"};

// Predictions.

inline const Finding kRecordingWasFitted{
    "recording-was-fitted", Severity::kWarning,
    "this recording was used in the fit; the errors below are fit errors, not a prediction",
    "for a prediction name a recording that the fit did not use"};
inline const Finding kLoadPlaceUnreadable{"load-place-unreadable", Severity::kError, "'{}' is not three lengths",
                                          "write metres or units, e.g. -1.2,0,0.9 or -1200 mm,0,900 mm"};
inline const Finding kLoadFarOutside{
    "load-far-outside", Severity::kError, "{} is far outside the car, whose wheels, masses and sensors span {}",
    "count from the vehicle file's origin, and write the unit of numbers that are not metres, e.g. -1200 mm,0,900 mm"};
inline const Finding kLoadTipsCar{"load-tips-car", Severity::kError,
                                  "{} at {} would tip the car over (loads on posts: {})", "check mass and place"};
inline const Finding kLoadWithoutPitch{"load-without-pitch", Severity::kWarning,
                                       "the body of {} cannot pitch, so a load at x = {} acts as at x = {}",
                                       "use a car with two axles for its effect on pitch"};
inline const Finding kLoadWithoutRoll{"load-without-roll", Severity::kWarning,
                                      "the body of {} cannot roll, so a load at y = {} acts as at y = {}",
                                      "use a car with two sides for its effect on roll"};

// Motions of posts.

inline const Finding kVehicleWithoutPosts{"vehicle-without-posts", Severity::kError,
                                          "the vehicle has no fp:post to move", "add one under each tyre"};

// Ride.

inline const Finding kRidePointMalformed{"ride-point-malformed", Severity::kError, "'{}' is not a point of a body",
                                         "write NAME=LINK:X,Y,Z in metres along the link's axes, such as "
                                         "seat=chassis:0.1,0.3,0.8"};
inline const Finding kRidePointLink{"ride-point-link", Severity::kError, "the vehicle has no link '{}'{}"};
inline const Finding kRidePointTwice{"ride-point-twice", Severity::kError,
                                     "'{}' is the name of another point or sensor", "choose another name"};
inline const Finding kRideWeightingMalformed{"ride-weighting-malformed", Severity::kError,
                                             "'{}' does not weight a point",
                                             "write POINT=Wk; weightings of a point are Wk, Wd, Wf and Wb"};
inline const Finding kRideWeightingPoint{"ride-weighting-point", Severity::kError,
                                         "no point of this ride is called '{}'{}"};
inline const Finding kRideBandAboveSickness{
    "ride-band-above-sickness", Severity::kWarning,
    "Wf weighs accelerations from 0.1 to 0.5 Hz, and the band begins at {} Hz, so '{}' lacks most of what counts",
    "begin lower, by --band 0.08Hz:30Hz"};
inline const Finding kRideNotNormal{"ride-not-normal", Severity::kWarning,
                                    "on {} {} {} in {} of time, so power spectra are a rough estimate there",
                                    "compare the time history, by --time"};
inline const Finding kRideUnconverged{"ride-unconverged", Severity::kWarning,
                                      "the statistical linearisation did not converge on {}",
                                      "use the time history, by --time"};
inline const Finding kRideGridCoarse{"ride-grid-coarse", Severity::kWarning,
                                     "on {} halving the steps in frequency still changes an rms by {}",
                                     "a mode has next to no damping; see `fourpost modes`"};
inline const Finding kRideShocks{
    "ride-shocks", Severity::kWarning,
    "at {} on {} the motion has shocks that a_w understates (MTVV {} a_w, VDV {} a_w T^1/4)",
    "judge it by MTVV or VDV as well (ISO 2631-1, 6.3.3)", Weight::kSlight};
inline const Finding kRoadBeyondIso{"road-beyond-iso", Severity::kWarning,
                                    "on {} the band reaches from {} to {} cycles/m, and ISO 8608 describes roads from "
                                    "0.011 to 2.83",
                                    "choose another --band or --speed", Weight::kSlight};

inline const Finding kMotionImpossible{"motion-impossible", Severity::kError, "the posts cannot move like this ({})",
                                       "correct the options of the motion"};
inline const Finding kBandNotRising{"band-not-rising", Severity::kError,
                                    "'{}' does not go from a lower frequency to a higher one", "write e.g. 0.5Hz:30Hz"};
inline const Finding kRateTooLow{"rate-too-low", Severity::kError, "{} is too slow for motions up to {}",
                                 "use {} or more"};
inline const Finding kFilterTooHigh{"filter-too-high", Severity::kError, "{} is not below half the sampling rate of {}",
                                    "lower it or raise --rate"};
inline const Finding kHistoryTooLong{"history-too-long", Severity::kError, "{} at {} are more than {} samples",
                                     "lower --duration or --rate"};
inline const Finding kHistoryTooShort{"history-too-short", Severity::kError, "{} at {} hold fewer than two samples",
                                      "raise --duration or --rate"};
inline const Finding kStepCutShort{"step-cut-short", Severity::kError,
                                   "{} end before the step does, which starts at {} and rises for {}",
                                   "use more than {}"};
inline const Finding kRecordingEnds{"recording-ends", Severity::kWarning, "the recording ends after {}",
                                    "leave out what goes beyond, or record longer"};

// Vehicles in motion.

inline const Finding kValuesInconsistent{"values-inconsistent", Severity::kError,
                                         "these values cannot be combined ({})", "change one of them"};
inline const Finding kFrictionHolds{"friction-holds", Severity::kWarning,
                                    "fp:damper '{}' never slides in {}: its friction of {} holds, and its rates have "
                                    "no effect",
                                    "use about {} times the motion{}"};
inline const Finding kFrictionSticks{"friction-sticks", Severity::kWarning,
                                     "the friction of fp:damper '{}' never slides in {}: it acts like a spring of {}, "
                                     "and its force of {} has nearly no effect",
                                     "use about {} times the motion{}"};
inline const Finding kStepNotConverged{"step-not-converged", Severity::kWarning,
                                       "halving the step down to {} still changes a channel by {} of its rms",
                                       "expect errors of that size"};
inline const Finding kIntegratorNotConverged{
    "integrator-not-converged", Severity::kWarning,
    "a ten times more accurate integrator still changes a channel by {} of its rms", "expect errors of that size"};
inline const Finding kLinearKinematicsUnknown{"linear-kinematics-unknown", Severity::kWarning,
                                              "the error of linear kinematics could not be estimated ({})",
                                              "compare with `--engine full`"};
inline const Finding kFrequenciesUnanswered{"frequencies-unanswered", Severity::kWarning,
                                            "{}: no answer at {} of {} frequencies", "the result gives the reasons"};

// Results that cannot be written.

inline const Finding kOutputIsInput{"output-is-input", Severity::kError, "this is an input", "give another file"};
inline const Finding kOutputWithoutFolder{"output-without-folder", Severity::kError, "there is no folder {}",
                                          "create it or name another one"};
inline const Finding kOutputIsFolder{"output-is-folder", Severity::kError, "this is a folder", "name a file"};
inline const Finding kOutputNamedTwice{"output-named-twice", Severity::kError, "-o and --chart name the same file",
                                       "name two"};
inline const Finding kOutputEnding{"output-ending", Severity::kError, "'{}': {} is written to a file in {}",
                                   "name it e.g. '{}'"};
inline const Finding kPageWithoutName{"page-without-name", Severity::kError,
                                      "a page that compares {} runs needs a name",
                                      "write -o FILE, e.g. -o models.html"};
inline const Finding kOutputNotWritten{"output-not-written", Severity::kError, "cannot be written ({})",
                                       "allow it, or name another place"};
inline const Finding kStdoutNotWritten{"stdout-not-written", Severity::kError,
                                       "the result cannot be written to stdout ({})",
                                       "free some space, or write to a file with -o"};
inline const Finding kStarterFolderIsFile{"starter-folder-is-file", Severity::kError, "this is a file",
                                          "name a new folder"};
inline const Finding kStarterFolderNotEmpty{"starter-folder-not-empty", Severity::kError, "the folder is not empty",
                                            "name a new folder"};

inline const Finding kVehicleIsThere{"vehicle-is-there", Severity::kError, "there is a vehicle already",
                                     "name another folder, or pass --replace to write over it"};
inline const Finding kPointsAreThere{"points-are-there", Severity::kError, "there are points already",
                                     "use them with --points {}, or name another folder"};

inline const Finding kDraftIsThere{"draft-is-there", Severity::kError, "there is a study already",
                                   "name another folder, or move it away"};
inline const Finding kNothingToDraftFrom{"nothing-to-draft-from", Severity::kError, "no recording is in this folder",
                                         "name a folder with recordings, or files"};
inline const Finding kNotDrafted{"not-drafted", Severity::kError, "nothing can be made of this recording: {}",
                                 "see `fourpost info` of it, or write the study by hand"};

// Ends of a command.

inline const Finding kResponseInterrupted{"response-interrupted", Severity::kWarning,
                                          "interrupted: {} of {} frequencies have an answer",
                                          "run it again for the rest"};
inline const Finding kHistoryInterrupted{"history-interrupted", Severity::kWarning,
                                         "interrupted: the history ends at {} of {}", "run it again for the rest"};
inline const Finding kInterruptedAtStart{"interrupted-at-start", Severity::kWarning,
                                         "interrupted before there was anything to keep", "run it again"};
inline const Finding kSimulationStopped{"simulation-stopped", Severity::kError, "{}"};
inline const Finding kOutOfMemoryFound{"out-of-memory", Severity::kError, "out of memory",
                                       "use fewer --threads or free some; evaluations in an archive are kept"};
inline const Finding kDefectFound{"defect", Severity::kError, "a defect of fourpost: {}", "please report it"};

}  // namespace fourpost
