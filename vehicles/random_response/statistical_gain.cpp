#include "vehicles/random_response/statistical_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <variant>
#include <vector>

namespace fourpost {
namespace {

using std::numbers::pi;

/// Gauss's rule of eight points, positive half of [-1, 1].
constexpr std::array<double, 4> kGaussNodes = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                               0.9602898564975363};
constexpr std::array<double, 4> kGaussShares = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                0.1012285362903763};

/// Beyond these deviations lie 1e-15 of a normal distribution.
constexpr double kReach = 8;
/// Panels between kinks are this many deviations wide at the most.
constexpr double kWidestPanel = 1.6;

double NormalDensity(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * pi); }

/// Points of a standard normal distribution and their shares, panels between these values of z.
struct NormalPoints {
  std::vector<double> z;
  std::vector<double> share;
};

NormalPoints PointsBetween(std::vector<double> breaks) {
  breaks.insert(breaks.end(), {-kReach, kReach});
  std::erase_if(breaks, [](double z) { return !(std::abs(z) <= kReach); });
  std::sort(breaks.begin(), breaks.end());
  NormalPoints points;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double length = breaks[i + 1] - breaks[i];
    const double panels = std::ceil(length / kWidestPanel);
    for (double p = 0; p < panels; ++p) {
      const double half = 0.5 * length / panels;
      const double middle = breaks[i] + (2 * p + 1) * half;
      for (std::size_t k = 0; k < kGaussNodes.size(); ++k)
        for (const double z : {middle - half * kGaussNodes[k], middle + half * kGaussNodes[k]}) {
          points.z.push_back(z);
          points.share.push_back(half * kGaussShares[k] * NormalDensity(z));
        }
    }
  }
  return points;
}

/// Mean of the law and its slope, E[r z] / deviation, which needs no derivative of the law (Stein's lemma).
struct MeanAndSlope {
  double mean = 0;
  double slope = 0;
};

MeanAndSlope Average(const NormalPoints& points, std::span<const double> force, double deviation) {
  MeanAndSlope average;
  for (std::size_t k = 0; k < force.size(); ++k) {
    average.mean += points.share[k] * force[k];
    average.slope += points.share[k] * force[k] * points.z[k];
  }
  average.slope /= deviation;
  return average;
}

StatisticalGain Gain(const DashpotRemainder& port, const PortMotion& motion) {
  if (motion.rate_sd == 0) return {.by_rate = port.law.Slope(0) - port.rate};
  const double deviation = motion.rate_sd;
  std::vector<double> breaks = {0};
  for (const DashpotLaw::Kink& kink : port.law.Kinks()) breaks.push_back(kink.speed / deviation);
  if (const double step = port.law.StepSpeed(); std::isfinite(step))
    for (const double widths : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      breaks.push_back(widths * step / deviation);
      breaks.push_back(-widths * step / deviation);
    }
  const NormalPoints points = PointsBetween(std::move(breaks));
  std::vector<double> rate(points.z.size());
  std::transform(points.z.begin(), points.z.end(), rate.begin(), [&](double z) { return z * deviation; });
  std::vector<double> force(rate.size());
  port.law.Forces(rate, force);
  const MeanAndSlope average = Average(points, force, deviation);
  return {.mean = average.mean, .by_rate = average.slope - port.rate};
}

StatisticalGain Gain(const SpringRemainder& port, const PortMotion& motion) {
  const double deviation = motion.extension_sd;
  if (deviation == 0)
    return {.mean = port.law.Force(motion.mean) - port.stiffness * motion.mean,
            .by_extension = port.law.Slope(motion.mean) - port.stiffness};
  std::vector<double> breaks;
  for (const SpringLaw::Knee& knee : port.law.knees) breaks.push_back((knee.at - motion.mean) / deviation);
  if (port.law.curve)
    for (const double x : port.law.curve->x()) breaks.push_back((x - motion.mean) / deviation);
  // Stops that are out of reach, the usual case.
  const bool is_straight = port.law.cubic == 0 && !port.law.curve &&
                           std::none_of(breaks.begin(), breaks.end(), [](double z) { return std::abs(z) < kReach; });
  if (is_straight)
    return {.mean = port.law.Force(motion.mean) - port.stiffness * motion.mean,
            .by_extension = port.law.Slope(motion.mean) - port.stiffness};
  const NormalPoints points = PointsBetween(std::move(breaks));
  std::vector<double> force(points.z.size());
  for (std::size_t k = 0; k < force.size(); ++k) {
    const double e = motion.mean + points.z[k] * deviation;
    force[k] = port.law.Force(e) - port.stiffness * e;
  }
  const MeanAndSlope average = Average(points, force, deviation);
  return {.mean = average.mean, .by_extension = average.slope};
}

StatisticalGain Gain(const LiftoffRemainder& port, const PortMotion& motion) {
  const double mean = port.preload + port.stiffness * motion.mean;
  const double deviation = std::hypot(port.stiffness * motion.extension_sd, port.damping * motion.rate_sd);
  const LiftingForce force = LiftingForceOf(mean, deviation);
  return {.mean = force.mean - mean,
          .by_extension = -port.stiffness * force.off_ground,
          .by_rate = -port.damping * force.off_ground};
}

