#include "vehicles/posts/height_signals.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "analysis/signals/random_stream.h"
#include "analysis/text/option_check.h"
#include "vehicles/posts/band_noise.h"

namespace fourpost {
namespace {

using std::numbers::pi;

/// Times a raised cosine over the first and the last part of a signal.
double Fade(double t, double duration, double first, double last) {
  const auto share = [](double u) { return u >= 1 ? 1 : 0.5 * (1 - std::cos(pi * std::max(0.0, u))); };
  return share(t / first) * share((duration - t) / last);
}

/// Angle of a sweep after a time, over 2 pi.
double Cycles(const SweptSine& sweep, double t) {
  const double ratio = sweep.last_Hz / sweep.first_Hz;
  if (ratio == 1) return sweep.first_Hz * t;
  if (!sweep.logarithmic) return sweep.first_Hz * t + 0.5 * (sweep.last_Hz - sweep.first_Hz) * t * t / sweep.duration_s;
  const double rate = std::log(ratio) / sweep.duration_s;
  return sweep.first_Hz * std::expm1(rate * t) / rate;
}

double FrequencyAt(const SweptSine& sweep, double t) {
  const double share = t / sweep.duration_s;
  if (!sweep.logarithmic) return sweep.first_Hz + (sweep.last_Hz - sweep.first_Hz) * share;
  return sweep.first_Hz * std::pow(sweep.last_Hz / sweep.first_Hz, share);
}

}  // namespace

double SweptSine::AmplitudeAt(double frequency_Hz) const {
  const double omega = 2 * pi * frequency_Hz;
  return std::min({amplitude_m, top_speed / omega, top_acceleration / (omega * omega)});
}

UniformSpline SweptSine::Signal() const {
  RequirePositive("SweptSine: first_Hz", first_Hz);
  RequirePositive("SweptSine: last_Hz", last_Hz);
  RequirePositive("SweptSine: duration_s", duration_s);
  RequireOption(amplitude_m > 0, "SweptSine: amplitude_m", amplitude_m, "positive");
  RequireOption(top_speed > 0, "SweptSine: top_speed", top_speed, "positive");
  RequireOption(top_acceleration > 0, "SweptSine: top_acceleration", top_acceleration, "positive");
  RequirePositive("SweptSine: the amplitude of the lowest frequency", AmplitudeAt(std::min(first_Hz, last_Hz)));
  const double step = SineGrid::For(std::max(first_Hz, last_Hz), duration_s).step_s;
  const auto count = static_cast<std::size_t>(std::ceil(duration_s / step)) + 1;
  // A cycle, half a second at least.
  const auto fade = [&](double frequency) { return std::min(std::max(1 / frequency, 0.5), duration_s / 4); };
  std::vector<double> heights(std::max<std::size_t>(count, 5));
  const double exact_step = duration_s / static_cast<double>(heights.size() - 1);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const double t = exact_step * static_cast<double>(k);
    heights[k] = AmplitudeAt(FrequencyAt(*this, t)) * Fade(t, duration_s, fade(first_Hz), fade(last_Hz)) *
                 std::sin(2 * pi * Cycles(*this, t));
  }
  return {0, exact_step, std::move(heights)};
}

double SteppedSine::Duration() const {
  double duration = 0;
  for (const Dwell& dwell : dwells) duration += dwell.duration_s;
  return duration;
}

UniformSpline SteppedSine::Signal() const {
  double highest = 0;
  for (const Dwell& dwell : dwells) {
    RequirePositive("SteppedSine: frequency_Hz", dwell.frequency_Hz);
    RequirePositive("SteppedSine: amplitude_m", dwell.amplitude_m);
    RequireOption(dwell.duration_s * dwell.frequency_Hz >= 2, "SteppedSine: cycles",
                  dwell.duration_s * dwell.frequency_Hz, "at least 2");
    highest = std::max(highest, dwell.frequency_Hz);
  }
  const double duration = Duration();
  RequirePositive("SteppedSine: duration_s", duration);
  const double step = SineGrid::For(highest, duration).step_s;
  const auto count = std::max<std::size_t>(static_cast<std::size_t>(std::ceil(duration / step)) + 1, 5);
  const double exact_step = duration / static_cast<double>(count - 1);
  std::vector<double> heights(count);
  std::size_t at = 0;
  double began = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = exact_step * static_cast<double>(k);
    while (at + 1 < dwells.size() && t > began + dwells[at].duration_s) began += dwells[at++].duration_s;
    const Dwell& dwell = dwells[at];
    const double cycle = 1 / dwell.frequency_Hz;
    heights[k] = dwell.amplitude_m * Fade(t - began, dwell.duration_s, cycle, cycle) *
                 std::sin(2 * pi * dwell.frequency_Hz * (t - began));
  }
  return {0, exact_step, std::move(heights)};
}

UniformSpline SmoothStep::Signal() const {
  RequireOption(std::isfinite(height_m), "SmoothStep: height_m", height_m, "finite");
  RequirePositive("SmoothStep: rise_s", rise_s);
  RequirePositive("SmoothStep: start_s", start_s);
  constexpr std::size_t kSamples = 257;
  const double step = rise_s / static_cast<double>(kSamples - 1);
  std::vector<double> heights(kSamples);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(kSamples - 1);
    heights[k] = height_m * u * u * u * (u * (6 * u - 15) + 10);
  }
  return {start_s, step, std::move(heights)};
}

UniformSpline RandomHeights::Signal() const {
  RequirePositive("RandomHeights: rms_m", rms_m);
  RequirePositive("RandomHeights: lower_Hz", lower_Hz);
  RequirePositive("RandomHeights: duration_s", duration_s);
  RequireOption(upper_Hz > lower_Hz && std::isfinite(upper_Hz), "RandomHeights: upper_Hz", upper_Hz,
                "above lower_Hz and finite");
  const SineGrid grid = SineGrid::For(upper_Hz, duration_s);
  RandomStream draws(seed, "random heights");
  double power = 0;
  std::vector<double> heights = SumOfSines(grid, lower_Hz, upper_Hz, [&](double frequency) {
    power += 0.5 / (frequency * frequency);
    return std::polar(1 / frequency, 2 * pi * draws.Uniform());
  });
  RequireOption(power > 0, "RandomHeights: duration_s", duration_s, "long enough for a frequency within the band");
  for (double& height : heights) height *= rms_m / std::sqrt(power);
  return {0, grid.step_s, Faded(std::move(heights), grid.step_s, duration_s)};
}

}  // namespace fourpost
