#pragma once

#include "analysis/text/finding.h"

// What can be wrong with recordings, tables and folders of results.
namespace fourpost {

// Any file.

inline const Finding kFileNotThere{"file-not-there", Severity::kError, "file{} does not exist{}",
                                   "correct the name or its folder"};
inline const Finding kFileUnreadable{"file-unreadable", Severity::kError, "cannot be read ({})",
                                     "allow reading it, or name another file"};
inline const Finding kFileNotRegular{"file-not-regular", Severity::kError, "{}, not a file",
                                     "write its content to a file and name that"};
inline const Finding kFileTooLarge{"file-too-large", Severity::kError, "larger than {}",
                                   "give a part of the recording, or a lower sampling rate"};

// Tables in text.

inline const Finding kCsvUtf16{"csv-utf-16", Severity::kError, "written in UTF-16", "save it as UTF-8"};
inline const Finding kCsvBinary{"csv-binary", Severity::kError, "binary file, not text",
                                "export the recording as CSV, MAT, RPC III, UFF, TDMS, MDF or HDF5"};
inline const Finding kCsvJson{"csv-json", Severity::kError, "JSON, not a table",
                              "export the recording as CSV, MAT, RPC III, UFF, TDMS, MDF or HDF5"};
inline const Finding kCsvLineEnds{"csv-line-ends", Severity::kError, "lines end with CR alone",
                                  "save it with line ends of Unix (LF) or Windows (CRLF)"};
inline const Finding kCsvEmpty{"csv-empty", Severity::kError, "empty file",
                               "a table needs a header line and rows of numbers"};
inline const Finding kCsvQuoteOpen{"csv-quote-open", Severity::kError,
                                   "the quote that opens in line {} is never closed", "close it, or remove it"};
inline const Finding kCsvTextBehindQuote{"csv-text-behind-quote", Severity::kError, "text follows a closing quote",
                                         "double the quotes inside a quoted field"};
inline const Finding kCsvSeparator{"csv-separator", Severity::kError, "columns are separated by {}",
                                   "save it with commas, semicolons or tabs"};
inline const Finding kCsvTooManyNames{"csv-too-many-names", Severity::kError, "the header names {}, the rows have {}",
                                      "name as many columns as there are"};
inline const Finding kCsvLinesAboveNames{"csv-lines-above-names", Severity::kError,
                                         "the header names {}, the rows have {}",
                                         "remove the lines above the column names"};
inline const Finding kCsvLastColumnUnnamed{
    "csv-last-column-unnamed", Severity::kError, "the header names {}, the rows have {}",
    "remove the lines above the column names, or name the last column, which may be empty"};
inline const Finding kCsvDecimalCommas{
    "csv-decimal-commas", Severity::kError, "the header names {}, the rows have {}",
    "remove the lines above the column names; or separate columns by semicolons where decimals have commas"};
inline const Finding kCsvColumnNameless{"csv-column-nameless", Severity::kError, "column {} has no name",
                                        "name it, or remove it"};
inline const Finding kCsvColumnTwice{"csv-column-twice", Severity::kError,
                                     "column {} has the name '{}' of an earlier one", "rename one of them"};
inline const Finding kCsvWithoutNames{
    "csv-without-names", Severity::kWarning, "numbers from the first line on, so columns are called column1 to {}",
    "write a line above them, as time [s],post_FL [mm],a_body [g], or of frequency responses "
    "frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg; or state {channel: column2, unit: mm} in a study, "
    "--post column2=FL --unit column2=mm for `fourpost frf`"};
inline const Finding kCsvNoRows{"csv-no-rows", Severity::kError, "no rows below the header",
                                "add one row of numbers for each sample or frequency"};
inline const Finding kCsvLastRowCut{
    "last-row-cut", Severity::kWarning,
    "the file ends within its last row, which has {} of {} and no line end, so that row is left out",
    "record again if more than this row is missing", Weight::kSlight};
inline const Finding kCsvRowLength{"csv-row-length", Severity::kError, "the row has {}, the header {}",
                                   "write one field for each column name"};
inline const Finding kCsvNotANumber{"csv-not-a-number", Severity::kError, "{} '{}' is not a finite number",
                                    "correct it, or leave the field empty where nothing was measured"};

// Preparation of time histories.

inline const Finding kGapNotBridged{"gap-not-bridged", Severity::kError,
                                    "no samples of '{}' from {} to {}, longer than {}",
                                    "raise 'bridge', or cut the recording by 'start' and 'end'"};
inline const Finding kChannelHeld{
    "channel-held", Severity::kWarning,
    "{} did not change from {} to {}{}, and then went on from another value, as of a logger that lost time or a loose "
    "plug: {} samples of each count as not measured",
    "record again where it matters"};
inline const Finding kResampledBelow{
    "resampled-below", Severity::kError,
    "{} Hz are below the recorded rate of {} Hz, so that what is faster would be folded",
    "state 'resample' at the recorded rate or above"};
inline const Finding kHighPassTooHigh{"high-pass-too-high", Severity::kError,
                                      "{} Hz for '{}' is not below half the sampling rate of {} Hz", "lower it"};
inline const Finding kNothingToIntegrate{
    "nothing-to-integrate", Severity::kError,
    "'{}' is in '{}', not a velocity or an acceleration, so it cannot be integrated",
    "remove 'integrate', or correct the unit"};
inline const Finding kOffsetDimension{"offset-dimension", Severity::kError,
                                      "the offset of '{}' is a {}, which the channel is not",
                                      "give it in the channel's unit"};
inline const Finding kChannelInNoFile{"channel-in-no-file", Severity::kError, "no file has channel '{}' ({})",
                                      "correct the name, or add the file under 'with'"};

// MAT files.

inline const Finding kMatNoVector{"mat-no-vector", Severity::kError, "MAT file holds no vector of real numbers",
                                  "save each channel as a variable of its own"};
inline const Finding kMatVectorTwice{"mat-vector-twice", Severity::kError, "MAT file holds two vectors called '{}'",
                                     "rename one"};

// Recordings of measurement systems.

inline const Finding kChannelsInterpolated{
    "channels-interpolated", Severity::kWarning,
    "channels {} are interpolated to the fastest ones' {}, which is good up to about {}",
    "record all channels at one rate if they matter above it"};
inline const Finding kChannelsWithoutTimes{"channels-without-times", Severity::kWarning,
                                           "channels without times are left out: {}",
                                           "export them with a rate if they matter"};
inline const Finding kNoCommonTime{"no-common-time", Severity::kError,
                                   "channel '{}' begins at {}, when others have ended ({})",
                                   "save channels that were recorded together"};
inline const Finding kResponsesOfSeveralPoints{"responses-of-several-points", Severity::kError,
                                               "frequency responses refer to several points: {}",
                                               "export those of one reference as a file"};
inline const Finding kResponsesDiffer{"responses-differ", Severity::kError,
                                      "frequency response '{}' has other frequencies than '{}'",
                                      "export responses with the same frequencies"};
inline const Finding kResponseReference{
    "response-reference", Severity::kError,
    "frequency response '{}' refers to '{}' of unit '{}', not to a displacement, velocity or acceleration of a post",
    "export responses to the motion of a post, with units"};
inline const Finding kResponseUnit{"response-unit", Severity::kWarning,
                                   "frequency response '{}' is left out: its unit is '{}'",
                                   "export displacements, accelerations, forces or angular velocities with units"};
inline const Finding kResponsesNone{"responses-none", Severity::kError,
                                    "no frequency response of a displacement, acceleration, force or angular velocity",
                                    "export responses with their units"};

// Columns of recordings.

inline const Finding kColumnMissing{"column-missing", Severity::kError, "column '{}' is missing", "add it"};
inline const Finding kColumnUnknown{"column-unknown", Severity::kError, "unknown column '{}'{}",
                                    "correct it, or remove it"};
inline const Finding kColumnSuperfluous{"column-superfluous", Severity::kError, "unknown column '{}'", "remove it"};
inline const Finding kColumnLength{"column-length", Severity::kError, "column '{}' has {} rows, column '{}' {}",
                                   "give all columns the same length"};
inline const Finding kChannelColumnMissing{"channel-column-missing", Severity::kError, "column '{}', {}, is missing{}",
                                           "correct the name, or add the column"};

// Time histories.

inline const Finding kSteppedSineAsHistory{"stepped-sine-as-history", Severity::kError,
                                           "a stepped sine, not a time history",
                                           "list it under 'recordings' of a study of a vehicle on posts"};
inline const Finding kSampleMissing{"sample-missing", Severity::kError, "column '{}' has {} {}",
                                    "state 'bridge' with the longest gap, or cut the recording there"};
inline const Finding kUnitMissing{"unit-missing", Severity::kError, "column '{}', {}, has no unit",
                                  "write that of a {} {}, or state it: {channel: {}, unit: {}} in a study, --unit for "
                                  "`fourpost frf` and `fourpost init`"};
inline const Finding kUnitOfOtherDimension{"unit-of-other-dimension", Severity::kError,
                                           "column '{}', {}, has the unit '{}'{}", "it needs that of a {}"};
inline const Finding kTimeSwapped{"time-column-swapped", Severity::kError,
                                  "column '{}', {}, has the unit '{}', not that of a {}, but column '{}' has one",
                                  "exchange the two columns if they are swapped"};
inline const Finding kSamplesDiffer{"samples-differ", Severity::kError, "column '{}' has {} samples, the times are {}",
                                    "save channels of one rate together"};
inline const Finding kShorterThanDelays{"shorter-than-delays", Severity::kError,
                                        "recording is shorter than the delays that the study gives its channels",
                                        "correct `delay` in the study, or record longer"};
inline const Finding kTooFewSamples{"too-few-samples", Severity::kError, "recording has {} samples",
                                    "it needs four at least"};
inline const Finding kTimeStepsBack{
    "time-steps-back", Severity::kError, "time steps back repeatedly, while column '{}' rises evenly",
    "exchange the two columns if they are swapped, or name the time column in the study"};
inline const Finding kTimeDoesNotRise{"time-does-not-rise", Severity::kError,
                                      "time does not rise from sample to sample",
                                      "write the time of each sample in its unit"};
inline const Finding kTimeTooCoarse{
    "time-too-coarse", Severity::kError,
    "times have too few digits: most are equal to the one before, {} samples in {}, about {} samples a second",
    "export times with fractions of a second, or write a column of times of the recorder's rate"};
inline const Finding kTimeStepUneven{
    "time-step-uneven", Severity::kError,
    "time goes from {} to {}, but the usual step is {}, and samples must be evenly spaced",
    "fill the gap or cut the recording there; or state 'bridge' for gaps and 'resample' for steps that jitter"};
inline const Finding kTimeDrifts{"time-drifts", Severity::kError,
                                 "time is {} off even steps of {} here, and samples must be evenly spaced",
                                 "resample the recording at one rate"};

// Stepped sines.

inline const Finding kSteppedSineNameless{"stepped-sine-nameless", Severity::kError,
                                          "frequency responses without names of columns",
                                          "write frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg above them"};
inline const Finding kComparisonAsRecording{"comparison-as-recording", Severity::kError,
                                            "a fit's result, in which measurement and model stand side by side ({})",
                                            "name a recording itself, as the `recordings` of a study do"};
inline const Finding kHistoryAsSteppedSine{"history-as-stepped-sine", Severity::kError,
                                           "a time history, not a stepped sine", "list it under 'histories'"};
inline const Finding kChannelNameless{"channel-nameless", Severity::kError, "the channel has no name",
                                      "write one or remove the row"};
inline const Finding kFieldMissing{"field-missing", Severity::kError, "{}: {} is missing (NaN)",
                                   "remove the whole frequency or repeat the measurement"};
inline const Finding kFieldNotANumber{"field-not-a-number", Severity::kError, "{}: {} '{}' is not a finite number",
                                      "correct it"};
inline const Finding kFieldNotPositive{"field-not-positive", Severity::kError, "{}: {} {} must be above zero",
                                       "correct it"};
inline const Finding kFieldNegative{"field-negative", Severity::kError, "{}: {} {} must not be negative", "correct it"};
inline const Finding kFieldNotEverywhere{"field-not-everywhere", Severity::kError,
                                         "{}: {} is missing, but is there at other frequencies",
                                         "fill it in for all of them or for none"};
inline const Finding kMeanSdWithoutMean{"mean-sd-without-mean", Severity::kError,
                                        "channel '{}' of '{}' has a standard deviation of its mean, but no mean",
                                        "give the mean, or leave its standard deviation out"};
inline const Finding kAmplitudeMissing{"amplitude-missing", Severity::kError,
                                       "frequency responses without the amplitude of the post",
                                       "state it in the study, as in amplitude: 5 mm"};
inline const Finding kAmplitudesDiffer{"amplitudes-differ", Severity::kError,
                                       "{}: post_amplitude_m is {}, but {} in {}", "a frequency has one amplitude"};
inline const Finding kChannelTwice{"channel-twice", Severity::kError, "{}: the channel is there twice",
                                   "remove one of the two rows"};
inline const Finding kFrequenciesUnsorted{"frequencies-unsorted", Severity::kError,
                                          "{}: {} stands above it, but frequencies must increase", "sort the rows"};
inline const Finding kChannelsMissing{"channels-missing", Severity::kError, "at {} channel {} is missing",
                                      "add what is missing or remove the whole frequency"};
inline const Finding kChannelUnit{
    "channel-unit", Severity::kError,
    "{}: the unit '{}' is not one of a length, a force, an acceleration or an angular velocity{}",
    "write one like mm, kN, m/s^2 or deg/s"};
inline const Finding kChannelUnitUnknown{
    "channel-unit-unknown", Severity::kError,
    "the unit of {} does not follow from its name (a_ for m/s^2, s_ for m, F_ for N)", "add a column 'unit'"};
inline const Finding kChannelUnitsDiffer{"channel-units-differ", Severity::kError,
                                         "{}: the unit is '{}', but '{}' in {}", "a channel has one unit"};

// Static loads.

inline const Finding kQuantityNameless{"quantity-nameless", Severity::kError, "the quantity has no name",
                                       "write one or remove the row"};
inline const Finding kQuantityTwice{"quantity-twice", Severity::kError, "{} is in {} already", "remove one of the two"};
inline const Finding kQuantityUnit{"quantity-unit", Severity::kError, "{}: unknown unit '{}'{}",
                                   "write one like N, kg, mm, or 1"};
inline const Finding kQuantityMissing{"quantity-missing", Severity::kError, "{}: {} is missing", "write a number"};
inline const Finding kQuantityNotANumber{"quantity-not-a-number", Severity::kError,
                                         "{}: {} '{}' is not a finite number", "correct it"};
inline const Finding kQuantityTooLarge{"quantity-too-large", Severity::kError, "{}: {} '{}' is too large",
                                       "correct it"};
inline const Finding kDeviationNegative{"deviation-negative", Severity::kError,
                                        "{}: sd, the standard deviation, must not be negative", "correct it"};

// Folders of results.

inline const Finding kFolderNameless{"folder-nameless", Severity::kError, "the folder for the results has no name",
                                     "name one"};
inline const Finding kFolderHoldsInput{"folder-holds-input", Severity::kError, "folder holds the input {}",
                                       "name another folder"};
inline const Finding kFolderHoldsFiles{"folder-holds-files", Severity::kError,
                                       "folder holds files, but no {} of an earlier run",
                                       "name a new or an empty folder"};
inline const Finding kFolderIsAFile{"folder-is-a-file", Severity::kError, "not a folder",
                                    "name another one for the results"};
inline const Finding kFolderTakesNoFolder{"folder-not-created", Severity::kError, "{} takes no new folder ({})",
                                          "name one elsewhere, or allow writing there"};
inline const Finding kFolderNotWritable{"folder-not-writable", Severity::kError, "folder cannot be written to ({})",
                                        "allow it or name another folder"};
inline const Finding kResultsNotWritten{"results-not-written", Severity::kError, "results cannot be written ({})",
                                        "remove the obstacle or name another folder"};
inline const Finding kDiskFull{"disk-full", Severity::kError, "results cannot be written ({})",
                               "free some space, or name another folder"};

}  // namespace fourpost
