#include "analysis/frequency_response/straight_runs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "analysis/frequency_response/phase_line.h"

namespace fourpost {
namespace {

using std::numbers::pi;

class RunFinder {
 public:
  RunFinder(std::span<const TonePoint> track, const RunRule& rule)
      : track_(track), rule_(rule), is_taken_(track.size(), false) {
    for (std::size_t k = 0; k < track_.size(); ++k) {
      const TonePoint& point = track_[k];
      phase_.push_back(k == 0 ? point.phase_rad : Unwrapped(point.phase_rad, phase_.back() + Turn(k)));
      tolerance_.push_back(ToleranceOf(point));
    }
  }

  std::vector<StraightRun> Find() {
    std::vector<Grown> grown;
    for (const std::size_t first : SeedsByStraightness()) {
      const auto begin = is_taken_.begin() + static_cast<std::ptrdiff_t>(first);
      if (std::any_of(begin, begin + static_cast<std::ptrdiff_t>(rule_.seed), [](bool taken) { return taken; }))
        continue;
      grown.push_back(GrownFrom(first));
      for (std::size_t k = grown.back().first; k <= grown.back().last; ++k) is_taken_[k] = true;
    }
    std::sort(grown.begin(), grown.end(), [](const Grown& one, const Grown& other) { return one.first < other.first; });
    for (std::size_t i = 1; i < grown.size(); ++i) Share(grown[i - 1], grown[i]);
    std::vector<StraightRun> runs;
    for (const Grown& each : grown) runs.push_back(MakeRun(each));
    return runs;
  }

 private:
  struct Grown {
    std::size_t first = 0;
    std::size_t last = 0;
    PhaseLine line;
  };

  /// Points at the end of a run belong to the next one if they are nearer to its line.
  void Share(Grown& before, Grown& after) const {
    while (after.first == before.last + 1 && before.last > before.first + rule_.seed &&
           Off(after.line, before.last) < Off(before.line, before.last)) {
      --before.last;
      --after.first;
    }
  }

  double Off(const PhaseLine& line, std::size_t k) const {
    const double expected = line.At(track_[k].time);
    return std::abs(Unwrapped(track_[k].phase_rad, expected) - expected);
  }

  /// Beside what a step of the frequency by 1 % reaches within a cycle or two, what noise may turn a phase by.
  double ToleranceOf(const TonePoint& point) const {
    constexpr double kMost = 0.4;
    const double noise = (1 - point.share) / std::max(rule_.share, point.share);
    const double independent = std::max(1.0, 0.5 * rule_.window_cycles / point.cycles_per_sample);
    return std::min(kMost, rule_.tolerance_rad + 4 * std::sqrt(noise / independent));
  }

  /// First points of seeds; those whose phases are nearest to a line come first.
  std::vector<std::size_t> SeedsByStraightness() const {
    struct Seed {
      std::size_t first = 0;
      double off = 0;
    };
    std::vector<Seed> seeds;
    for (std::size_t first = 0; first + rule_.seed <= track_.size(); ++first) {
      if (!IsTone(first)) continue;
      const PhaseLine line = LineThrough(first, first + rule_.seed - 1);
      double square = 0;
      bool is_straight = true;
      for (std::size_t k = first; k < first + rule_.seed; ++k) {
        const double off = phase_[k] - line.At(track_[k].time);
        square += off * off;
        is_straight = is_straight && std::abs(off) <= tolerance_[k];
      }
      if (is_straight) seeds.push_back({first, square});
    }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [](const Seed& one, const Seed& other) { return one.off < other.off; });
    std::vector<std::size_t> order;
    for (const Seed& seed : seeds) order.push_back(seed.first);
    return order;
  }

  /// Whether the points of a seed are of one tone.
  bool IsTone(std::size_t first) const {
    for (std::size_t k = first; k < first + rule_.seed; ++k) {
      if (track_[k].share < rule_.share) return false;
      if (k > first && !Follows(k)) return false;
      if (!IsNear(k, track_[first].amplitude)) return false;
      if (std::abs(track_[k].cycles_per_sample / track_[first].cycles_per_sample - 1) > 0.2) return false;
    }
    return true;
  }

