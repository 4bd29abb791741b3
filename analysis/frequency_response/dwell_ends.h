#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"

namespace fourpost {

/// The dwell about a stretch in which a signal is a sine, whose ends are good to a fraction of a cycle: a sine with its
/// first overtone is fitted to the last three cycles at each end of the stretch and goes on to there where the signal
/// leaves it by more than 4 % of its amplitude and what noise allows. Not beyond `low` and `high` [samples]. Nothing
/// where the stretch is no sine, or shorter than a cycle and a half.
std::optional<Dwell> DwellAbout(std::span<const double> signal, const Dwell& stretch, double low, double high);

/// The dwells with ends as DwellAbout() finds them within three cycles, next to each other none of which overlap; as
/// they are where it does not.
std::vector<Dwell> WithSharpEnds(std::span<const double> signal, std::vector<Dwell> dwells);

/// Dwells of `fewest_cycles` in what dwells with sharp ends leave: stretches of a sine, between others, that both end
/// at once, as no piece of a sweep does. `track`: SharpTrack() of the signal. In order, all together.
std::vector<Dwell> WithDwellsBetween(std::span<const double> signal, std::span<const TonePoint> track,
                                     std::vector<Dwell> dwells, double fewest_cycles);

}  // namespace fourpost
