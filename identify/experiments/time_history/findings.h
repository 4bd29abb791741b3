#pragma once

#include "analysis/text/finding.h"

// What can be wrong with time histories, before and after a fit.
namespace fourpost {

// The study.

inline const Finding kHistoriesEmpty{"histories-empty", Severity::kError,
                                     "'histories' must be a list with at least one entry",
                                     "add one, or remove the key"};
inline const Finding kHistoryTwice{"history-twice", Severity::kError, "two histories have the name '{}'",
                                   "rename one with 'name'"};
inline const Finding kHistoryUse{"history-use", Severity::kError, "'use' of {} must be fit or validation",
                                 "write `use: validation`, or leave it out for a recording to fit"};
inline const Finding kHistoryWindowEmpty{"history-window-empty", Severity::kError,
                                         "'end' of {} must be later than 'start'", "correct one of the two"};
inline const Finding kNoiseNotMapped{"noise-not-mapped", Severity::kError,
                                     "{} must map sensors of the vehicle to standard deviations such as 20 N"};
inline const Finding kNoiseUnreadable{
    "noise-unreadable", Severity::kError,
    "the noise of '{}' must be a standard deviation with a unit such as '0.1 {}', got "
    "'{}'"};
inline const Finding kHistoryCostUnknown{"history-cost-unknown", Severity::kError, "unknown cost '{}'{}"};
inline const Finding kHistoryPostUnknown{"history-post-unknown", Severity::kError, "the vehicle has no post '{}'{}"};
inline const Finding kHistoryHeights{"history-heights", Severity::kError, "'heights' of {} can only be 'absolute'",
                                     "leave it out for heights about their means"};
inline const Finding kSaturatedLeftOut{"saturated-left-out", Severity::kWarning,
                                       "'{}' {} in {}, so it is left out of the validation", "check its range"};
inline const Finding kHistoryAllSaturated{"history-all-saturated", Severity::kError,
                                          "history '{}' has no channel that is not saturated",
                                          "record it with larger ranges"};
inline const Finding kHistoryPostMissing{"history-post-missing", Severity::kError,
                                         "history '{}' does not state how post '{}' moved",
                                         "name the channel of its height under 'posts'"};
inline const Finding kReleaseOfStudy{"release-of-study", Severity::kWarning,
                                     "{} is predicted from where the study lets the vehicle go: {}",
                                     "state its own by --release, such as --release z_body=\"50 mm\""};
inline const Finding kReleaseOption{"release-option", Severity::kError, "'{}' states no release",
                                    "state estimated, \"at rest\", or the readings above rest at which the vehicle was "
                                    "held: z_body=\"50 mm\",z_axle=estimated"};
inline const Finding kReleaseUnknown{
    "release-unknown", Severity::kError, "'release' of {} is '{}'",
    "state 'estimated' (any pose and velocity), 'at rest' (any pose), or the readings above rest of displacement "
    "sensors at which the vehicle was held, such as {z_body: 50 mm} or {z_body: estimated}"};
inline const Finding kReleaseOfOtherSensor{"release-of-other-sensor", Severity::kError,
                                           "'{}' does not measure a displacement or a strut's length",
                                           "name sensors that do, or state 'release: at rest'"};
inline const Finding kReleaseHydraulic{
    "release-hydraulic", Severity::kError,
    "history '{}' starts from a release, at which the oil pressure in the hydraulic damper '{}' is not known",
    "give the damper a law without memory, or move posts instead"};
inline const Finding kReleaseCost{"release-cost", Severity::kError,
                                  "history '{}' starts from a release, which the cost '{}' does not estimate",
                                  "fit by the cost 'whitened'"};
inline const Finding kReleaseWithoutPose{"release-without-pose", Severity::kError,
                                         "no pose of rest was found with the sensors of 'release' at their readings",
                                         "check signs and units of 'release', or hold fewer sensors"};
inline const Finding kHistoryActuatorUnknown{"history-actuator-unknown", Severity::kError,
                                             "the vehicle has no actuator '{}'{}"};
inline const Finding kHistorySensorUnknown{"history-sensor-unknown", Severity::kError,
                                           "the vehicle has no sensor '{}'{}"};
inline const Finding kHistoryWithoutWeight{
    "history-without-weight", Severity::kError,
    "'{}' of history '{}' has no 'noise' and no 'model_error', so its residuals cannot be weighted",
    "state its 'noise', or 'history' of 'model_error' above zero"};
inline const Finding kPredictionFilter{"prediction-cost-filter", Severity::kError,
                                       "the cost 'prediction' needs unfiltered recordings",
                                       "remove 'filter' of history '{}'"};
inline const Finding kPredictionHydraulic{
    "prediction-cost-hydraulic", Severity::kError,
    "the cost 'prediction' corrects positions and velocities, not the oil pressure in the hydraulic damper '{}'",
    "fit by the cost 'whitened', or give the damper a law without memory"};
inline const Finding kPredictionFriction{
    "prediction-cost-friction", Severity::kError,
    "the cost 'prediction' corrects positions and velocities, not the force of the friction in fp:damper '{}', which "
    "has 'stiffness'",
    "fit by the cost 'whitened', or give the friction 'speed' in place of 'stiffness'"};
inline const Finding kKalmanTooSlow{"kalman-too-slow", Severity::kError,
                                    "one run of the Kalman filter takes longer than the deadline of {} s",
                                    "raise 'deadline' of 'search', or cut the recording by 'start' and 'end'"};

// Recordings.

inline const Finding kHistoryWindowOutside{"history-window-outside", Severity::kError,
                                           "history '{}' has no samples to compare, for {} goes from {} s to {} s",
                                           "correct 'start' and 'end', or record longer"};
inline const Finding kChannelDead{"channel-dead", Severity::kError, "'{}' does not change in {}",
                                  "remove the dead channel from the study"};
inline const Finding kChannelMotionless{
    "channel-motionless", Severity::kWarning,
    "'{}' does not move in '{}' (rms {}, the largest of its kind {}), so it is left out there",
    "check its cable if it should move; else nothing is missing", Weight::kSlight};
inline const Finding kChannelOnlyNoise{
    "channel-only-noise", Severity::kWarning,
    "channel '{}' of '{}' is dead: it holds nothing but noise of its converter, so '{}' is left out there",
    "check its plug and its amplifier"};
inline const Finding kHistoryMotionless{"history-motionless", Severity::kError,
                                        "no channel of history '{}' moves beside its posts",
                                        "check the cables and the units of its channels"};
inline const Finding kChannelSaturated{
    "channel-saturated", Severity::kWarning, "'{}' {} of {}, like a saturated sensor",
    "exclude it from the window by 'start' and 'end' of the history, or remove the channel from the study",
    Weight::kGrave};
inline const Finding kSamplesSaturated{"samples-saturated", Severity::kWarning,
                                       "'{}' {} of {}, like a saturated sensor, so these samples have no weight",
                                       "record it with a larger range"};
inline const Finding kPostSaturated{
    "post-saturated", Severity::kWarning,
    "the height of post '{}' {} of {}: how the post really moved there is unknown, which biases the parameters",
    "exclude it from the window by 'start' and 'end' of the history, or record it with a larger range", Weight::kGrave};
inline const Finding kChannelSpiked{
    "channel-spiked", Severity::kWarning,
    "'{}' of '{}' has wild values, as of a lost bit or a loose plug: {}, the first {} from the mean at {}; the fit "
    "follows "
    "them",
    "leave such fields empty and state 'bridge', or fit by a robust loss ('loss' of 'refine')", Weight::kGrave};
inline const Finding kChannelDrifts{
    "channel-drifts", Severity::kWarning,
    "'{}' of '{}' drifts by {} over {} beside its motion, and no post does, as of a sensor that warms up",
    "write '{}' in the study, or let it warm up before recording"};
inline const Finding kTimesClosedUp{
    "times-closed-up", Severity::kWarning,
    "a post and a displacement of '{}' jump at {}{}, as where rows are missing and times were closed up",
    "give the rows the times at which they were recorded"};
inline const Finding kInputUnknown{"input-unknown", Severity::kWarning,
                                   "no measurement of {} in '{}' from {} to {}{}: the vehicle's motion is unknown "
                                   "there and for {} s after, until it has "
                                   "settled, so these samples have no weight ({} % of all)",
                                   "record without gaps where more is needed"};
inline const Finding kInputNeverKnown{
    "input-never-known", Severity::kError, "gaps in {} of '{}' leave no samples at which the vehicle's motion is known",
    "record it again, or cut the recording to a stretch without gaps by 'start' and 'end'"};
inline const Finding kPostsUnitMistaken{
    "posts-unit-mistaken", Severity::kError,
    "the heights of the posts of '{}' are in another unit than stated, by a factor of 1000: {}",
    "write '{}' in the study", Weight::kGrave};
inline const Finding kChannelThousandfold{
    "channel-thousandfold", Severity::kError,
    "'{}' of '{}' reads {} times what the vehicle file gives, so its unit is wrong by a factor of 1000",
    "write '{}' in the study", Weight::kGrave};
inline const Finding kPostSampledTooSlowly{
    "post-sampled-too-slowly", Severity::kWarning,
    "post '{}' of history '{}' moves up to {} Hz and is sampled at {} Hz, but {} samples a period are needed",
    "record at a higher rate, or the interpolation between samples excites the model"};

// Plausibility after the fit.

inline const Finding kHistoryChannelsSwapped{
    "history-channels-swapped", Severity::kWarning,
    "'{}' of '{}' is measured like the model's '{}' and vice versa, as if the two "
    "channels were swapped",
    "exchange them in the study", Weight::kGrave};
inline const Finding kHistoryChannelsSwappedAtStart{
    "history-channels-swapped-at-start", Severity::kWarning,
    "'{}' of '{}' is measured like '{}' of the vehicle file and vice versa, as "
    "if the two channels were swapped",
    "exchange them in the study", Weight::kGrave};
inline const Finding kChannelScaledTwice{
    "channel-scaled-twice", Severity::kWarning,
    "'{}' of '{}' and the model differ by a factor of {}, as if the recording already had the scale of the study",
    "its error would be {} % with '{}' in the study", Weight::kGrave};
inline const Finding kChannelUnitMistaken{
    "channel-unit-mistaken", Severity::kWarning,
    "'{}' of '{}' and the model differ by a factor of {}, as if it were in {} instead of {}",
    "its error would be {} % with '{}' in the study", Weight::kGrave};
inline const Finding kChannelUnitDoubtful{"channel-unit-doubtful", Severity::kWarning,
                                          "'{}' of '{}' and the model differ by a factor of {}, as if its unit were "
                                          "wrong (1000: mm for m, 9.81: g for m/s^2)",
                                          "its error would be {} % with '{}' in the study", Weight::kGrave};
inline const Finding kChannelInverted{"channel-inverted", Severity::kWarning,
                                      "'{}' of '{}' moves against the model, as if its sign were wrong",
                                      "its error would be {} % with '{}' in the study", Weight::kGrave};
inline const Finding kActuatorInverted{
    "actuator-inverted", Severity::kWarning,
    "all channels of '{}' move against the model, as if the tension of {} had the wrong sign",
    "tension pulls the ends of an actuator together: change the 'sign' of its channel in 'actuators' of the study",
    Weight::kGrave};
inline const Finding kReleaseSignsDisagree{
    "release-signs-disagree", Severity::kWarning,
    "'{}' of '{}' moves against the model, and {} with it: one of the two has the wrong sign, and the release can be "
    "fitted with either, with bump and rebound exchanged",
    "write '{}' in the study if the vehicle was let go {}, '{}' if {}", Weight::kGrave};
inline const Finding kChannelLateOfModel{
    "channel-late-of-model", Severity::kWarning,
    "'{}' of '{}' comes {} than the model, as if it or the height of its post were not synchronised",
    "its error would be {} % with '{}' in the study"};
inline const Finding kChannelLateOfOthers{
    "channel-late-of-others", Severity::kWarning,
    "'{}' of '{}' comes {} than the other channels, relative to the model, as if it were not synchronised",
    "its error would be {} % with '{}' in the study"};
inline const Finding kChannelLateOfPoint{
    "channel-late-of-point", Severity::kWarning,
    "'{}' of '{}' comes {} than '{}' at the same point (by the second derivative of '{}', without a model), as if it "
    "were not synchronised",
    "correct it with '{}' in the study"};
inline const Finding kPostsNotSynchronised{
    "posts-not-synchronised", Severity::kWarning,
    "all channels of '{}' come {} than the model, as if the height of its post were not synchronised with them",
    "add 'delay: {}' to the channels of its 'posts' in the study", Weight::kGrave};
inline const Finding kStepTooLong{
    "step-too-long", Severity::kWarning,
    "the fitted values need shorter time steps than those of the vehicle file, for halving the step of {} ms changes a "
    "channel of '{}' by {} % of its rms",
    "fit again from the vehicle.urdf of these results"};
inline const Finding kHistoryKinematicsVisible{"history-kinematics-visible", Severity::kWarning,
                                               "history '{}': {}, and the cost 'prediction' is not corrected for it",
                                               "choose another 'cost'"};

// Prediction.

inline const Finding kHistoryNotPredicted{"history-not-predicted", Severity::kError,
                                          "the fitted vehicle cannot predict '{}': {}",
                                          "run `fourpost check` on the vehicle.urdf of the results"};
inline const Finding kModeOfHistory{"mode-of-history", Severity::kWarning,
                                    "{} contains the motion of its posts, so the option is ignored", "leave it out",
                                    Weight::kSlight};
inline const Finding kKalmanWithoutNoise{
    "kalman-without-noise", Severity::kError,
    "the run holds no noise for a Kalman filter, because the fit was not by 'cost: prediction'",
    "name the recording it was fitted to by --noise-from; noise estimated on the predicted recording would flatter the "
    "model"};
inline const Finding kKalmanHydraulic{
    "kalman-hydraulic", Severity::kError,
    "fp:damper '{}' is hydraulic, but a Kalman filter corrects positions and velocities, not its oil pressure",
    "leave --kalman out"};
inline const Finding kKalmanFriction{"kalman-friction", Severity::kError,
                                     "the friction of fp:damper '{}' has 'stiffness', but a Kalman filter corrects "
                                     "positions and velocities, not its force",
                                     "leave --kalman out"};

// Simulations that have no result.

inline const Finding kMotionUnbounded{"motion-unbounded", Severity::kError, "the motion grows without bound",
                                      "check damping and signs in the vehicle file"};
inline const Finding kForcesUnsolved{"forces-unsolved", Severity::kError,
                                     "the forces of the vehicle's elements were not found in {} steps",
                                     "record or simulate at a higher rate, and check stiff series springs"};
inline const Finding kKalmanMotionUnsolved{"kalman-motion-unsolved", Severity::kError,
                                           "the motion of the Kalman filter's model cannot be computed",
                                           "fit by `cost: whitened`, or state larger `process` and `noise`"};
inline const Finding kKalmanCovariance{"kalman-covariance", Severity::kError,
                                       "the Kalman filter's covariance is not finite",
                                       "fit by `cost: whitened`, or state larger `process` and `noise`"};

// motion.csv of a run.

inline const Finding kMotionColumns{"motion-columns", Severity::kError,
                                    "the columns are not this vehicle's posts and coordinates", "fit again"};
inline const Finding kMotionUneven{"motion-uneven", Severity::kError, "the rows of '{}' are not evenly spaced numbers",
                                   "fit again"};

}  // namespace fourpost
