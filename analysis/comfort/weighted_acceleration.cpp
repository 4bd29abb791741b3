#include "analysis/comfort/weighted_acceleration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "analysis/signals/spline_through.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Gauss's rule of seven points on [-1, 1]: exact to degree 13, that of a cubic's fourth power is 12.
constexpr std::array<double, 7> kNodes = {-0.9491079123427585, -0.7415311855993945, -0.4058451513773972, 0,
                                          0.4058451513773972,  0.7415311855993945,  0.9491079123427585};
constexpr std::array<double, 7> kShares = {0.1294849661688697, 0.2797053914892766, 0.3818300505051189,
                                           0.4179591836734694, 0.3818300505051189, 0.2797053914892766,
                                           0.1294849661688697};

constexpr double kWindow_s = 1;

/// Integrals from the start to each sample.
struct Integrals {
  std::vector<double> square;
  double fourth = 0;
};

Integrals Integrate(const UniformSpline& acceleration, std::size_t count, double step) {
  Integrals integrals{.square = {0}};
  for (std::size_t k = 0; k + 1 < count; ++k) {
    double square = 0;
    double fourth = 0;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double a = acceleration.At((static_cast<double>(k) + 0.5 * (1 + kNodes[i])) * step).value;
      square += kShares[i] * a * a;
      fourth += kShares[i] * a * a * a * a;
    }
    integrals.square.push_back(integrals.square.back() + 0.5 * step * square);
    integrals.fourth += 0.5 * step * fourth;
  }
  return integrals;
}

/// A cubic over one step, by values and slopes at both ends; u = 0 .. 1.
struct Cubic {
  double from;
  double to;
  double slope_from;
  double slope_to;

  double At(double u) const {
    const double v = 1 - u;
    return v * v * (1 + 2 * u) * from + u * u * (1 + 2 * v) * to + u * v * (v * slope_from - u * slope_to);
  }

  /// Largest value over 0 .. 1.
  double Largest() const {
    double largest = std::max(from, to);
    // Its slope is c + b u + a u^2.
    const double a = 6 * (from - to) + 3 * (slope_from + slope_to);
    const double b = 6 * (to - from) - 4 * slope_from - 2 * slope_to;
    const double root = std::sqrt(std::max(0.0, b * b - 4 * a * slope_from));
    const double q = -0.5 * (b + std::copysign(root, b));
    for (const double u : {q / a, slope_from / q})
      if (u > 0 && u < 1) largest = std::max(largest, At(u));
    return largest;
  }
};

/// The integral of a^2 over a window that ends at a time, and its rate, the difference of a^2 at both ends.
class RunningEnergy {
 public:
  RunningEnergy(const std::vector<double>& energy, const UniformSpline& acceleration, double step)
      : energy_(energy), acceleration_(acceleration), step_(step) {}

  double At(double t) const { return Until(t) - Until(t - kWindow_s); }
  double Rate(double t) const { return Power(t) - Power(t - kWindow_s); }

 private:
  double Power(double t) const {
    if (t < 0) return 0;
    const double a = acceleration_.At(t).value;
    return a * a;
  }

  double Until(double t) const {
    if (t <= 0) return 0;
    const double place = t / step_;
    const auto k = std::min(static_cast<std::size_t>(place), energy_.size() - 2);
    const double start = static_cast<double>(k) * step_;
    const Cubic cubic{energy_[k], energy_[k + 1], step_ * Power(start), step_ * Power(start + step_)};
    return cubic.At(std::min(place - static_cast<double>(k), 1.0));
  }

  const std::vector<double>& energy_;
  const UniformSpline& acceleration_;
  double step_;
};

double LargestEnergy(const RunningEnergy& running, std::size_t count, double step) {
  std::size_t best = 0;
  double largest = 0;
  for (std::size_t k = 1; k < count; ++k) {
    const double energy = running.At(static_cast<double>(k) * step);
    if (energy <= largest) continue;
    largest = energy;
    best = k;
  }
  // Between the samples beside it.
  for (std::size_t k = best > 0 ? best - 1 : 0; k < std::min(best + 1, count - 1); ++k) {
    const double t = static_cast<double>(k) * step;
    const Cubic cubic{running.At(t), running.At(t + step), step * running.Rate(t), step * running.Rate(t + step)};
    largest = std::max(largest, cubic.Largest());
  }
  return largest;
}

}  // namespace

double WeightedAcceleration::MtvvRatio() const { return rms > 0 ? mtvv / rms : 0; }

double WeightedAcceleration::VdvRatio() const { return rms > 0 ? vdv / (rms * std::pow(duration_s, 0.25)) : 0; }

WeightedAcceleration MeasuresOf(std::span<const double> weighted, double rate_Hz) {
  RequirePositive("WeightedAcceleration: rate_Hz", rate_Hz);
  RequireOption(weighted.size() >= 2, "WeightedAcceleration: samples", weighted.size(), "two at least");
  const double step = 1 / rate_Hz;
  const UniformSpline acceleration = SplineThrough(weighted, 0, step);
  const Integrals integrals = Integrate(acceleration, weighted.size(), step);
  const double duration = acceleration.end();
  const RunningEnergy running(integrals.square, acceleration, step);
  return {.rms = std::sqrt(integrals.square.back() / duration),
          .mtvv = std::sqrt(LargestEnergy(running, weighted.size(), step) / kWindow_s),
          .vdv = std::pow(integrals.fourth, 0.25),
          .duration_s = duration};
}

double VibrationDoseOfRandom(double rms, double duration_s) { return rms * std::pow(3 * duration_s, 0.25); }

}  // namespace fourpost
