#include "analysis/frequency_response/dwell_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/frequency_response/local_sine.h"
#include "analysis/frequency_response/sine_fit.h"

namespace fourpost {
namespace {

/// Of an amplitude, that the motion of a dwell may be off a sine.
constexpr double kOff = 0.04;

/// A stretch that is surely of the dwell.
struct Core {
  double first = 0;
  double last = 0;
};

/// How far a sine goes on from an end of its stretch.
class EndSearch {
 public:
  EndSearch(const SignalBlocks& blocks, double cycles_per_sample)
      : blocks_(blocks), cycles_per_sample_(cycles_per_sample), cycle_(1 / cycles_per_sample) {}

  double Last(const Core& core, double limit) const {
    const LocalSine sine = SineOn(std::max(core.first, core.last - kFitted * cycle_), core.last);
    double end = core.last;
    while (end + kBlock * cycle_ <= limit && Goes(sine, end, end + kBlock * cycle_)) end += kHop * cycle_;
    return std::min(limit, end + kSeen * cycle_);
  }

  double First(const Core& core, double limit) const {
    const LocalSine sine = SineOn(core.first, std::min(core.last, core.first + kFitted * cycle_));
    double begin = core.first;
    while (begin - kBlock * cycle_ >= limit && Goes(sine, begin - kBlock * cycle_, begin)) begin -= kHop * cycle_;
    return std::max(limit, begin - kSeen * cycle_);
  }

 private:
  static constexpr double kFitted = 3;
  static constexpr double kBlock = 0.25;
  static constexpr double kHop = 0.0625;
  /// What a block reaches beyond a step before it is seen there.
  static constexpr double kSeen = 0.125;

  LocalSine SineOn(double first, double last) const {
    return LocalSine(blocks_, blocks_.Place(first), blocks_.Place(last), cycles_per_sample_);
  }

  bool Goes(const LocalSine& sine, double first, double last) const {
    constexpr double kDeviations = 3;
    const std::size_t begin = blocks_.Place(first);
    const std::size_t end = std::min(blocks_.values.size(), std::max(blocks_.Place(last), begin + 2));
    if (end <= begin) return false;
    const double noise = std::pow(sine.rest(), 2) * (1 + kDeviations * std::sqrt(2 / static_cast<double>(end - begin)));
    return sine.SquareOff(blocks_, begin, end) < std::pow(kOff * sine.amplitude(), 2) + noise;
  }

  const SignalBlocks& blocks_;
  double cycles_per_sample_;
  double cycle_;
};

/// Of stretches whose ends are good to a cycle.
Core CoreOf(const Dwell& stretch) {
  constexpr double kLeast = 2;
  const double cycle = 1 / stretch.cycles_per_sample;
  const double middle = 0.5 * (stretch.start + stretch.end);
  const double half = std::max(0.5 * std::min(kLeast * cycle, stretch.end - stretch.start),
                               0.5 * (stretch.end - stretch.start) - cycle);
  return {middle - half, middle + half};
}

/// By all of the core where this is long.
double FrequencyOn(std::span<const double> signal, const SignalBlocks& blocks, const Core& core, double near,
                   double reach) {
  constexpr double kLong = 5;
  if ((core.last - core.first) * near > kLong) return RefinedFrequency(signal, core.first, core.last, near);
  constexpr int kRounds = 4;
  return BestSine(blocks, blocks.Place(core.first), blocks.Place(core.last), near, reach, kRounds).cycles_per_sample();
}

bool IsSine(const LocalSine& sine) {
  constexpr double kShare = 0.5;
  return sine.rest() < kShare * sine.amplitude();
}

/// Dwells between two others.
class GapSearch {
 public:
  GapSearch(std::span<const double> signal, std::span<const TonePoint> track, const std::vector<Dwell>& dwells,
            double fewest_cycles)
      : signal_(signal), track_(track), fewest_cycles_(fewest_cycles) {
    constexpr double kRest = 5e-3;
    for (const Dwell& dwell : dwells) least_amplitude_ = std::max(least_amplitude_, kRest * dwell.amplitude);
  }

  void Find(double low, double high, std::vector<Dwell>& found) const {
    const std::optional<Dwell> seed = StraightestSeed(low, high);
    if (!seed) return;
    const std::optional<Dwell> dwell = DwellAbout(signal_, *seed, low, high);
    if (dwell && dwell->cycles() >= fewest_cycles_ && EndsAtOnce(*dwell, low, high)) found.push_back(*dwell);
    const Dwell& taken = dwell ? *dwell : *seed;
    Find(low, std::min(taken.start, seed->start), found);
    Find(std::max(taken.end, seed->end), high, found);
  }

 private:
  static constexpr double kSeedCycles = 2;

  /// Two cycles that a sine explains best.
  std::optional<Dwell> StraightestSeed(double low, double high) const {
    constexpr double kMostRest = 0.25;
    std::optional<Dwell> best;
    double least = kMostRest;
    const auto first = std::lower_bound(track_.begin(), track_.end(), low,
                                        [](const TonePoint& point, double time) { return point.time < time; });
    for (auto point = first; point != track_.end() && point->time < high; ++point) {
      const double half = 0.5 * kSeedCycles / point->cycles_per_sample;
      // At the gap's ends a window may begin late.
      const double middle = std::clamp(point->time, low + half, std::max(low + half, high - half));
      if (middle + half > high + 0.2 * half || point->amplitude < least_amplitude_) continue;
      TakeBetter(
          {.start = middle - half, .end = std::min(high, middle + half), .cycles_per_sample = point->cycles_per_sample},
          best, least);
    }
    return best;
  }

