#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/text/found.h"
#include "identify/experiments/time_history/remedied_error.h"
#include "identify/residuals/history_misfit.h"

namespace fourpost {

/// An oddity of a channel of a history, or of the height of its posts, with the study's remedy.
struct HistoryRemark {
  enum class Cause { kSwapped, kUnit, kSign, kDelay };
  Cause cause = Cause::kDelay;
  std::string recording;
  /// A sensor; empty: the posts.
  std::string channel;
  Found found;
};

using MisfitsOfOne = std::span<const HistoryMisfit>;

/// Channels that are swapped, and those whose error nearly goes with another unit, with the other sign, or with a delay
/// of more than `sample_s`. Of several channels the odd one out is reported, the farthest from the delay that they have
/// in common; where that is larger, the posts. A channel of another scale moves the model, and with it all delays,
/// which are not reported then. Each has a remedy in the terms of the study and the error that it leaves by itself, by
/// `errors`; where one of unit, sign or delay leaves much, a scale or a delay comes with it.
std::vector<HistoryRemark> RemarksOn(const std::vector<HistoryMisfit>& misfits, double sample_s,
                                     const RemediedErrors& errors);

/// Of one recording that posts alone move: its channels come earlier or later than the model, all alike.
std::optional<HistoryRemark> PostDelay(std::span<const HistoryMisfit> misfits, double sample_s);

/// What takes back that this channel comes `delay_s` later than it should, in the terms of the study.
std::string DelayRemedy(const HistoryMisfit& misfit, double delay_s);

/// "20.2 ms later".
std::string Lateness(double delay_s);

/// Delays of one recording's channels against the model that they have in common, their median; nothing without any.
std::optional<double> CommonDelay(std::span<const HistoryMisfit> misfits);

/// The misfits of each recording, which follow each other.
std::vector<std::span<const HistoryMisfit>> ByRecording(const std::vector<HistoryMisfit>& misfits);

}  // namespace fourpost
