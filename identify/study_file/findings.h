#pragma once

#include "analysis/text/finding.h"

// What can be wrong with the text of a study, its keys and its channels.
namespace fourpost {

// YAML.

inline const Finding kStudyTooLong{"study-too-long", Severity::kError, "longer than 1 MiB",
                                   "remove what is not part of the study"};
inline const Finding kStudyNotYaml{"study-not-yaml", Severity::kError, "not YAML ({})",
                                   "indent by blanks, and quote values that hold ': ' or '#'"};
inline const Finding kStudyTwoDocuments{"study-two-documents", Severity::kError, "a second YAML document begins here",
                                        "put each study into a file of its own"};
inline const Finding kStudyTag{"study-tag", Severity::kError, "the tag '{}' has no meaning in a study", "remove it"};
inline const Finding kStudyAliasOfItself{"study-alias-of-itself", Severity::kError,
                                         "the alias refers to the value that contains it", "write the value out"};
inline const Finding kStudyTooManyValues{"study-too-many-values", Severity::kError,
                                         "the study has more than {} values up to here",
                                         "remove what is not part of the study"};

// Keys.

inline const Finding kKeysMissing{"keys-missing", Severity::kError, "{} must be a mapping of keys to values",
                                  "write one `key: value` a line"};
inline const Finding kKeyNotWord{"key-not-a-word", Severity::kError, "a key of {} must be a single word",
                                 "write keys as plain words, such as `vehicle:`"};
inline const Finding kKeyTwice{"key-twice", Severity::kError, "key '{}' of {} appears twice", "remove one of the two"};
inline const Finding kKeyUnknown{"key-unknown", Severity::kError, "unknown key '{}' in {}{}",
                                 "correct it, or remove it"};
inline const Finding kKeyMissing{"key-missing", Severity::kError, "{} needs the key '{}'", "add it"};

// Files beside a recording.

inline const Finding kHistoryWith{"history-with", Severity::kError, "{} must be a list of files",
                                  "write [b.csv], or [{file: b.csv, delay: 12 ms}]"};

// Values.

inline const Finding kKeyNotText{"key-not-text", Severity::kError, "{} must be text",
                                 "write a word, or put it into quotes"};
inline const Finding kKeyNotNumber{"key-not-number", Severity::kError,
                                   "{} must be a number from {} to {}, without a unit"};
inline const Finding kKeyNotInteger{"key-not-integer", Severity::kError, "{} must be a whole number from {} to {}"};
inline const Finding kKeyNotQuantity{"key-not-quantity", Severity::kError, "{} must be a number with a unit of {}{}"};
inline const Finding kKeyTooSmall{"key-too-small", Severity::kError, "{} must be at least {}"};
inline const Finding kKeyTooLarge{"key-too-large", Severity::kError, "{} must be at most {}"};
inline const Finding kKeyNotPositive{"key-not-positive", Severity::kError, "{} must be above zero"};

// Channels of recordings.

inline const Finding kChannelsNotMapped{"channels-not-mapped", Severity::kError,
                                        "{} must map {} of the vehicle to measured channels",
                                        "write one line for each, as `name: channel`"};
inline const Finding kChannelNotNamed{
    "channel-not-named", Severity::kError,
    "{} must be a measured channel, {channel: a, sign: -1}, {mean: [a, b]} or {sum: [a, b]}"};
inline const Finding kChannelListEmpty{"channel-list-empty", Severity::kError, "{} must be a list of channels",
                                       "write it as [a, b]"};
inline const Finding kChannelMeanAndSum{"channel-mean-and-sum", Severity::kError,
                                        "{} has both 'mean' and 'sum' of channels", "keep one of the two"};
inline const Finding kChannelSign{"channel-sign", Severity::kError, "'sign' of {} must be 1 or -1"};
inline const Finding kChannelScale{"channel-scale", Severity::kError, "'scale' of {} must be above zero",
                                   "invert a channel with 'sign: -1'"};
inline const Finding kChannelSourceUnit{"channel-source-unit", Severity::kError,
                                        "'unit' of {} is '{}', an unknown unit{}", "write one such as mm, kN or m/s^2"};

inline const Finding kChannelOffset{"channel-offset", Severity::kError,
                                    "'offset' of {} is '{}', not a number with a unit", "write it as 3 mm"};
inline const Finding kChannelTrend{"channel-trend", Severity::kError, "'trend' of {} can only be 'remove'",
                                   "leave it out to keep the trend"};
inline const Finding kNoChannelByName{"no-channel-by-name", Severity::kError,
                                      "no channel is called as a sensor of the vehicle{}",
                                      "map sensors to channels by 'channels'"};

// Recordings.

inline const Finding kFittedChannelsMissing{"fitted-channels-missing", Severity::kError,
                                            "the recording has none of the channels that the model was fitted to",
                                            "name a recording with the channels of the study"};
inline const Finding kSensorsNotMeasured{"sensors-not-measured", Severity::kWarning,
                                         "the recording has no channels for {}, which are left out",
                                         "check names in the study if they were recorded", Weight::kSlight};
inline const Finding kSampledTooSlowly{
    "sampled-too-slowly", Severity::kError,
    "{} is sampled at {} Hz, too slowly for the band up to the filter's cut-off frequency of {} Hz",
    "record at {} Hz or more"};
inline const Finding kValidationLeftOut{"validation-left-out", Severity::kWarning,
                                        "recording '{}' is left out of the validation",
                                        "correct it, or remove it from the study"};

// Controls.

inline const Finding kControlNotMapped{"control-not-mapped", Severity::kError,
                                       "'control' must map parameters of the vehicle to 'linear' or 'per setting'"};
inline const Finding kControlWithoutSetting{
    "control-without-setting", Severity::kError,
    "no recording to fit states the setting that '{}' of 'control' follows",
    "add 'control' to the recordings of 'bench' or 'histories', or remove it from the study"};
inline const Finding kControlUnknown{"control-unknown", Severity::kError, "'{}' under 'control' has no known law",
                                     "state 'linear' or 'per setting'"};
inline const Finding kSettingNoNumber{"setting-no-number", Severity::kError, "'control' is '{}', which is no number",
                                      "state a number, with or without a unit, such as 1.5 A"};
inline const Finding kSettingMissing{"setting-missing", Severity::kError,
                                     "'{}' does not state its setting, which parameters under 'control' follow",
                                     "add 'control' with its number, or `--control` to `predict`"};
inline const Finding kSettingWithoutControl{"setting-without-control", Severity::kError,
                                            "'{}' states a setting, which nothing follows",
                                            "name the parameters that follow it under 'control' of the study"};

// Calibrations.

inline const Finding kCalibrationNotMapped{"calibration-not-mapped", Severity::kError,
                                           "'{}' of 'calibration' must map instruments to standard deviations",
                                           "write, for example, gain: {accelerometers: 1 %}"};
inline const Finding kCalibrationNotPositive{"calibration-not-positive", Severity::kError,
                                             "the standard deviation of '{}' under 'calibration' is not above zero",
                                             "remove an instrument that is exactly known"};
inline const Finding kCalibrationGainWide{"calibration-gain-wide", Severity::kError,
                                          "a gain of '{}' that is known to {} only is no calibration",
                                          "write it in per cent, such as 1 %"};
inline const Finding kCalibrationOffset{"calibration-offset", Severity::kError,
                                        "'{}' has no offset that a fit could see, because it fits no mean of it",
                                        "state the offset of 'static_loads' only"};
inline const Finding kCalibrationDelayAtRest{"calibration-delay-at-rest", Severity::kError,
                                             "'static_loads' cannot be late: they are read at rest",
                                             "remove it from 'delay'"};

inline const Finding kBandOutOfRange{"band-out-of-range", Severity::kError,
                                     "{} must be two rising frequencies up to 200 Hz", "write `band: [0.5 Hz, 30 Hz]`"};

}  // namespace fourpost
