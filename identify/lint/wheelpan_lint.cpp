#include "identify/lint/wheelpan_lint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include <Eigen/Core>

#include "analysis/short_number.h"
#include "identify/lint/real_factor.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Share of the reference post's motion that the post under this tyre makes.
double ShareUnder(const Vehicle& vehicle, int tyre, const Excitation& excitation) {
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p)
    if (vehicle.posts[p].tyre == tyre) return excitation.shape[p];
  return 0;
}

/// Force of the difference that grows with the post's acceleration, as a mass.
struct ExtraMass {
  double kg = 0;
  /// Of the squares that a wrong rate leaves over, the share that the mass explains.
  double explained = 0;
};

/// Where the modelled gain of this sensor is the largest, the body's modes aside [Hz].
double PeakOf(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled, std::size_t s) {
  constexpr double kBeyondTheBody_Hz = 4;
  double largest = 0;
  double peak_Hz = kBeyondTheBody_Hz;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<double>& frequencies = runs[r].excitation.frequency_Hz;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      const double gain = std::abs(modelled[r].channels[s].response[i]);
      if (frequencies[i] < kBeyondTheBody_Hz || !(gain > largest)) continue;
      largest = gain;
      peak_Hz = frequencies[i];
    }
  }
  return peak_Hz;
}

ExtraMass ExtraMassOf(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                      const std::vector<FrequencyResponse>& modelled, std::size_t s) {
  // Beyond the hop of the wheel, of which a vehicle file may be off, a tyre's force is that of its rate and little
  // else.
  const double from_Hz = 1.3 * PeakOf(runs, modelled, s);
  std::vector<Complex> difference;
  std::vector<Complex> force;
  std::vector<Complex> acceleration;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const MeasuredRun& run = runs[r];
    const double share = ShareUnder(vehicle, vehicle.sensors[s].tyre, run.excitation);
    for (const MeasuredChannel& channel : run.channels)
      for (std::size_t i = 0; channel.sensor == s && i < channel.response.size(); ++i) {
        const double f = run.excitation.frequency_Hz[i];
        const Complex model = modelled[r].channels[s].response[i];
        if (f < from_Hz || !std::isfinite(model.real())) continue;
        difference.push_back(channel.response[i] - model);
        force.push_back(model);
        acceleration.push_back(-std::pow(2 * std::numbers::pi * f, 2) * share);
      }
  }
  const auto count = static_cast<Eigen::Index>(difference.size());
  if (count < 4) return {};
  const Eigen::Map<const Eigen::VectorXcd> y(difference.data(), count);
  const Eigen::Map<const Eigen::VectorXcd> f(force.data(), count);
  const Eigen::Map<const Eigen::VectorXcd> a(acceleration.data(), count);
  // What a tyre rate that is off would leave, of any phase, goes out of both first.
  const double squares = std::max(f.squaredNorm(), std::numeric_limits<double>::min());
  const Eigen::VectorXcd left = y - f * (f.dot(y) / squares);
  const Eigen::VectorXcd mass = a - f * (f.dot(a) / squares);
  const auto [kg, explained] = RealFactorOf(left, mass);
  return {kg, explained};
}

}  // namespace

void LintWheelpans(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings) {
  constexpr double kLight_kg = 4;
  constexpr double kMost = 0.7;
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    const Sensor& sensor = vehicle.sensors[s];
    if (sensor.type != Sensor::Type::kLoadCell) continue;
    const ExtraMass extra = ExtraMassOf(vehicle, runs, modelled, s);
    if (std::abs(extra.kg) < kLight_kg || extra.explained < kMost) continue;
    warnings.Add(sensor.name, extra.kg > 0
                                  ? "feels the inertia of some " + ShortNumber(extra.kg, 2) +
                                        " kg that move with the post: give its load cell that wheelpan in the vehicle "
                                        "file, or take the inertia out of the recording"
                                  : "lacks the inertia of some " + ShortNumber(-extra.kg, 2) +
                                        " kg of the wheelpan that its load cell has in the vehicle file: leave the "
                                        "wheelpan out there when it is out of the recording");
  }
}

}  // namespace fourpost
