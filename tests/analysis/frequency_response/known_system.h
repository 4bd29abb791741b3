#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include "analysis/signals/deviation.h"
#include "analysis/signals/random_stream.h"

namespace fourpost {

/// A recursive filter with the response b / (1 + a1 / z + a2 / z^2), z = exp(2 pi i f / rate), exact for its samples.
struct KnownSystem {
  double a1 = 0;
  double a2 = 0;

  KnownSystem(double resonance_Hz, double damping, double rate_Hz) {
    const double w = 2 * std::numbers::pi * resonance_Hz / rate_Hz;
    const double r = std::exp(-damping * w);
    a1 = -2 * r * std::cos(w * std::sqrt(1 - damping * damping));
    a2 = r * r;
  }

  std::complex<double> Response(double frequency_Hz, double rate_Hz) const {
    const std::complex<double> back = std::polar(1.0, -2 * std::numbers::pi * frequency_Hz / rate_Hz);
    return (1 + a1 + a2) / (1.0 + back * (a1 + back * a2));
  }

  std::vector<double> Answer(const std::vector<double>& input) const {
    std::vector<double> output(input.size());
    for (std::size_t k = 0; k < input.size(); ++k)
      output[k] = (1 + a1 + a2) * input[k] - (k > 0 ? a1 * output[k - 1] : 0) - (k > 1 ? a2 * output[k - 2] : 0);
    return output;
  }
};

/// White noise of a share of the signal's standard deviation, and an offset.
inline std::vector<double> Noisy(std::vector<double> signal, double share, double offset, std::uint64_t seed) {
  RandomStream random(seed, "noise");
  const double size = share * DeviationOf(signal);
  for (double& sample : signal) sample += offset + size * random.Normal();
  return signal;
}

/// The rig's limits: 12 mm, 0.15 m/s, 6 m/s^2.
inline double RigAmplitude(double frequency_Hz) {
  const double w = 2 * std::numbers::pi * frequency_Hz;
  return std::min({12e-3, 0.15 / w, 6 / (w * w)});
}

/// Rest, then a dwell at each frequency, without jumps; `cycles` of each, four seconds at least.
inline std::vector<double> SteppedSine(const std::vector<double>& frequencies_Hz, double cycles, double rate_Hz) {
  std::vector<double> signal(static_cast<std::size_t>(2 * rate_Hz), 0.0);
  double phase = 0;
  for (const double frequency : frequencies_Hz) {
    const auto samples = static_cast<std::size_t>(std::max(cycles / frequency, 4.0) * rate_Hz);
    for (std::size_t k = 0; k < samples; ++k) {
      phase += 2 * std::numbers::pi * frequency / rate_Hz;
      signal.push_back(RigAmplitude(frequency) * std::sin(phase));
    }
  }
  return signal;
}

inline std::vector<double> LogFrequencies(double first_Hz, double last_Hz, int count) {
  std::vector<double> frequencies;
  for (int k = 0; k < count; ++k)
    frequencies.push_back(first_Hz * std::pow(last_Hz / first_Hz, static_cast<double>(k) / (count - 1)));
  return frequencies;
}

/// From 0.5 to 30 Hz in octaves.
inline std::vector<double> LogSweep(double duration_s, double rate_Hz) {
  std::vector<double> signal;
  double phase = 0;
  const double samples = duration_s * rate_Hz;
  for (double k = 0; k < samples; ++k) {
    const double frequency = 0.5 * std::pow(60.0, k / samples);
    phase += 2 * std::numbers::pi * frequency / rate_Hz;
    signal.push_back(RigAmplitude(frequency) * std::sin(phase));
  }
  return signal;
}

/// About white in velocity from half a hertz to some tens.
inline std::vector<double> RandomMotion(double duration_s, double rate_Hz, std::uint64_t seed) {
  RandomStream random(seed, "motion");
  std::vector<double> signal(static_cast<std::size_t>(duration_s * rate_Hz));
  double value = 0;
  for (double& sample : signal) sample = value = 0.994 * value + 1e-4 * random.Normal();
  for (int pass = 0; pass < 3; ++pass) {
    double smooth = 0;
    for (double& sample : signal) sample = smooth += 0.35 * (sample - smooth);
  }
  return signal;
}

/// Errors of responses over their stated standard deviations.
class Coverage {
 public:
  void Add(std::complex<double> measured, double variance, std::complex<double> truth) {
    constexpr double kNormal95 = 1.96;
    const double sd = std::sqrt(variance / 2);
    for (const double error : {measured.real() - truth.real(), measured.imag() - truth.imag()}) {
      ++all_;
      if (std::abs(error) < kNormal95 * sd) ++within_;
    }
    const std::complex<double> ratio = measured / truth;
    worst_dB_ = std::max(worst_dB_, std::abs(20 * std::log10(std::abs(ratio))));
    worst_deg_ = std::max(worst_deg_, std::abs(std::arg(ratio)) * 180 / std::numbers::pi);
  }

  double percent() const { return 100.0 * within_ / all_; }
  double worst_dB() const { return worst_dB_; }
  double worst_deg() const { return worst_deg_; }

 private:
  int all_ = 0;
  int within_ = 0;
  double worst_dB_ = 0;
  double worst_deg_ = 0;
};

}  // namespace fourpost
