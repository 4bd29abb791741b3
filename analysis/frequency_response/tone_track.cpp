#include "analysis/frequency_response/tone_track.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double kWindowCycles = 3;
/// Two windows a cycle, so that a frequency that is off by a tone's step still turns less than half a cycle between
/// them.
constexpr double kHopCycles = 0.5;

/// Means over blocks, of the signal and of its square, whose difference is all of the variance.
struct Blocks {
  std::size_t size = 1;
  std::vector<double> mean;
  std::vector<double> square;
};

Blocks BlocksOf(std::span<const double> signal, double offset, std::size_t size) {
  Blocks blocks{.size = size};
  const std::size_t count = signal.size() / size;
  blocks.mean.resize(count);
  blocks.square.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = k * size; i < (k + 1) * size; ++i) {
      const double value = signal[i] - offset;
      blocks.mean[k] += value;
      blocks.square[k] += value * value;
    }
    blocks.mean[k] /= static_cast<double>(size);
    blocks.square[k] /= static_cast<double>(size);
  }
  return blocks;
}

struct Window {
  double share = 0;
  Complex phasor;
};

/// Windows along the signal for one frequency.
class ToneFilter {
 public:
  ToneFilter(const Blocks& blocks, double cycles_per_sample)
      : block_(static_cast<double>(blocks.size)), cycles_(cycles_per_sample) {
    const double cycles_per_block = cycles_ * block_;
    half_ = static_cast<std::size_t>(std::max(2.0, std::round(0.5 * kWindowCycles / cycles_per_block)));
    hop_ = std::max<std::size_t>(1, static_cast<std::size_t>(kHopCycles / cycles_per_block));
    MakeKernel(cycles_per_block);
    // What an average over a block takes from a sine.
    const double x = pi * cycles_per_block;
    const double loss = blocks.size == 1 ? 1 : std::sin(x) / (block_ * std::sin(x / block_));
    for (std::size_t centre = half_; centre + half_ < blocks.mean.size(); centre += hop_)
      windows_.push_back(At(blocks, centre, loss));
  }

  bool empty() const { return windows_.empty(); }
  double cycles() const { return cycles_; }
  /// 0 next to the record's ends, where no window is.
  double ShareAt(double time) const {
    const std::size_t index = Index(time);
    return std::abs(TimeOf(index) - time) > static_cast<double>(hop_) * block_ ? 0 : windows_[index].share;
  }

  TonePoint PointNear(double time) const {
    const std::size_t index = Index(time);
    const Window& window = windows_[index];
    return {.time = TimeOf(index),
            .cycles_per_sample = FrequencyAt(index),
            .phase_rad = std::arg(window.phasor),
            .amplitude = std::abs(window.phasor),
            .share = window.share};
  }

 private:
  void MakeKernel(double cycles_per_block) {
    const std::size_t size = 2 * half_ + 1;
    double sum = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const double off = static_cast<double>(k) - static_cast<double>(half_);
      weight_.push_back(0.5 + 0.5 * std::cos(pi * off / (static_cast<double>(half_) + 1)));
      turn_.push_back(std::polar(1.0, -2 * pi * cycles_per_block * off));
      sum += weight_.back();
    }
    for (double& weight : weight_) weight /= sum;
  }

  Window At(const Blocks& blocks, std::size_t centre, double loss) const {
    double mean = 0;
    double square = 0;
    Complex sum;
    Complex leak;
    for (std::size_t k = 0; k < weight_.size(); ++k) {
      const double weight = weight_[k];
      const double value = weight * blocks.mean[centre - half_ + k];
      mean += value;
      square += weight * blocks.square[centre - half_ + k];
      sum += value * turn_[k];
      leak += weight * turn_[k];
    }
    const double variance = square - mean * mean;
    const Complex phasor = 2.0 * (sum - mean * leak) / loss;
    return {variance > 0 ? std::min(1.0, 0.5 * std::norm(phasor) / variance) : 0, phasor};
  }

  double TimeOf(std::size_t index) const { return (static_cast<double>(half_ + index * hop_) + 0.5) * block_ - 0.5; }

  std::size_t Index(double time) const {
    const double place = ((time + 0.5) / block_ - 0.5 - static_cast<double>(half_)) / static_cast<double>(hop_);
    return static_cast<std::size_t>(std::clamp(std::round(place), 0.0, static_cast<double>(windows_.size() - 1)));
  }

  /// By the turn from a window to the next.
  double FrequencyAt(std::size_t index) const {
    if (windows_.size() < 2) return cycles_;
    const std::size_t first = std::min(index, windows_.size() - 2);
    const double step = static_cast<double>(hop_) * block_;
    const Complex turn =
        windows_[first + 1].phasor * std::conj(windows_[first].phasor) * std::polar(1.0, -2 * pi * cycles_ * step);
    return cycles_ + std::arg(turn) / (2 * pi * step);
  }

  double block_;
  double cycles_;
  std::size_t half_ = 0;
  std::size_t hop_ = 1;
  std::vector<double> weight_;
  std::vector<Complex> turn_;
  std::vector<Window> windows_;
};

