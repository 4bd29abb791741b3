#include "analysis/measured_response/missed_motions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "analysis/signals/median.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

/// What a post does between two dwells, or beside the first or the last one, from one pause to the next.
struct Between {
  /// First and last sample in which it is away from its middle.
  std::size_t first = 0;
  std::size_t last = 0;
  /// From one side to the other.
  int swings = 0;
  /// What the ends of the dwells may be off, in samples.
  double slack = 0;
};

/// Samples in a row on one side of the middle: 1, -1, or 0 near it.
struct SideRun {
  std::size_t first = 0;
  std::size_t last = 0;
  int side = 0;
  /// Farthest from the middle.
  double peak = 0;

  std::size_t samples() const { return last - first + 1; }
  double middle() const { return 0.5 * static_cast<double>(first + last); }
};

std::vector<SideRun> SideRuns(const std::vector<double>& post, std::size_t begin, std::size_t end, double amplitude) {
  constexpr double kMoves = 0.2;
  std::vector<SideRun> runs;
  if (begin >= end) return runs;
  const auto at = [&](std::size_t k) { return post.begin() + static_cast<std::ptrdiff_t>(k); };
  const double middle = Median(std::vector<double>(at(begin), at(end)));
  for (std::size_t k = begin; k < end; ++k) {
    const double off = post[k] - middle;
    const int side = std::abs(off) < kMoves * amplitude ? 0 : off > 0 ? 1 : -1;
    if (runs.empty() || runs.back().side != side) runs.push_back({k, k, side});
    runs.back().last = k;
    runs.back().peak = std::max(runs.back().peak, std::abs(off));
  }
  return runs;
}

/// Of swings from a dwell's end on, or back from its begin, how many fade: at the dwell's frequency each smaller than the
/// one before, but for two cycles by which the end may be off. The first one may be cut.
std::size_t FadingSwings(const std::vector<SideRun>& swings, double end, const Dwell& dwell) {
  constexpr double kSmaller = 0.02;
  constexpr double kOff = 0.3;
  constexpr std::size_t kCut = 2;
  constexpr std::size_t kOfEnd = 4;
  const double half = 0.5 / dwell.cycles_per_sample;
  // Samples miss peaks by up to this.
  const double sampled = (1 - std::cos(std::numbers::pi * dwell.cycles_per_sample)) * dwell.amplitude;
  double at = end;
  double peak = dwell.amplitude;
  std::size_t count = 0;
  for (const SideRun& swing : swings) {
    const bool is_next = count < kCut ? std::abs(swing.middle() - end) < 3 * half
                                      : std::abs(std::abs(swing.middle() - at) - half) < kOff * half;
    const double most =
        count < kOfEnd ? (1 + kSmaller) * dwell.amplitude : peak - kSmaller * dwell.amplitude;
    if (!is_next || swing.peak > most + sampled) break;
    at = swing.middle();
    peak = swing.peak;
    ++count;
  }
  return count;
}

/// Without what fades behind one dwell and in before the next; null beside the first and the last one.
std::vector<SideRun> WithoutFades(const std::vector<SideRun>& runs, const Dwell* before, const Dwell* after) {
  std::vector<SideRun> swings;
  for (const SideRun& run : runs)
    if (run.side != 0) swings.push_back(run);
  const std::size_t first = before == nullptr ? 0 : FadingSwings(swings, before->end, *before);
  std::reverse(swings.begin(), swings.end());
  const std::size_t last = after == nullptr ? 0 : FadingSwings(swings, after->start, *after);
  std::vector<SideRun> left;
  std::size_t number = 0;
  for (const SideRun& run : runs) {
    if (run.side != 0) ++number;
    if (number > first && number + last <= swings.size()) left.push_back(run);
  }
  return left;
}

/// How long a post stays near its middle where it rests: longer than it does between two swings.
double PauseOf(const std::vector<SideRun>& runs, double rate_Hz) {
  constexpr double kShortest_s = 0.5;
  constexpr double kOfSwing = 1.5;
  double longest = 0;
  for (const SideRun& run : runs)
    if (run.side != 0) longest = std::max(longest, static_cast<double>(run.samples()));
  return std::max(kShortest_s * rate_Hz, kOfSwing * longest);
}

