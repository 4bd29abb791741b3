#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// The strongest tone about one moment of a signal.
struct TonePoint {
  /// Samples from the signal's first.
  double time = 0;
  double cycles_per_sample = 0;
  /// Of a cosine, at `time`.
  double phase_rad = 0;
  /// In the signal's unit.
  double amplitude = 0;
  /// Of the variance about `time`, within its window; 1: nothing but the tone.
  double share = 0;
};

/// A signal's strongest tone over time, a point each half cycle of it. Tones are looked for in steps of a quarter
/// octave, each under Hann's window over three of its cycles, from three cycles in the record to 0.3 cycles per sample;
/// the one that explains the largest share of the variance in its own window is taken. Below 0.03 cycles per sample the
/// signal is averaged over blocks first, which turns no phase. Nothing of a constant signal, and of less than 16
/// samples.
std::vector<TonePoint> TrackTone(std::span<const double> signal);

/// Of SharpTrack().
constexpr double kSharpCycles = 2;

/// The same tone by shorter windows, Hann's over two of its cycles and 16 samples at least, a point each quarter cycle:
/// it sees a step a cycle away, and more noise. The windows are those of the frequencies of `track`, but for its phase,
/// so that the zeros of Hann's spectrum lie at mean and harmonics.
std::vector<TonePoint> SharpTrack(std::span<const double> signal, std::span<const TonePoint> track);

}  // namespace fourpost