/// One window of `half` samples to both sides about a sample.
TonePoint PointAt(std::span<const double> signal, std::size_t centre, std::size_t half, double cycles_per_sample) {
  double mean = 0;
  double square = 0;
  double weights = 0;
  Complex sum;
  Complex leak;
  const double origin = signal[centre];
  const Complex window_step = std::polar(1.0, pi / (static_cast<double>(half) + 1));
  const Complex step = std::polar(1.0, -2 * pi * cycles_per_sample);
  Complex window = std::polar(1.0, -pi * static_cast<double>(half) / (static_cast<double>(half) + 1));
  Complex turn = std::polar(1.0, 2 * pi * cycles_per_sample * static_cast<double>(half));
  for (std::size_t k = centre - half; k <= centre + half; ++k, window *= window_step, turn *= step) {
    const double weight = 0.5 + 0.5 * window.real();
    const double value = signal[k] - origin;
    weights += weight;
    mean += weight * value;
    square += weight * value * value;
    sum += weight * value * turn;
    leak += weight * turn;
  }
  mean /= weights;
  const double variance = square / weights - mean * mean;
  const Complex phasor = 2.0 * (sum - mean * leak) / weights;
  return {.time = static_cast<double>(centre),
          .cycles_per_sample = cycles_per_sample,
          .phase_rad = std::arg(phasor),
          .amplitude = std::abs(phasor),
          .share = variance > 0 ? std::min(1.0, 0.5 * std::norm(phasor) / variance) : 0};
}

/// Next to a step the track sees two tones at once, half a window away only one.
const TonePoint& ClearestNear(std::span<const TonePoint> track, std::size_t index) {
  constexpr std::size_t kPoints = 3;
  const auto first = track.begin() + static_cast<std::ptrdiff_t>(index - std::min(index, kPoints));
  const auto last = track.begin() + static_cast<std::ptrdiff_t>(std::min(track.size(), index + kPoints + 1));
  return *std::max_element(first, last, [](const TonePoint& a, const TonePoint& b) { return a.share < b.share; });
}

std::vector<ToneFilter> FiltersOf(std::span<const double> signal) {
  constexpr double kStep = 1.189207115;  // A quarter of an octave.
  constexpr double kHighest = 0.3;
  constexpr double kFine = 0.03;
  const double offset = Mean(signal);
  std::vector<ToneFilter> filters;
  Blocks blocks = BlocksOf(signal, offset, 1);
  std::vector<double> tones;
  for (double tone = kHighest; tone * static_cast<double>(signal.size()) >= kWindowCycles; tone /= kStep)
    tones.push_back(tone);
  for (const double tone : tones) {
    const auto size = static_cast<std::size_t>(std::max(1.0, std::floor(kFine / tone)));
    if (size != blocks.size) blocks = BlocksOf(signal, offset, size);
    ToneFilter filter(blocks, tone);
    if (!filter.empty()) filters.push_back(std::move(filter));
  }
  return filters;
}

}  // namespace

std::vector<TonePoint> TrackTone(std::span<const double> signal) {
  constexpr std::size_t kLeast = 16;
  std::vector<TonePoint> track;
  if (signal.size() < kLeast || !(DeviationOf(signal) > 0)) return track;
  const std::vector<ToneFilter> filters = FiltersOf(signal);
  if (filters.empty()) return track;
  for (double time = 0; time < static_cast<double>(signal.size());) {
    const auto best = std::max_element(filters.begin(), filters.end(), [&](const ToneFilter& a, const ToneFilter& b) {
      return a.ShareAt(time) < b.ShareAt(time);
    });
    const TonePoint point = best->PointNear(time);
    // A window's centre is up to half a step away.
    if (track.empty() || point.time > track.back().time) track.push_back(point);
    time += std::max(1.0, kHopCycles / best->cycles());
  }
  return track;
}

std::vector<TonePoint> SharpTrack(std::span<const double> signal, std::span<const TonePoint> track) {
  constexpr double kHop = 0.25;
  constexpr std::size_t kFewestHalf = 8;
  std::vector<TonePoint> sharp;
  std::size_t near = 0;
  for (std::size_t centre = 0; !track.empty() && centre < signal.size();) {
    const double time = static_cast<double>(centre);
    while (near + 1 < track.size() && track[near + 1].time <= time) ++near;
    const double cycles = std::max(ClearestNear(track, near).cycles_per_sample, 1 / static_cast<double>(signal.size()));
    const auto half = std::max(kFewestHalf, static_cast<std::size_t>(std::round(0.5 * kSharpCycles / cycles)));
    if (centre >= half && centre + half < signal.size()) sharp.push_back(PointAt(signal, centre, half, cycles));
    // A point of silence has any frequency, even next to none: the track's own steps are shorter then.
    const double step = near + 1 < track.size() ? track[near + 1].time - track[near].time : 1 / cycles;
    centre += std::max<std::size_t>(1, static_cast<std::size_t>(std::min(kHop / cycles, 0.5 * step)));
  }
  return sharp;
}

}  // namespace fourpost