  Grown GrownFrom(std::size_t seed) const {
    std::size_t first = seed;
    std::size_t last = seed + rule_.seed - 1;
    PhaseLine line = LineThrough(first, last);
    double mean = 0;
    for (std::size_t k = first; k <= last; ++k) mean += track_[k].amplitude / static_cast<double>(rule_.seed);
    const auto takes = [&](std::size_t k) {
      const double expected = line.At(track_[k].time);
      const double turned = Unwrapped(track_[k].phase_rad, expected);
      if (track_[k].share < rule_.share || std::abs(turned - expected) > tolerance_[k] || !IsNear(k, mean))
        return false;
      line.Add(track_[k].time, turned);
      mean += (track_[k].amplitude - mean) / static_cast<double>(std::min<std::size_t>(last - first + 2, 40));
      return true;
    };
    // What is found on one side makes the line longer, by which more is found on the other.
    for (std::size_t size = 0; size < last - first + 1;) {
      size = last - first + 1;
      int off = 0;
      for (std::size_t k = last + 1; k < track_.size() && off < 2 && !is_taken_[k] && Follows(k); ++k) {
        if (takes(k)) {
          off = 0;
          last = k;
        } else {
          ++off;
        }
      }
      off = 0;
      for (std::size_t k = first; k > 0 && off < 2 && !is_taken_[k - 1] && Follows(k); --k) {
        if (takes(k - 1)) {
          off = 0;
          first = k - 1;
        } else {
          ++off;
        }
      }
    }
    return {first, last, line};
  }

  /// No more than a cycle and a half behind the one before.
  bool Follows(std::size_t k) const {
    return (track_[k].time - track_[k - 1].time) * track_[k].cycles_per_sample < 1.5;
  }

  bool IsNear(std::size_t k, double other) const {
    constexpr double kChange = 0.1;
    return std::abs(track_[k].amplitude / other - 1) < kChange + tolerance_[k];
  }

  double Turn(std::size_t k) const {
    return pi * (track_[k].cycles_per_sample + track_[k - 1].cycles_per_sample) * (track_[k].time - track_[k - 1].time);
  }

  StraightRun MakeRun(const Grown& grown) const {
    const auto& [first, last, line] = grown;
    StraightRun run{.first = first, .last = last, .cycles_per_sample = line.slope() / (2 * pi)};
    // Medians do not care for the ends, into which the neighbours reach.
    std::vector<double> amplitudes;
    for (std::size_t k = first; k <= last; ++k) amplitudes.push_back(track_[k].amplitude);
    const auto middle = amplitudes.begin() + static_cast<std::ptrdiff_t>(amplitudes.size() / 2);
    std::nth_element(amplitudes.begin(), middle, amplitudes.end());
    run.amplitude = *middle;
    const std::size_t half = (first + last) / 2;
    // From the middle of one half to that of the other is half the run.
    run.drift = 2 * std::abs(SlopeAlong(line, half, last) - SlopeAlong(line, first, half)) / (2 * pi);
    return run;
  }

  /// Of the points that lie on a line.
  double SlopeAlong(const PhaseLine& line, std::size_t first, std::size_t last) const {
    PhaseLine part(track_[first].time);
    for (std::size_t k = first; k <= last; ++k) {
      const double expected = line.At(track_[k].time);
      const double turned = Unwrapped(track_[k].phase_rad, expected);
      if (std::abs(turned - expected) <= tolerance_[k]) part.Add(track_[k].time, turned);
    }
    return part.count() > 1 ? part.slope() : line.slope();
  }

  PhaseLine LineThrough(std::size_t first, std::size_t last) const {
    PhaseLine line(track_[first].time);
    for (std::size_t k = first; k <= last; ++k) line.Add(track_[k].time, phase_[k]);
    return line;
  }

  std::span<const TonePoint> track_;
  RunRule rule_;
  /// Of each point, unwrapped from one to the next.
  std::vector<double> phase_;
  std::vector<double> tolerance_;
  std::vector<bool> is_taken_;
};

}  // namespace

std::vector<StraightRun> FindStraightRuns(std::span<const TonePoint> track, const RunRule& rule) {
  return RunFinder(track, rule).Find();
}

}  // namespace fourpost
