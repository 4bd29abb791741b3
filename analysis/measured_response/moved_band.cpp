#include "analysis/measured_response/moved_band.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/signals/median.h"
#include "analysis/signals/noise_floor.h"
#include "analysis/signals/spectrum.h"

namespace fourpost {
namespace {

struct Band {
  double lower_Hz = 0;
  double upper_Hz = 0;
};

bool IsTone(const TonePoint& point) { return point.share > 0.5; }

/// Whether noise alone would not explain as much of a window's variance. Hann's window over three cycles has as many
/// independent samples as 1 / 1.5 of its own; without a mean, a sine and a cosine, n are left, and white noise of n
/// degrees of freedom exceeds a share s as often as (1 - s)^(n / 2). There are some thousand windows in a record.
bool IsClear(const TonePoint& point) {
  constexpr double kEvidence = 20;
  const double samples = 3 / point.cycles_per_sample;
  const double left = samples / 1.5 - 3;
  return IsTone(point) && -0.5 * left * std::log(std::max(1 - point.share, 1e-12)) > kEvidence;
}

/// Clear tones that follow each other: frequencies of a sweep. Two points may be unclear between them.
std::vector<std::vector<double>> ChainsOf(std::span<const TonePoint> sweep) {
  // That of the tones that are looked for.
  constexpr double kStep = 1.189207115;
  constexpr std::size_t kUnclear = 2;
  std::vector<std::vector<double>> chains;
  std::size_t last = 0;
  for (std::size_t k = 0; k < sweep.size(); ++k) {
    if (!IsClear(sweep[k])) continue;
    const double ratio = chains.empty() ? 0 : sweep[k].cycles_per_sample / chains.back().back();
    if (chains.empty() || k - last > kUnclear + 1 || ratio > kStep || ratio < 1 / kStep) chains.emplace_back();
    chains.back().push_back(sweep[k].cycles_per_sample);
    last = k;
  }
  return chains;
}

/// Least and greatest frequency in cycles per sample; of five neighbours the middle one counts, as a few may be off.
Band BandOf(const std::vector<double>& chain) {
  constexpr std::size_t kNear = 5;
  if (chain.size() < kNear) return {};
  Band band{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t k = 0; k + kNear <= chain.size(); ++k) {
    const auto first = chain.begin() + static_cast<std::ptrdiff_t>(k);
    const double middle = Median(std::vector<double>(first, first + kNear));
    band.lower_Hz = std::min(band.lower_Hz, middle);
    band.upper_Hz = std::max(band.upper_Hz, middle);
  }
  return band;
}

/// Of the chains that cover as many octaves as half of the widest: a hum beside the sweep covers next to none.
Band SweptBand(std::span<const TonePoint> sweep, double rate_Hz, double duration_s) {
  constexpr double kFewestPeriods = 60;
  constexpr double kAsWide = 0.5;
  std::vector<Band> bands;
  double widest = 0;
  const auto width = [](const Band& band) { return std::log(band.upper_Hz / band.lower_Hz); };
  for (const std::vector<double>& chain : ChainsOf(sweep)) {
    const Band band = BandOf(chain);
    if (!(band.lower_Hz > 0)) continue;
    bands.push_back(band);
    widest = std::max(widest, width(band));
  }
  if (!(widest > 0)) return {};
  Band all{std::numeric_limits<double>::infinity(), 0};
  for (const Band& band : bands) {
    if (width(band) < kAsWide * widest) continue;
    all.lower_Hz = std::min(all.lower_Hz, band.lower_Hz);
    all.upper_Hz = std::max(all.upper_Hz, band.upper_Hz);
  }
  return {std::max(1.2 * all.lower_Hz * rate_Hz, kFewestPeriods / duration_s), 0.95 * all.upper_Hz * rate_Hz};
}

Band RandomBand(std::span<const double> motion, double rate_Hz) {
  constexpr double kLowerShare = 0.03;
  constexpr double kUpperShare = 1e-5;
  constexpr double kAboveNoise = 100;
  constexpr double kFewestPeriods = 20;
  constexpr double kSegment_s = 16;
  const auto wanted = static_cast<std::size_t>(kSegment_s * rate_Hz);
  const std::size_t segment = std::max<std::size_t>(4, std::min(wanted, motion.size() / 4));
  if (segment > motion.size()) return {};
  const Spectrum spectrum = WelchSpectrum(motion, motion, rate_Hz, segment);
  const double noise = NoiseFloor(motion);
  const std::vector<double>& power = spectrum.first;
  const double most = *std::max_element(power.begin() + 1, power.end());
  const double above_noise = kAboveNoise * noise * noise / (rate_Hz / 2);
  std::size_t first = static_cast<std::size_t>(std::max_element(power.begin() + 1, power.end()) - power.begin());
  std::size_t last = first;
  while (first > 1 && power[first - 1] >= std::max(kLowerShare * most, above_noise)) --first;
  while (last + 1 < power.size() && power[last + 1] >= std::max(kUpperShare * most, above_noise)) ++last;
  const double duration_s = static_cast<double>(motion.size()) / rate_Hz;
  // Hann's window spreads a band's ends by a line or two.
  return {std::max(spectrum.frequency_Hz[first] + 2 / kSegment_s, kFewestPeriods / duration_s),
          std::min(0.97 * spectrum.frequency_Hz[last] - 2 / kSegment_s, 0.4 * rate_Hz)};
}

std::vector<double> FrequenciesIn(const Band& band) {
  constexpr int kCount = 64;
  std::vector<double> frequencies;
  if (!(band.lower_Hz > 0 && band.lower_Hz < band.upper_Hz)) return frequencies;
  const double ratio = band.upper_Hz / band.lower_Hz;
  for (int k = 0; k < kCount; ++k)
    frequencies.push_back(band.lower_Hz * std::pow(ratio, static_cast<double>(k) / (kCount - 1)));
  return frequencies;
}

}  // namespace

std::vector<double> MovedFrequencies(std::span<const double> motion, double rate_Hz) {
  return FrequenciesIn(RandomBand(motion, rate_Hz));
}

std::vector<double> SweptFrequencies(std::span<const TonePoint> sweep, double rate_Hz, double duration_s) {
  return FrequenciesIn(SweptBand(sweep, rate_Hz, duration_s));
}

double SweptAmplitude(std::span<const TonePoint> sweep, double cycles_per_sample) {
  constexpr double kNear = 0.05;
  std::vector<double> near;
  const TonePoint* nearest = nullptr;
  const auto distance = [&](const TonePoint& point) {
    return std::abs(std::log(std::max(1e-12, point.cycles_per_sample) / cycles_per_sample));
  };
  for (const TonePoint& point : sweep) {
    if (!IsTone(point)) continue;
    if (distance(point) < kNear) near.push_back(point.amplitude);
    if (nearest == nullptr || distance(point) < distance(*nearest)) nearest = &point;
  }
  if (!near.empty()) return Median(near);
  return nearest != nullptr ? nearest->amplitude : 0;
}

}  // namespace fourpost
