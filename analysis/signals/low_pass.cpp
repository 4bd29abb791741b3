#include "analysis/signals/low_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// 1 / (s^2 + damping s + 1) with s = (1 - 1/z) / (1 + 1/z) / warped.
LowPass::Section SecondOrder(double warped, double damping) {
  const double square = warped * warped;
  const double scale = 1 / (1 + damping * warped + square);
  return {scale * square, 2 * scale * square, scale * square, 2 * scale * (square - 1),
          scale * (1 - damping * warped + square)};
}

/// 1 / (s + 1).
LowPass::Section FirstOrder(double warped) {
  const double scale = 1 / (1 + warped);
  return {scale * warped, scale * warped, 0, scale * (warped - 1), 0};
}

/// What has decayed to this is nothing: numbers near the least that there are take a hundred times as long.
constexpr double kNothing = 1e-200;

/// Direct form II transposed, after a signal that stood at `before` since ever.
void ApplySection(const LowPass::Section& section, double before, std::span<double> signal) {
  double first = (1 - section.b0) * before;
  double second = (section.b2 - section.a2) * before;
  for (double& sample : signal) {
    const double read = std::abs(sample) < kNothing ? 0 : sample;
    const double filtered = section.b0 * read + first;
    first = section.b1 * read - section.a1 * filtered + second;
    second = section.b2 * read - section.a2 * filtered;
    if (std::abs(first) < kNothing && std::abs(second) < kNothing) first = second = 0;
    sample = filtered;
  }
}

}  // namespace

LowPass::LowPass(int order, double cutoff_Hz, double rate_Hz) {
  RequireOption(order >= 1 && order <= 16, "LowPass: order", order, "1 to 16");
  RequireOption(rate_Hz > 0 && std::isfinite(rate_Hz), "LowPass: rate_Hz", rate_Hz, "positive and finite");
  RequireOption(cutoff_Hz > 0 && cutoff_Hz < rate_Hz / 2, "LowPass: cutoff_Hz", cutoff_Hz,
                "above 0 and below half the sampling rate");
  const double warped = std::tan(std::numbers::pi * cutoff_Hz / rate_Hz);
  if (order % 2 == 1) sections_.push_back(FirstOrder(warped));
  // Poles at equal angles on the unit circle's left half; those next to the real axis first.
  for (int k = order / 2 - 1; k >= 0; --k)
    sections_.push_back(SecondOrder(warped, 2 * std::sin(std::numbers::pi * (2 * k + 1) / (2 * order))));
}

std::complex<double> LowPass::Response(double cycles_per_sample) const {
  const std::complex<double> back = std::polar(1.0, -2 * std::numbers::pi * cycles_per_sample);
  std::complex<double> response = 1;
  for (const Section& section : sections_)
    response *=
        (section.b0 + back * (section.b1 + back * section.b2)) / (1.0 + back * (section.a1 + back * section.a2));
  return response;
}

std::size_t LowPass::SettlingSamples(double share) const {
  RequireOption(share > 0 && share < 1, "LowPass: share", share, "above 0 and below 1");
  double slowest = 0;
  // The poles of a section of second order are conjugate, their product is a2.
  for (const Section& section : sections_)
    slowest = std::max(slowest, section.a2 != 0 ? std::sqrt(section.a2) : std::abs(section.a1));
  return slowest > 0 ? static_cast<std::size_t>(std::ceil(std::log(share) / std::log(slowest))) : 1;
}

void LowPass::Apply(std::span<double> signal) const {
  for (const Section& section : sections_) ApplySection(section, 0, signal);
}

}  // namespace fourpost