/// Its motions, which pauses part; none where it rests.
std::vector<Between> MotionsOf(const std::vector<SideRun>& runs, double rate_Hz) {
  const double pause = PauseOf(runs, rate_Hz);
  std::vector<Between> motions;
  int side = 0;
  for (const SideRun& run : runs) {
    if (run.side == 0) {
      if (static_cast<double>(run.samples()) > pause) side = 0;
      continue;
    }
    if (side == 0) motions.push_back({.first = run.first});
    motions.back().last = run.last;
    motions.back().swings += side == -run.side ? 1 : 0;
    side = run.side;
  }
  return motions;
}

/// The motions of each time between dwells, of which there is one more than of dwells.
std::vector<std::vector<Between>> LookBetween(const LookedAt& looked) {
  const std::vector<double>& post = looked.recording.heights[looked.largest_post];
  const std::vector<Dwell>& dwells = looked.dwells;
  std::vector<std::vector<Between>> all;
  std::size_t begin = 0;
  for (std::size_t d = 0; d <= dwells.size(); ++d) {
    const std::size_t end =
        d < dwells.size() ? std::min(post.size(), static_cast<std::size_t>(dwells[d].start)) : post.size();
    double amplitude = std::numeric_limits<double>::infinity();
    double slack = 0;
    for (const std::size_t next : {d - 1, d})
      if (next < dwells.size()) {
        amplitude = std::min(amplitude, dwells[next].amplitude);
        slack += 1 / dwells[next].cycles_per_sample;
      }
    const Dwell* const before = d > 0 ? &dwells[d - 1] : nullptr;
    const Dwell* const after = d < dwells.size() ? &dwells[d] : nullptr;
    all.push_back(
        MotionsOf(WithoutFades(SideRuns(post, begin, end, amplitude), before, after), looked.recording.rate_Hz));
    for (Between& motion : all.back()) motion.slack = slack;
    if (d < dwells.size()) begin = std::min(post.size(), static_cast<std::size_t>(dwells[d].end));
  }
  return all;
}

/// A rig may go from each dwell to the next by motions of its own.
double UsualSwings(const std::vector<std::vector<Between>>& all) {
  std::vector<double> swings;
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    int most = 0;
    for (const Between& motion : all[i]) most = std::max(most, motion.swings);
    swings.push_back(most);
  }
  return swings.empty() ? 0 : Median(swings);
}

}  // namespace

std::vector<std::string> MotionsWithoutDwell(const LookedAt& looked, bool are_stated) {
  constexpr double kLong_s = 2;
  constexpr int kCycle = 2;
  constexpr double kSwings = 2 * kCycle;
  constexpr std::size_t kShown = 3;
  const double rate_Hz = looked.recording.rate_Hz;
  const std::vector<std::vector<Between>> all = LookBetween(looked);
  const double usual = UsualSwings(all);
  std::vector<std::string> list;
  std::size_t others = 0;
  for (const std::vector<Between>& motions : all)
    for (const Between& between : motions) {
      // A ramp to another height swings less than a cycle.
      const bool is_long = between.swings >= kCycle &&
                           static_cast<double>(between.last - between.first) > kLong_s * rate_Hz + between.slack;
      if (!is_long && between.swings < kSwings + usual) continue;
      if (list.size() == kShown) {
        ++others;
        continue;
      }
      list.push_back("no dwell was found from " + Rounded(static_cast<double>(between.first) / rate_Hz, 3) + " to " +
                     Rounded(static_cast<double>(between.last) / rate_Hz, 3) +
                     " s, where the posts move: left out; dwell for ten cycles" +
                     (are_stated ? "" : ", or state the frequencies by `fourpost frf --frequencies`"));
    }
  if (others > 0) list.back() += "; so are " + std::to_string(others) + " other motions";
  return list;
}

}  // namespace fourpost
