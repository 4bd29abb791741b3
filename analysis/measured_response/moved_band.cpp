#include "analysis/measured_response/moved_band.h"

#include <algorithm>
#include <cmath>
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

Band SweptBand(std::span<const TonePoint> sweep, double rate_Hz, double duration_s) {
  constexpr double kFewestPeriods = 60;
  std::vector<double> frequencies;
  for (const TonePoint& point : sweep)
    if (IsTone(point)) frequencies.push_back(point.cycles_per_sample * rate_Hz);
  if (frequencies.size() < 4) return {};
  std::sort(frequencies.begin(), frequencies.end());
  // A few points may be off.
  const std::size_t cut = frequencies.size() / 100;
  return {std::max(1.2 * frequencies[cut], kFewestPeriods / duration_s),
          0.95 * frequencies[frequencies.size() - 1 - cut]};
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
