#pragma once

#include "analysis/text/finding.h"

// What can be wrong with time histories of which frequency responses are made.
namespace fourpost {

inline const Finding kResponsePostsUnknown{
    "response-posts-unknown", Severity::kError,
    "no channel is known to be a post's displacement; channels of a length are {}{}",
    "name those of the posts: --post CHANNEL=FL, or 'post_channels' in a study; and where the file has no units --unit "
    "CHANNEL=mm"};
inline const Finding kResponsePostsWithoutUnit{
    "response-posts-without-unit", Severity::kError, "channels of posts have no unit: {}",
    "state it: --unit '{}=mm', or 'post_channels: {{}: {channel: {}, unit: mm}}' in a study"};
inline const Finding kResponsePostUnit{
    "response-post-unit", Severity::kError, "channel '{}' of post '{}' has {}",
    "state it: --unit '{}=mm', or 'post_channels: {{}: {channel: {}, unit: mm}}' in a study"};
inline const Finding kResponsePostSize{"response-post-size", Severity::kError,
                                       "channel '{}' moves by {} mm, which no post of a rig for vehicles does",
                                       "state its unit: --unit '{}={}'"};
inline const Finding kResponseUnitOfNone{"response-unit-of-none", Severity::kError, "no channel '{}'{}",
                                         "correct the name in --unit"};
inline const Finding kResponsePostMissing{"response-post-missing", Severity::kError,
                                          "no channel '{}' of a length for post '{}'{}", "name that of the post"};
inline const Finding kResponsePostTwice{
    "response-post-twice", Severity::kError, "{} are named as the displacement of one post",
    "state the measured one of each post: --post '{}=NAME', or 'post_channels' in a study"};
inline const Finding kResponseWindowEmpty{"response-window-empty", Severity::kError,
                                          "'start' and 'end' leave no samples; the file goes from {} s to {} s",
                                          "correct 'start' and 'end'"};
inline const Finding kResponseReferenceUnknown{"response-reference-unknown", Severity::kError,
                                               "'{}' is not one of the posts, which are {}", "name one of these"};
inline const Finding kResponseNoChannel{"response-no-channel", Severity::kError,
                                        "no channel beside the posts has numbers in a unit of a length, force, "
                                        "acceleration or angular velocity",
                                        "write the unit of each channel below or behind its name, or state it: --unit "
                                        "CHANNEL=g"};
inline const Finding kResponseChannelsDiffer{"response-channels-differ", Severity::kError,
                                             "channel '{}' is not in {}, which is evaluated together with this file",
                                             "evaluate files with the same channels"};
inline const Finding kResponseKindsDiffer{"response-kinds-differ", Severity::kError,
                                          "this is a {}, the files before it are a {}",
                                          "evaluate them apart, or state --kind"};
inline const Finding kResponsePostsStill{"response-posts-still", Severity::kError, "no post moves",
                                         "name channels of posts that moved"};
inline const Finding kResponseNoDwell{"response-no-dwell", Severity::kError,
                                      "no dwell of a stepped sine: the post {} keeps no frequency for four cycles",
                                      "state the frequencies of the dwells, as by --kind stepped --frequencies "
                                      "0.5Hz:30Hz:0.1Hz; or --kind sweep or --kind random; or dwell longer"};
inline const Finding kResponseDwellsShort{"response-dwells-short", Severity::kError,
                                          "{} of post {} {} too short for a response, as that at {} Hz from {} to {} s",
                                          "dwell for {} cycles, {} s there; or state --kind sweep or --kind random"};
inline const Finding kResponseStatedNone{"response-stated-none", Severity::kError,
                                         "the post {} keeps none of the {} stated frequencies for three cycles",
                                         "check them; or state none, and dwells of four cycles are found"};
inline const Finding kResponseStatedMissing{"response-stated-missing", Severity::kWarning,
                                            "{} of {} stated frequencies have no dwell long enough: {}",
                                            "dwell for {} cycles, {} s at {} Hz; or do not state them"};
inline const Finding kResponseTooShort{"response-too-short", Severity::kError,
                                       "{} s are too short for a response at {} Hz",
                                       "record longer, or ask for higher --frequencies"};
inline const Finding kResponseNoPeriod{"response-no-period", Severity::kError,
                                       "the motion of post {} does not repeat itself within a whole number of samples",
                                       "record three periods at least, with rig and recorder on one clock; or state "
                                       "--kind random"};
inline const Finding kResponsePostsApart{"response-posts-apart", Severity::kError,
                                         "{} % of the posts' motion is no common pattern: they move independently, and "
                                         "responses to each cannot be separated",
                                         "move the posts in one pattern, or one of them at a time"};
inline const Finding kResponsePostsOff{
    "response-posts-off", Severity::kWarning,
    "{} % of the posts' motion in '{}' does not belong to the pattern {}, so that responses to it are off as much",
    "check sign, scale and delay of the posts' channels"};
inline const Finding kResponseFilterTooLow{"response-filter-too-low", Severity::kWarning,
                                           "the filter leaves {} % of the posts at {} Hz, so that their amplitude is "
                                           "poorly known there",
                                           "use frequencies up to twice its cut-off"};
inline const Finding kResponseNotSettled{
    "response-not-settled", Severity::kWarning,
    "{} of {} dwells were not settled after half of their cycles, as at {} Hz, so that these responses may still "
    "contain the run-in",
    "dwell longer; their standard deviations do not cover this"};
inline const Finding kResponseRandomNonlinear{
    "response-random-nonlinear", Severity::kWarning,
    "{} % of '{}' at {} Hz do not follow linearly from the posts (coherence {}): noise, or a vehicle that is not "
    "linear",
    "a multisine on an odd grid separates the two; to fit a model of dampers and friction record stepped sines, whose "
    "responses belong to an amplitude"};
inline const Finding kResponseMultisineNonlinear{
    "response-multisine-nonlinear", Severity::kWarning,
    "{} % of '{}' is distortion and {} % is noise: the response is a linear approximation for this motion only",
    "to fit a model of dampers and friction record stepped sines, whose responses belong to an amplitude"};
inline const Finding kResponseUnitUnknown{"response-unit-unknown", Severity::kWarning,
                                          "channels are left out, as their units are not known: {}",
                                          "write a unit such as mm, kN or m/s^2 below or behind each name, or state "
                                          "it: --unit CHANNEL=mm"};
inline const Finding kResponseLikePost{"response-like-post", Severity::kWarning,
                                       "'{}' moves as the posts do at every frequency, as if it were another of them",
                                       "name each post: --post {}=NAME"};
inline const Finding kResponsePostMisspelt{"response-post-misspelt", Severity::kError,
                                           "'{}' moves as the posts do and is nearly called '{}'",
                                           "correct the name, or state all posts: {}"};
inline const Finding kResponseChannelSilent{"response-channel-silent", Severity::kWarning,
                                            "channel '{}' does not move and is left out", "check its cable"};
}  // namespace fourpost
