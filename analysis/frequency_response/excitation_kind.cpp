#include "analysis/frequency_response/excitation_kind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <unsupported/Eigen/FFT>

#include "analysis/frequency_response/multisine.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/noise_floor.h"

namespace fourpost {
namespace {

/// The share of the signal's power, of that in dwells where there are some, that one tone at a time explains, in
/// windows of two cycles; white noise does not count against it.
double LoneShare(std::span<const double> signal, std::span<const TonePoint> track, std::span<const Dwell> dwells) {
  const auto is_inside = [&](const TonePoint& point) {
    return dwells.empty() || std::any_of(dwells.begin(), dwells.end(), [&](const Dwell& dwell) {
             return point.time >= dwell.start && point.time <= dwell.end;
           });
  };
  const std::vector<TonePoint> sharp = SharpTrack(signal, track);
  double tones = 0;
  double all = 0;
  for (std::size_t k = 1; k < sharp.size(); ++k) {
    if (!is_inside(sharp[k])) continue;
    const double energy = sharp[k].amplitude * sharp[k].amplitude * (sharp[k].time - sharp[k - 1].time);
    tones += energy;
    if (sharp[k].share > 0) all += energy / sharp[k].share;
  }
  const double noise = NoiseFloor(signal) / DeviationOf(signal);
  return all > 0 ? std::min(1.0, tones / all + noise * noise) : 0;
}

/// What a signal that repeats itself consists of.
struct PeriodPower {
  /// Shares of all that repeats: about the strongest line, a sixth of an octave to both sides; and of the lines that
  /// are neither this one nor a harmonic of it.
  double near_strongest = 0;
  double beside_harmonics = 0;
};

/// The mean over whole periods, and of its lines what noise has there.
PeriodPower PowerIn(std::span<const double> signal, std::size_t period) {
  const std::size_t periods = signal.size() / period;
  std::vector<double> mean(period);
  for (std::size_t k = 0; k < periods * period; ++k) mean[k % period] += signal[k] / static_cast<double>(periods);
  double noise = 0;
  for (std::size_t k = 0; k < periods * period; ++k) noise += std::pow(signal[k] - mean[k % period], 2);
  noise /= static_cast<double>(period * periods) * static_cast<double>(periods - 1);
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> spectrum;
  transform.fwd(spectrum, mean);
  std::vector<double> power(spectrum.size());
  const double scale = 2 / std::pow(static_cast<double>(period), 2);
  const double noise_of_line = noise / static_cast<double>(spectrum.size());
  double all = 0;
  for (std::size_t k = 1; k < power.size(); ++k) all += power[k] = scale * std::norm(spectrum[k]) - noise_of_line;
  const auto strongest = static_cast<std::size_t>(std::max_element(power.begin() + 1, power.end()) - power.begin());
  constexpr double kSixth = 1.1224620483;
  PeriodPower out;
  for (std::size_t k = 1; k < power.size(); ++k) {
    const double ratio = static_cast<double>(k) / static_cast<double>(strongest);
    if (ratio < kSixth && ratio > 1 / kSixth) out.near_strongest += power[k] / all;
    if (k % strongest != 0) out.beside_harmonics += power[k] / all;
  }
  return out;
}

/// Of a signal that repeats itself: whether tones sound together in it, and not one after the other.
bool HasTonesTogether(std::span<const double> signal, std::size_t period, bool is_lone) {
  // Beating tones within a third of an octave look like one.
  constexpr double kMost = 0.5;
  // A line of a tenth of the strongest one's amplitude.
  constexpr double kOneMore = 0.01;
  const PeriodPower power = PowerIn(signal, period);
  return power.near_strongest > kMost ? power.beside_harmonics > kOneMore : !is_lone;
}

}  // namespace

ExcitationKind KindOf(std::span<const double> post, std::span<const TonePoint> track, std::span<const Dwell> dwells) {
  constexpr double kMostInDwells = 0.5;
  constexpr double kTonal = 0.9;
  const std::optional<std::size_t> period = PeriodOf(post);
  const double tonal = TonalShare(track);
  const bool is_in_dwells = tonal > kMostInDwells && ShareInDwells(track, dwells) > kMostInDwells;
  if (period && HasTonesTogether(post, *period, LoneShare(post, track, {}) > kTonal)) return ExcitationKind::kMultisine;
  const ExcitationKind other = period ? ExcitationKind::kMultisine : ExcitationKind::kRandom;
  if (is_in_dwells) return LoneShare(post, track, dwells) > kTonal ? ExcitationKind::kStepped : other;
  return tonal > kTonal ? ExcitationKind::kSweep : other;
}

}  // namespace fourpost
