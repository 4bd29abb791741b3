#include "analysis/frequency_response/dwells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace fourpost {
namespace {

using std::numbers::pi;

/// A tone that explains less of its window's variance is noise, or two tones at once.
constexpr double kTonal = 0.5;

/// Straight line through phases, from sums about the first point.
class PhaseLine {
 public:
  explicit PhaseLine(const TonePoint& first) : origin_(first.time) { Add(first.time, first.phase_rad); }

  void Add(double time, double phase) {
    const double t = time - origin_;
    ++count_;
    t_ += t;
    p_ += phase;
    tt_ += t * t;
    tp_ += t * phase;
  }

  double slope() const {
    const double n = static_cast<double>(count_);
    return (n * tp_ - t_ * p_) / (n * tt_ - t_ * t_);
  }
  double At(double time) const {
    const double n = static_cast<double>(count_);
    return (p_ - slope() * t_) / n + slope() * (time - origin_);
  }

 private:
  double origin_;
  std::size_t count_ = 0;
  double t_ = 0;
  double p_ = 0;
  double tt_ = 0;
  double tp_ = 0;
};

/// The turn of `phase` that is nearest to `expected`.
double Unwrapped(double phase, double expected) { return phase + 2 * pi * std::round((expected - phase) / (2 * pi)); }

/// What noise may turn a phase by, beside 4 degrees, which a step of the frequency by 1 % reaches within a cycle or
/// two.
double Tolerance(const TonePoint& point) {
  constexpr double kLeast = 0.07;
  constexpr double kMost = 0.4;
  constexpr double kWindowCycles = 3;
  const double noise = (1 - point.share) / std::max(kTonal, point.share);
  const double independent = std::max(1.0, 0.5 * kWindowCycles / point.cycles_per_sample);
  return std::min(kMost, kLeast + 4 * std::sqrt(noise / independent));
}

/// A run of points on one line.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  double slope = 0;
  double amplitude = 0;
  /// By which the frequency changes from end to end.
  double drift = 0;
};

class RunFinder {
 public:
  explicit RunFinder(std::span<const TonePoint> track) : track_(track) {}

  std::vector<Run> Find() const {
    std::vector<Run> runs;
    for (std::size_t first = 0; first + kSeed <= track_.size();) {
      const std::size_t last = End(first);
      if (last == first) {
        ++first;
        continue;
      }
      runs.push_back(MakeRun(first, last));
      first = last + 1;
    }
    return runs;
  }

 private:
  /// Two and a half cycles.
  static constexpr std::size_t kSeed = 6;

  /// The last point on the line that begins at `first`; `first` itself where there is none.
  std::size_t End(std::size_t first) const {
    if (!IsSeed(first)) return first;
    PhaseLine line(track_[first]);
    double phase = track_[first].phase_rad;
    double amplitude = track_[first].amplitude;
    for (std::size_t k = first + 1; k < first + kSeed; ++k) {
      phase = Unwrapped(track_[k].phase_rad, phase + Turn(k));
      line.Add(track_[k].time, phase);
      amplitude += track_[k].amplitude;
    }
    amplitude /= kSeed;
    phase = track_[first].phase_rad;
    for (std::size_t k = first; k < first + kSeed; ++k) {
      if (k > first) phase = Unwrapped(track_[k].phase_rad, phase + Turn(k));
      if (std::abs(phase - line.At(track_[k].time)) > Tolerance(track_[k])) return first;
    }
    std::size_t last = first + kSeed - 1;
    double mean = amplitude;
    // A point that noise moves must not end a dwell: two in a row do.
    int off = 0;
    for (std::size_t k = last + 1; k < track_.size() && off < 2; ++k) {
      if (!Follows(k)) break;
      const double expected = line.At(track_[k].time);
      const double turned = Unwrapped(track_[k].phase_rad, expected);
      if (track_[k].share < kTonal || std::abs(turned - expected) > Tolerance(track_[k]) ||
          !IsNear(track_[k].amplitude, mean, track_[k])) {
        ++off;
        continue;
      }
      off = 0;
      line.Add(track_[k].time, turned);
      last = k;
      mean += (track_[k].amplitude - mean) / static_cast<double>(std::min<std::size_t>(k - first + 1, 40));
    }
    return last;
  }