/// Extensions of a tyre, in deviations, between which its mean force over the rates is smooth.
std::vector<double> TyreBreaks(const TyreRemainder& port, const PortMotion& motion) {
  const double liftoff = (port.law.Liftoff() - motion.mean) / motion.extension_sd;
  const double width = port.damping * motion.rate_sd / (port.law.Rate(port.law.Liftoff()) * motion.extension_sd);
  std::vector<double> breaks = {liftoff};
  if (width > 0)
    for (const double widths : {1.0, 2.0, 4.0, 8.0})
      for (const int side : {-1, 1}) breaks.push_back(liftoff + side * widths * width);
  if (port.law.law.curve)
    for (const double x : port.law.law.curve->x())
      breaks.push_back((x - port.law.place - motion.mean) / motion.extension_sd);
  return breaks;
}

/// Of a tyre's vertical force.
struct TyreAverage {
  double mean = 0;
  double square = 0;
  double slope = 0;
  double off_ground = 0;
};

/// Over the rates in closed form, over the extensions at these points.
TyreAverage Average(const TyreRemainder& port, const PortMotion& motion, const NormalPoints& points) {
  TyreAverage average;
  for (std::size_t k = 0; k < points.z.size(); ++k) {
    const double e = motion.mean + points.z[k] * motion.extension_sd;
    const LiftingForce force = LiftingForceOf(port.law.Force(e), port.damping * motion.rate_sd);
    average.mean += points.share[k] * force.mean;
    average.square += points.share[k] * (force.deviation * force.deviation + force.mean * force.mean);
    average.off_ground += points.share[k] * force.off_ground;
    if (motion.extension_sd > 0) average.slope += points.share[k] * force.mean * points.z[k] / motion.extension_sd;
    else average.slope = (1 - force.off_ground) * port.law.Rate(e);
  }
  return average;
}

TyreAverage AverageOf(const TyreRemainder& port, const PortMotion& motion) {
  if (motion.extension_sd == 0) return Average(port, motion, {.z = {0}, .share = {1}});
  return Average(port, motion, PointsBetween(TyreBreaks(port, motion)));
}

StatisticalGain Gain(const TyreRemainder& port, const PortMotion& motion) {
  const TyreAverage average = AverageOf(port, motion);
  return {.mean = average.mean - port.law.load - port.stiffness * motion.mean,
          .by_extension = average.slope - port.stiffness,
          .by_rate = -port.damping * average.off_ground};
}

StatisticalGain Gain(const HydraulicRemainder& port, const PortMotion& motion) {
  if (motion.extension_sd == 0 || motion.rate_sd == 0) return {};
  constexpr std::size_t kSamples = 128;
  const double w = motion.rate_sd / motion.extension_sd;
  const double amplitude = std::numbers::sqrt2 * motion.extension_sd;
  std::vector<double> extension(kSamples);
  std::vector<double> rate(kSamples);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double phase = 2 * pi * static_cast<double>(k) / kSamples;
    extension[k] = motion.mean + amplitude * std::cos(phase);
    rate[k] = -w * amplitude * std::sin(phase);
  }
  std::vector<double> force(kSamples);
  CycleRemainders(port, 2 * pi / w, extension, rate, force);
  double mean = 0;
  std::complex<double> harmonic = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    mean += force[k] / kSamples;
    harmonic += force[k] * std::polar(2.0 / kSamples, -2 * pi * static_cast<double>(k) / kSamples);
  }
  const std::complex<double> gain = harmonic / amplitude - LaggingShare(port, w);
  return {.mean = mean, .by_extension = gain.real(), .by_rate = gain.imag() / w};
}

/// Amplitudes of a narrow band have Rayleigh's distribution, of density z exp(-z^2 / 2) at z deviations.
StatisticalGain Gain(const FrictionRemainder& port, const PortMotion& motion) {
  if (port.law.force == 0) return {};
  if (motion.extension_sd == 0 || motion.rate_sd == 0) return {.by_extension = port.law.stiffness};
  const double sliding = port.law.force / port.law.stiffness / motion.extension_sd;
  const NormalPoints points = PointsBetween({0, sliding, 3 * sliding, 10 * sliding});
  std::complex<double> gain = 0;
  for (std::size_t k = 0; k < points.z.size(); ++k)
    if (const double z = points.z[k]; z > 0)
      gain += std::sqrt(2 * pi) * points.share[k] * z * 0.5 * z * z * port.law.Gain(z * motion.extension_sd);
  return {.by_extension = gain.real(), .by_rate = gain.imag() * motion.extension_sd / motion.rate_sd};
}

}  // namespace

double NormalShareBelow(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

LiftingForce LiftingForceOf(double mean, double deviation) {
  if (deviation == 0) return {.mean = std::max(0.0, mean), .deviation = 0, .off_ground = mean < 0 ? 1.0 : 0.0};
  const double z = mean / deviation;
  const double on_ground = NormalShareBelow(z);
  const double density = NormalDensity(z);
  const double kept = deviation * (z * on_ground + density);
  const double square = deviation * deviation * ((z * z + 1) * on_ground + z * density);
  return {
      .mean = kept, .deviation = std::sqrt(std::max(0.0, square - kept * kept)), .off_ground = NormalShareBelow(-z)};
}

LiftingForce LiftingForceOf(const TyreRemainder& port, const PortMotion& motion) {
  const TyreAverage average = AverageOf(port, motion);
  return {.mean = average.mean,
          .deviation = std::sqrt(std::max(0.0, average.square - average.mean * average.mean)),
          .off_ground = average.off_ground};
}

StatisticalGain GainOf(const PortLaw& law, const PortMotion& motion) {
  return std::visit([&](const auto& port) { return Gain(port, motion); }, law);
}

}  // namespace fourpost