  /// `least`: what a sine leaves of it, as a share of its amplitude.
  void TakeBetter(Dwell stretch, std::optional<Dwell>& best, double& least) const {
    constexpr double kReach = 0.25;
    constexpr int kRounds = 2;
    constexpr std::size_t kFewest = 16;
    const SignalBlocks blocks(signal_, stretch.start, stretch.end, stretch.cycles_per_sample);
    if (blocks.values.size() < kFewest) return;
    const LocalSine sine = BestSine(blocks, 0, blocks.values.size(), stretch.cycles_per_sample, kReach, kRounds);
    const double rest = sine.rest() / sine.amplitude();
    if (!(rest < least) || sine.amplitude() < least_amplitude_) return;
    least = rest;
    stretch.cycles_per_sample = sine.cycles_per_sample();
    stretch.amplitude = sine.amplitude();
    best = stretch;
  }

  /// At another dwell, or where the signal is off its sine by thrice of what it may be, a cycle on.
  bool EndsAtOnce(const Dwell& dwell, double low, double high) const {
    constexpr double kNear = 0.5;
    const double cycle = 1 / dwell.cycles_per_sample;
    return (dwell.start < low + kNear * cycle || IsOff(dwell, dwell.start - cycle)) &&
           (dwell.end > high - kNear * cycle || IsOff(dwell, dwell.end + 0.5 * cycle));
  }

  /// In half a cycle from there on.
  bool IsOff(const Dwell& dwell, double first) const {
    constexpr double kMuch = 3;
    const double last = first + 0.5 / dwell.cycles_per_sample;
    if (first < 0 || last > static_cast<double>(signal_.size())) return true;
    const SignalBlocks blocks(signal_, std::min(first, dwell.start), std::max(last, dwell.end),
                              dwell.cycles_per_sample);
    const LocalSine sine(blocks, blocks.Place(dwell.start), blocks.Place(dwell.end), dwell.cycles_per_sample);
    const double square = sine.SquareOff(blocks, blocks.Place(first), blocks.Place(last));
    return square > std::pow(kMuch * kOff * sine.amplitude(), 2) + std::pow(sine.rest(), 2);
  }

  std::span<const double> signal_;
  std::span<const TonePoint> track_;
  double fewest_cycles_;
  double least_amplitude_ = 0;
};

}  // namespace

std::optional<Dwell> DwellAbout(std::span<const double> signal, const Dwell& stretch, double low, double high) {
  constexpr double kReach = 0.05;
  constexpr double kFewest = 1.5;
  constexpr double kInside = 0.3;
  constexpr double kBeyond = 4;
  constexpr std::size_t kFewestBlocks = 12;
  const double margin = kBeyond / stretch.cycles_per_sample;
  const SignalBlocks blocks(signal, stretch.start - margin, stretch.end + margin, stretch.cycles_per_sample);
  Dwell dwell = stretch;
  Core core = CoreOf(stretch);
  low = std::max(low, 0.0);
  high = std::min(high, static_cast<double>(signal.size()));
  for (int round = 0; round < 2; ++round) {
    const std::size_t first = blocks.Place(core.first);
    const std::size_t last = blocks.Place(core.last);
    if (last < first + kFewestBlocks) return std::nullopt;
    dwell.cycles_per_sample = FrequencyOn(signal, blocks, core, dwell.cycles_per_sample, kReach);
    const LocalSine sine(blocks, first, last, dwell.cycles_per_sample);
    if (!IsSine(sine)) return std::nullopt;
    dwell.amplitude = sine.amplitude();
    const EndSearch search(blocks, dwell.cycles_per_sample);
    dwell.start = search.First(core, low);
    dwell.end = search.Last(core, high);
    if (dwell.cycles() < kFewest) return std::nullopt;
    const double inside = kInside / dwell.cycles_per_sample;
    core = {dwell.start + inside, dwell.end - inside};
  }
  return dwell;
}

std::vector<Dwell> WithSharpEnds(std::span<const double> signal, std::vector<Dwell> dwells) {
  constexpr double kBeyond = 3;
  for (Dwell& dwell : dwells) {
    const double beyond = kBeyond / dwell.cycles_per_sample;
    if (const std::optional<Dwell> sharp = DwellAbout(signal, dwell, dwell.start - beyond, dwell.end + beyond))
      dwell = *sharp;
  }
  for (std::size_t i = 1; i < dwells.size(); ++i) {
    if (dwells[i - 1].end <= dwells[i].start) continue;
    dwells[i - 1].end = dwells[i].start = 0.5 * (dwells[i - 1].end + dwells[i].start);
  }
  return dwells;
}

std::vector<Dwell> WithDwellsBetween(std::span<const double> signal, std::span<const TonePoint> track,
                                     std::vector<Dwell> dwells, double fewest_cycles) {
  const GapSearch search(signal, track, dwells, fewest_cycles);
  std::vector<Dwell> found;
  for (std::size_t i = 0; i <= dwells.size(); ++i)
    search.Find(i > 0 ? dwells[i - 1].end : 0, i < dwells.size() ? dwells[i].start : static_cast<double>(signal.size()),
                found);
  dwells.insert(dwells.end(), found.begin(), found.end());
  std::sort(dwells.begin(), dwells.end(), [](const Dwell& one, const Dwell& other) { return one.start < other.start; });
  return dwells;
}

}  // namespace fourpost