  bool IsSeed(std::size_t first) const {
    for (std::size_t k = first; k < first + kSeed; ++k) {
      if (track_[k].share < kTonal) return false;
      if (k > first && !Follows(k)) return false;
      if (!IsNear(track_[k].amplitude, track_[first].amplitude, track_[k])) return false;
      if (std::abs(track_[k].cycles_per_sample / track_[first].cycles_per_sample - 1) > 0.2) return false;
    }
    return true;
  }

  /// No more than a cycle and a half behind the one before.
  bool Follows(std::size_t k) const {
    return (track_[k].time - track_[k - 1].time) * track_[k].cycles_per_sample < 1.5;
  }

  static bool IsNear(double amplitude, double other, const TonePoint& point) {
    constexpr double kChange = 0.1;
    return std::abs(amplitude / other - 1) < kChange + Tolerance(point);
  }

  double Turn(std::size_t k) const {
    return pi * (track_[k].cycles_per_sample + track_[k - 1].cycles_per_sample) * (track_[k].time - track_[k - 1].time);
  }

  Run MakeRun(std::size_t first, std::size_t last) const {
    Run run{.first = first, .last = last};
    run.slope = SlopeOf(first, last);
    // Medians do not care for the ends, into which the neighbours reach.
    std::vector<double> amplitudes;
    for (std::size_t k = first; k <= last; ++k) amplitudes.push_back(track_[k].amplitude);
    const auto middle = amplitudes.begin() + static_cast<std::ptrdiff_t>(amplitudes.size() / 2);
    std::nth_element(amplitudes.begin(), middle, amplitudes.end());
    run.amplitude = *middle;
    const std::size_t half = (first + last) / 2;
    // From the middle of one half to that of the other is half the run.
    run.drift = 2 * std::abs(SlopeOf(half, last) - SlopeOf(first, half)) / (2 * pi);
    return run;
  }

  double SlopeOf(std::size_t first, std::size_t last) const {
    PhaseLine line(track_[first]);
    double phase = track_[first].phase_rad;
    for (std::size_t k = first + 1; k <= last; ++k) {
      phase = Unwrapped(track_[k].phase_rad, phase + Turn(k));
      line.Add(track_[k].time, phase);
    }
    return line.slope();
  }

  std::span<const TonePoint> track_;
};

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
bool IsPieceOfSweep(std::size_t index, const std::vector<Dwell>& dwells, double drift) {
  constexpr double kShare = 1.0 / 3;
  // In cycles over the dwell; a piece of a sweep is as long as its phase looks straight, which is a fifth of a cycle.
  constexpr double kSeen = 0.05;
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
    if (point.share >= kTonal) largest = std::max(largest, point.amplitude);
  return [largest](const TonePoint& point) { return point.share >= kTonal && point.amplitude > 5e-3 * largest; };
}

}  // namespace

std::vector<Dwell> FindDwells(std::span<const TonePoint> track) {
  constexpr double kFewestCycles = 4;
  std::vector<Dwell> dwells;
  std::vector<double> drifts;
  for (const Run& run : RunFinder(track).Find()) {
    const Dwell dwell{.start = track[run.first].time,
                      .end = track[run.last].time,
                      .cycles_per_sample = run.slope / (2 * pi),
                      .amplitude = run.amplitude};
    dwells.push_back(dwell);
    drifts.push_back(run.drift);
  }
  double largest = 0;
  for (const Dwell& dwell : dwells) largest = std::max(largest, dwell.amplitude);
  std::vector<Dwell> kept;
  for (std::size_t i = 0; i < dwells.size(); ++i)
    if (!IsRest(dwells[i], largest) && !IsPieceOfSweep(i, dwells, drifts[i])) kept.push_back(dwells[i]);
  kept = Joined(kept);
  std::erase_if(kept, [](const Dwell& dwell) { return dwell.cycles() < kFewestCycles; });
  return kept;
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
