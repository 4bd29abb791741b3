#include "identify/experiments/four_post/wheelpan_lint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "analysis/report/shown_number.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/real_factor.h"

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
  double sd = 0;
  /// Of the squares that a wrong rate leaves over, the share that the mass explains.
  double explained = 0;
};

/// Where the modelled gain of this sensor is the largest, the body's modes aside [Hz].
double PeakOf(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled, std::size_t s) {
  // Bodies of the shipped cars heave, pitch and roll below 3.5 Hz, wheels hop from 8 on.
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
  // else. Right recordings of the Land Rover seem to lack 9 to 17 kg from the peak on, up to 10 kg from 1.15 times its
  // frequency on, 3 kg from 1.3 times: less than kLight_kg.
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
  // Two numbers a frequency, less the factor of the rate and the mass.
  const double degrees = 2 * static_cast<double>(count) - 3;
  const double sd = std::sqrt((left - kg * mass).squaredNorm() / degrees / mass.squaredNorm());
  return {kg, sd, explained};
}

/// Load cells, and the mass that each feels, or lacks.
using ExtraMasses = std::vector<std::pair<const Sensor*, ExtraMass>>;

/// Decimals to which the standard deviation has one digit that counts, 2 at the most.
int DecimalsOf(double sd) {
  constexpr int kMost = 2;
  return sd > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(sd))), 0, kMost) : kMost;
}

ExtraMass MeanOf(const ExtraMasses& findings) {
  ExtraMass mean;
  for (const auto& [sensor, extra] : findings) {
    mean.kg += extra.kg / static_cast<double>(findings.size());
    mean.sd = std::max(mean.sd, extra.sd);
  }
  return mean;
}

/// "'F_FL' about 24.1 kg (standard deviation 0.3 kg), 'F_FR' about ..."
std::string InWords(const ExtraMasses& findings) {
  std::string text;
  for (const auto& [sensor, extra] : findings)
    text += (text.empty() ? "'" : ", '") + sensor->name + "' about " + MassText(std::abs(extra.kg), extra.sd);
  return text;
}

/// Whether a parameter makes the wheelpan as heavy: no mass is forgotten then.
bool IsWithinBounds(const Vehicle& vehicle, const Sensor& sensor, double kg) {
  std::vector<double> lower;
  std::vector<double> upper;
  for (const Parameter& parameter : vehicle.parameters) {
    lower.push_back(parameter.lower);
    upper.push_back(parameter.upper);
  }
  const auto [least, most] = std::minmax(sensor.wheelpan.At(lower), sensor.wheelpan.At(upper));
  return least <= kg && kg <= most;
}

/// The vehicle's load cells under the same tyres that have a wheelpan of about this mass; empty unless all have one.
std::string OthersWithWheelpan(const Vehicle& vehicle, const ExtraMasses& findings, double kg) {
  constexpr double kAlike = 0.3;
  const std::vector<double> values = vehicle.ParameterValues();
  std::string names;
  for (const auto& [found, extra] : findings) {
    const auto other = std::find_if(vehicle.sensors.begin(), vehicle.sensors.end(), [&, cell = found](const Sensor& s) {
      return s.type == Sensor::Type::kLoadCell && s.tyre == cell->tyre &&
             std::abs(s.wheelpan.At(values) - kg) < kAlike * kg;
    });
    if (other == vehicle.sensors.end()) return "";
    names += (names.empty() ? "" : ", ") + other->name;
  }
  return names;
}

void WarnOfForgotten(const Vehicle& vehicle, const ExtraMasses& findings, ChannelWarnings& warnings) {
  if (findings.empty()) return;
  const ExtraMass mean = MeanOf(findings);
  const std::string others = OthersWithWheelpan(vehicle, findings, mean.kg);
  warnings.Report(kWheelpanForgotten, findings.front().first->name,
                  {InWords(findings), ShownDecimals(mean.kg, DecimalsOf(mean.sd)),
                   others.empty() ? "" : ", or name in `channels` those that have one (" + others + ")"});
}

void WarnOfTakenOut(const ExtraMasses& findings, ChannelWarnings& warnings) {
  if (findings.empty()) return;
  warnings.Report(kWheelpanTakenOut, findings.front().first->name, {InWords(findings)});
}

}  // namespace

std::string MassText(double kg, double sd) {
  const int decimals = DecimalsOf(sd);
  return ShownDecimals(kg, decimals) + " kg (standard deviation " + ShortNumber(sd, 1) + " kg)";
}

void LintWheelpans(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, const std::function<Audit()>& audit,
                   ChannelWarnings& warnings) {
  constexpr double kLight_kg = 4;
  // Of the recordings of the Land Rover with and without a wheelpan's inertia, at the files' values: 0.5 to 0.98, and
  // 0.04 at the most.
  constexpr double kMost = 0.4;
  // A pan that is taken out is taken out as a whole, and none is lighter. A model with friction leaves -5 kg over.
  constexpr double kOfWheelpan = 0.5;
  constexpr double kLightPan_kg = 10;
  const std::vector<double> values = vehicle.ParameterValues();
  ExtraMasses forgotten;
  ExtraMasses taken_out;
  std::optional<Audit> audited;
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    const Sensor& sensor = vehicle.sensors[s];
    if (sensor.type != Sensor::Type::kLoadCell) continue;
    ExtraMass extra = ExtraMassOf(vehicle, runs, modelled, s);
    if (std::abs(extra.kg) < kLight_kg || extra.explained < kMost) continue;
    if (!audited) audited = audit();
    if (const auto found = WheelpanBy(*audited, sensor.name, std::abs(extra.kg))) {
      extra.kg = found->kg;
      extra.sd = found->sd;
      if (std::abs(extra.kg) < kLight_kg) continue;
    }
    const double file_kg = sensor.wheelpan.At(values);
    if (extra.kg < 0 && -extra.kg > std::max(kOfWheelpan * file_kg, kLightPan_kg))
      taken_out.emplace_back(&sensor, extra);
    if (extra.kg < 0) continue;
    extra.kg += file_kg;
    if (!IsWithinBounds(vehicle, sensor, extra.kg)) forgotten.emplace_back(&sensor, extra);
  }
  WarnOfForgotten(vehicle, forgotten, warnings);
  WarnOfTakenOut(taken_out, warnings);
}

}  // namespace fourpost
