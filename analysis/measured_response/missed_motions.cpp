#include "analysis/measured_response/missed_motions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/signals/median.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

/// What a post does between two dwells, or beside the first or the last one.
struct Between {
  /// First and last sample in which it is away from its middle.
  std::size_t first = 0;
  std::size_t last = 0;
  /// From one side to the other.
  int swings = 0;
  /// What the ends of the dwells may be off, in samples.
  double slack = 0;
};

Between LookAt(const std::vector<double>& post, std::size_t begin, std::size_t end, double amplitude) {
  constexpr double kMoves = 0.2;
  Between between{.first = begin, .last = begin};
  if (begin >= end) return between;
  const auto at = [&](std::size_t k) { return post.begin() + static_cast<std::ptrdiff_t>(k); };
  const double middle = Median(std::vector<double>(at(begin), at(end)));
  int side = 0;
  bool is_first = true;
  for (std::size_t k = begin; k < end; ++k) {
    if (std::abs(post[k] - middle) < kMoves * amplitude) continue;
    if (is_first) between.first = k;
    is_first = false;
    between.last = k;
    const int here = post[k] > middle ? 1 : -1;
    between.swings += side == -here ? 1 : 0;
    side = here;
  }
  return between;
}

/// One more than there are dwells.
std::vector<Between> LookBetween(const LookedAt& looked) {
  const std::vector<double>& post = looked.recording.heights[looked.largest_post];
  const std::vector<Dwell>& dwells = looked.dwells;
  std::vector<Between> all;
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
    all.push_back(LookAt(post, begin, end, amplitude));
    all.back().slack = slack;
    if (d < dwells.size()) begin = std::min(post.size(), static_cast<std::size_t>(dwells[d].end));
  }
  return all;
}

/// A rig may fade from each dwell to the next.
double UsualSwings(const std::vector<Between>& all) {
  std::vector<double> swings;
  for (std::size_t i = 1; i + 1 < all.size(); ++i) swings.push_back(all[i].swings);
  return swings.empty() ? 0 : Median(swings);
}

}  // namespace

std::vector<std::string> MotionsWithoutDwell(const LookedAt& looked, bool are_stated) {
  constexpr double kLong_s = 2;
  constexpr int kCycle = 2;
  constexpr double kSwings = 2 * kCycle;
  constexpr std::size_t kShown = 3;
  const double rate_Hz = looked.recording.rate_Hz;
  const std::vector<Between> all = LookBetween(looked);
  const double usual = UsualSwings(all);
  std::vector<std::string> list;
  std::size_t others = 0;
  for (const Between& between : all) {
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
