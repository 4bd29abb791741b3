#include "analysis/frequency_response/dwells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "analysis/frequency_response/dwell_ends.h"
#include "analysis/frequency_response/straight_runs.h"

namespace fourpost {
namespace {

/// A tone that explains less of its window's variance is noise, or two tones at once.
constexpr double kTonalShare = 0.5;
/// Of the time with a tone, in a stepped sine.
constexpr double kMostInDwells = 0.5;

/// A dwell that a disturbance has parted in two.
bool AreOne(const Dwell& one, const Dwell& next) {
  constexpr double kGapCycles = 4;
  const double apart = std::abs(next.cycles_per_sample - one.cycles_per_sample);
  return (next.start - one.end) * one.cycles_per_sample < kGapCycles &&
         apart * std::min(one.end - one.start, next.end - next.start) < 0.03 &&
         std::abs(next.amplitude / one.amplitude - 1) < 0.1;
}

std::vector<Dwell> Joined(const std::vector<Dwell>& parts) {
  std::vector<Dwell> joined;
  for (const Dwell& part : parts) {
    if (joined.empty() || !AreOne(joined.back(), part)) {
      joined.push_back(part);
      continue;
    }
    Dwell& last = joined.back();
    const double own = last.end - last.start;
    const double more = part.end - part.start;
    last.cycles_per_sample = (own * last.cycles_per_sample + more * part.cycles_per_sample) / (own + more);
    last.end = part.end;
  }
  return joined;
}

/// Within a piece of a sweep the frequency changes as much as to the next piece.
bool IsPieceOfSweep(std::size_t index, const std::vector<Dwell>& dwells, double drift, double tolerance_rad) {
  constexpr double kShare = 1.0 / 3;
  // In cycles over the dwell. A piece of a sweep is as long as its phase looks straight: at its ends the phase is off a
  // line by pi / 6 of this.
  const double kSeen = 0.7 * tolerance_rad;
  constexpr double kGapCycles = 4;
  double nearest = std::numeric_limits<double>::infinity();
  const Dwell& own = dwells[index];
  const auto look = [&](const Dwell& before, const Dwell& after) {
    if ((after.start - before.end) * own.cycles_per_sample < kGapCycles)
      nearest = std::min(nearest, std::abs(after.cycles_per_sample - before.cycles_per_sample));
  };
  if (index > 0) look(dwells[index - 1], own);
  if (index + 1 < dwells.size()) look(own, dwells[index + 1]);
  return drift * (own.end - own.start) > kSeen && drift > kShare * nearest;
}

bool IsRest(const Dwell& dwell, double largest) {
  constexpr double kRest = 5e-3;
  return dwell.amplitude < kRest * largest;
}

/// Noise has a tone in every window. That of n samples explains a share s of their variance about as often as
/// (1 - s)^(n / 2), and there are some thousand windows in a record.
bool IsChance(const StraightRun& run, std::span<const TonePoint> track, const RunRule& rule) {
  constexpr double kEvidence = 20;
  const double samples =
      track[run.last].time - track[run.first].time + 0.5 * rule.window_cycles / run.cycles_per_sample;
  double left = 0;
  for (std::size_t k = run.first; k <= run.last; ++k) left += 1 - track[k].share;
  left /= static_cast<double>(run.last - run.first + 1);
  return -0.5 * samples * std::log(std::max(left, 1e-12)) < kEvidence;
}

std::vector<Dwell> DwellsOn(std::span<const TonePoint> track, const RunRule& rule, double fewest_cycles) {
  std::vector<Dwell> dwells;
  const std::vector<StraightRun> runs = FindStraightRuns(track, rule);
  double largest = 0;
  for (const StraightRun& run : runs) {
    dwells.push_back({.start = track[run.first].time,
                      .end = track[run.last].time,
                      .cycles_per_sample = run.cycles_per_sample,
                      .amplitude = run.amplitude});
    largest = std::max(largest, run.amplitude);
  }
  std::vector<Dwell> kept;
  for (std::size_t i = 0; i < dwells.size(); ++i)
    if (!IsRest(dwells[i], largest) && !IsChance(runs[i], track, rule) &&
        !IsPieceOfSweep(i, dwells, runs[i].drift, rule.tolerance_rad))
      kept.push_back(dwells[i]);
  kept = Joined(kept);
  std::erase_if(kept, [&](const Dwell& dwell) { return dwell.cycles() < fewest_cycles; });
  return kept;
}

bool Overlap(const Dwell& one, const Dwell& other) { return one.start < other.end && other.start < one.end; }

/// A long dwell takes the sharp ones of its frequency in its time, which noise has parted; one that lies astride others
/// gives way to them.
std::vector<Dwell> Together(std::vector<Dwell> sharp, const std::vector<Dwell>& more) {
  for (const Dwell& dwell : more) {
    const auto is_other = [&](const Dwell& one) {
      return Overlap(one, dwell) &&
             std::abs(one.cycles_per_sample - dwell.cycles_per_sample) * (one.end - one.start) > 0.1;
    };
    if (std::any_of(sharp.begin(), sharp.end(), is_other)) continue;
    Dwell all = dwell;
    for (const Dwell& one : sharp)
      if (Overlap(one, dwell)) {
        all.start = std::min(all.start, one.start);
        all.end = std::max(all.end, one.end);
      }
    std::erase_if(sharp, [&](const Dwell& one) { return Overlap(one, dwell); });
    sharp.push_back(all);
  }
  std::sort(sharp.begin(), sharp.end(), [](const Dwell& one, const Dwell& other) { return one.start < other.start; });
  return sharp;
}

template <typename Counts>
double TimeOf(std::span<const TonePoint> track, Counts counts) {
  double time = 0;
  for (std::size_t k = 1; k < track.size(); ++k)
    if (counts(track[k])) time += track[k].time - track[k - 1].time;
  return time;
}

/// Tones of the rig at rest, such as hum, do not count.
auto IsTone(std::span<const TonePoint> track) {
  double largest = 0;
  for (const TonePoint& point : track)
    if (point.share >= kTonalShare) largest = std::max(largest, point.amplitude);
  return [largest](const TonePoint& point) { return point.share >= kTonalShare && point.amplitude > 5e-3 * largest; };
}

}  // namespace

std::vector<Dwell> FindDwells(std::span<const double> signal, std::span<const TonePoint> track) {
  const std::vector<TonePoint> sharp = SharpTrack(signal, track);
  constexpr double kFewestBetween = 2.6;
  const RunRule short_runs = {.window_cycles = kSharpCycles, .seed = 9, .tolerance_rad = 0.03, .share = 0.95};
  std::vector<Dwell> dwells = WithSharpEnds(signal, Together(DwellsOn(sharp, short_runs, 2), DwellsOn(track, {}, 4)));
  if (ShareInDwells(track, dwells) < kMostInDwells) return dwells;
  return WithDwellsBetween(signal, sharp, std::move(dwells), kFewestBetween);
}

double ShareInDwells(std::span<const TonePoint> track, std::span<const Dwell> dwells) {
  const auto is_tone = IsTone(track);
  const auto is_inside = [&](const TonePoint& point) {
    return is_tone(point) && std::any_of(dwells.begin(), dwells.end(), [&](const Dwell& dwell) {
             return point.time >= dwell.start && point.time <= dwell.end;
           });
  };
  const double all = TimeOf(track, is_tone);
  return all > 0 ? TimeOf(track, is_inside) / all : 0;
}

double TonalShare(std::span<const TonePoint> track) {
  const auto is_tone = IsTone(track);
  double largest = 0;
  for (const TonePoint& point : track) largest = std::max(largest, point.amplitude);
  // Times of rest are no evidence either way.
  const double moving = TimeOf(track, [&](const TonePoint& point) { return point.amplitude > 5e-3 * largest; });
  return moving > 0 ? TimeOf(track, is_tone) / moving : 0;
}

}  // namespace fourpost
