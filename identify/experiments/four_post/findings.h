#pragma once

#include "analysis/text/finding.h"

// What can be wrong with stepped sines on posts, before and after a fit.
namespace fourpost {

// The study.

inline const Finding kSinesEmpty{"sines-empty", Severity::kError, "'recordings' must be a list with at least one entry",
                                 "add one, or remove the key"};
inline const Finding kSinesNotFitted{"sines-not-fitted", Severity::kError, "all recordings are kept for validation",
                                     "fit one at least, stepped sine or history: 'use: fit'"};
inline const Finding kSineUse{"sine-use", Severity::kError, "'use' of {} must be fit or validation",
                              "write `use: validation`, or leave it out for a recording to fit"};
inline const Finding kSineTwice{"sine-twice", Severity::kError, "two recordings have the name '{}'",
                                "rename one with 'name'"};
inline const Finding kSinePatternUnknown{"sine-pattern-unknown", Severity::kError, "unknown pattern '{}' of 'posts'{}"};
inline const Finding kPostSharesMissing{"post-shares-missing", Severity::kError,
                                        "'posts' must be a pattern such as pitch, or map each moving post to its share "
                                        "of the motion, such as {front: 1, rear: -1}"};
inline const Finding kPostReferenceMissing{"post-reference-missing", Severity::kError, "no share of 'posts' is 1 or -1",
                                           "give one to the reference post"};
inline const Finding kPostShareMissing{"post-share-missing", Severity::kError,
                                       "recording '{}' does not state how post '{}' moved",
                                       "give it a share, 0 if it stood still"};
inline const Finding kSinePostUnknown{"sine-post-unknown", Severity::kError, "the vehicle has no post '{}'{}"};
inline const Finding kSineSensorUnknown{"sine-sensor-unknown", Severity::kError, "the vehicle has no sensor '{}'{}"};
inline const Finding kBandNotPair{"band-not-a-pair", Severity::kError,
                                  "'band' must be a list of two frequencies such as [0.5 Hz, 12 Hz]"};
inline const Finding kBandEmpty{"band-empty", Severity::kError, "'band' is empty",
                                "its lower end must be below its upper end"};
inline const Finding kBandTooHigh{"band-too-high", Severity::kError, "'band' ends above 100 kHz",
                                  "give frequencies in Hz that the recordings have"};
inline const Finding kBandWithoutFrequency{"band-without-frequency", Severity::kError,
                                           "the band holds no frequency of recording '{}'",
                                           "widen 'band', or remove the recording"};

// Recordings over time.

inline const Finding kSinePostChannels{"sine-post-channels", Severity::kError,
                                       "'post_channels' must map each post to its channel",
                                       "write it as {FL: z_fl, FR: z_fr}"};
inline const Finding kSineKeysOfHistory{
    "sine-keys-of-history", Severity::kError,
    "'post_channels', 'filter', 'resample', 'bridge', 'with', 'time', 'start' and 'end' are for time histories, and "
    "recording '{}' is a table of responses",
    "remove them"};
inline const Finding kSineChannelOfHistory{
    "sine-channel-of-history", Severity::kError,
    "'unit', 'offset', 'trend', 'high_pass' and 'integrate' of '{}' are for time histories, and recording '{}' is a "
    "table of responses",
    "remove them, or use 'scale'"};
inline const Finding kSineWindowEmpty{"sine-window-empty", Severity::kError, "'end' of {} must be later than 'start'",
                                      "correct one of the two"};
inline const Finding kSineRepeatsCounted{"sine-repeats-counted", Severity::kError,
                                         "recording '{}' is a time history, of which repeats are counted",
                                         "remove 'repeats'"};
inline const Finding kSinePostsUnmapped{"sine-posts-unmapped", Severity::kError,
                                        "channels of posts in recording '{}' are {}, posts of the vehicle {}",
                                        "map them, as in post_channels: {FL: z_fl, FR: z_fr}"};
inline const Finding kSinePostsOtherwise{"sine-posts-otherwise", Severity::kError,
                                         "in recording '{}' the posts move as {}, according to the study as {}",
                                         "correct 'posts', or the channels in 'post_channels'"};
inline const Finding kSineSeveralAmplitudes{
    "sine-several-amplitudes", Severity::kError,
    "recording '{}' holds {} responses, of several amplitudes at one frequency, as stated by 'posts'",
    "make one recording of each by `fourpost frf FILE -o DIR`"};

// Recordings.

inline const Finding kSineChannelMissing{"sine-channel-missing", Severity::kError, "{} has no channel '{}'{}",
                                         "correct the name, or leave the channel out for this recording"};
inline const Finding kSineUnitsDiffer{"sine-units-differ", Severity::kError,
                                      "channel '{}' is in {}, sensor '{}' in {}, so they cannot be compared",
                                      "map a channel of the same quantity"};
inline const Finding kSineWithoutWeight{
    "sine-without-weight", Severity::kError,
    "'{}' has frequencies without standard deviation over repeats, and no model error",
    "give 'gain_dB' and 'phase' of 'model_error' above zero"};
inline const Finding kMembersOpposed{"members-opposed", Severity::kWarning,
                                     "'{}' and '{}' of '{}' move against each other, so their {} nearly vanishes",
                                     "one of them has the opposite sign"};

// Plausibility before the fit.

inline const Finding kRigAmplitude{"rig-amplitude", Severity::kError,
                                   "posts of recording '{}' move by {} mm at the most, which no rig for vehicles does",
                                   "write '{}'", Weight::kGrave};
inline const Finding kSineThousandfold{
    "sine-thousandfold", Severity::kError,
    "'{}' reads {} times what the vehicle file gives, so its unit is wrong by a factor of 1000",
    "write '{}' in the study, or correct the unit in the file", Weight::kGrave};
inline const Finding kPostsMoveOtherwise{
    "posts-move-otherwise", Severity::kError,
    "according to the study, the posts of recording '{}' move as {}, but up to {} Hz, where a car follows its posts, "
    "accelerations and forces look like {} (correlation {}, as stated {})",
    "correct 'posts', or the positions and signs of the channels"};
inline const Finding kPostsMatchNothing{
    "posts-match-nothing", Severity::kWarning,
    "according to the study, the posts of recording '{}' move as {}, but up to {} Hz, where a car follows its posts, "
    "accelerations and forces match no motion of these posts (correlation as stated {})",
    "check that it is a recording of this car and of this motion, and the position and sign of each channel"};
inline const Finding kSignOpposite{"sign-opposite", Severity::kWarning,
                                   "'{}' moves against the vehicle (correlation {}), so its sign is opposite: up, "
                                   "extension and more load are positive",
                                   "write '{}' in the study"};
inline const Finding kStationSign{"station-sign", Severity::kWarning,
                                  "'{}' does not move with its body below 1 Hz (error {} % of the loudest, the other "
                                  "accelerometers {} %) because its sign is opposite",
                                  "write '{}' in the study"};
inline const Finding kStationAlong{"station-along", Severity::kWarning,
                                   "'{}' does not move with its body below 1 Hz (error {} % of the loudest, the other "
                                   "accelerometers {} %), but as if it sat {} m further {}",
                                   "check its position in the vehicle file"};
inline const Finding kStationScale{"station-scale", Severity::kWarning,
                                   "'{}' does not move with its body below 1 Hz (error {} % of the loudest, the other "
                                   "accelerometers {} %) and reads {} times what it should",
                                   "check its scale"};
inline const Finding kStationStray{
    "station-stray", Severity::kWarning,
    "'{}' does not move with its body below 1 Hz (error {} % of the loudest, the other accelerometers {} %)",
    "check its position in the vehicle file, its sign, its scale, and that it is this channel"};
inline const Finding kWheelpanForgotten{
    "wheelpan-forgotten", Severity::kWarning,
    "load cells feel the inertia of a mass that moves with the post, a wheelpan that the vehicle file does not have, "
    "or "
    "not as heavy: {}",
    "write `wheelpan=\"{} kg\"` at fp:sensor there{}, or subtract the inertia from the recording"};
inline const Finding kWheelpanTakenOut{"wheelpan-taken-out", Severity::kWarning,
                                       "load cells lack the inertia of a wheelpan: {}",
                                       "remove `wheelpan` there if its inertia is subtracted from the recording; where "
                                       "the vehicle file has none, it was subtracted twice"};

// The fit.

inline const Finding kSineNotPeriodic{"sine-not-periodic", Severity::kError,
                                      "no periodic response of '{}' to differentiate",
                                      "narrow the bounds, or leave its frequency out by `band`"};

// Its last word brings the remedy of the cause.
inline const Finding kResponseUnanswered{"response-unanswered", Severity::kError,
                                         "'{}' has no periodic response at {} Hz: {}"};

inline const Finding kSinesFarOff{
    "sines-far-off", Severity::kWarning, "fit errors are far above what noise and the stated model error explain: {}",
    "check the wiring (sign, scale, delay, position, channel); if it is right, the model lacks a mechanism",
    Weight::kGrave};
inline const Finding kManySinesFarOff{
    "many-sines-far-off", Severity::kWarning,
    "fit errors of {} are far above what noise and the stated model error explain, the worst: {}",
    "check the wiring (sign, scale, delay, position, channel); if it is right, the model lacks a mechanism; the table "
    "of "
    "channels and the charts of responses show all",
    Weight::kGrave};
inline const Finding kModelFarOffSines{
    "model-far-off-sines", Severity::kWarning,
    "fit errors are far above what noise and the stated model error explain: {}",
    "the audit clears the wiring, so the model lacks a mechanism: `fourpost suggest` looks for it", Weight::kGrave};
inline const Finding kModelFarOffManySines{
    "model-far-off-many-sines", Severity::kWarning,
    "fit errors of {} are far above what noise and the stated model error explain, the worst: {}",
    "the audit clears the wiring, so the model lacks a mechanism: `fourpost suggest` looks for it; the table of "
    "channels and the charts of responses show all",
    Weight::kGrave};
inline const Finding kSineKinematicsVisible{
    "sine-kinematics-visible", Severity::kWarning,
    "recording '{}': {}, which is not small compared with the stated model error of {} dB and {} degrees",
    "expect fitted parameters to compensate for it, or fit smaller strokes"};

// Prediction.

inline const Finding kSineOutsideBand{"sine-outside-band", Severity::kError,
                                      "the recording has no frequency within the band of the fitted study",
                                      "predict a recording within the study's `band`"};
inline const Finding kSineSeveralMotions{"sine-several-motions", Severity::kError,
                                         "the recording holds {} motions of the posts", "choose one by --mode"};
inline const Finding kPatternNotFound{
    "pattern-not-found", Severity::kError,
    "no pattern that the posts of {} can make resembles this recording at its lowest frequencies",
    "name it with --mode, or check that the vehicle can move so"};
inline const Finding kKalmanOfSine{"kalman-of-sine", Severity::kError,
                                   "{} is a frequency response, and the option is for time histories", "leave it out"};

}  // namespace fourpost
