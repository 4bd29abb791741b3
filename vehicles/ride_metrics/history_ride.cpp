#include "vehicles/ride_metrics/history_ride.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "analysis/signals/spectrum.h"
#include "analysis/signals/spline_through.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Length of the segments by which power is split into bands: both ends of a band fall on its frequencies.
constexpr double kSegment_s = 8;

double RmsOf(const ArrayXd& signal) { return std::sqrt((signal - signal.mean()).square().mean()); }

std::vector<double> Samples(const ArrayXd& signal) { return {signal.data(), signal.data() + signal.size()}; }

/// Slope and curvature of the spline through samples.
struct Derivatives {
  ArrayXd slope;
  ArrayXd curvature;
};

Derivatives DerivativesOf(const ArrayXd& signal, double rate_Hz) {
  const double step = 1 / rate_Hz;
  const UniformSpline spline = SplineThrough({signal.data(), static_cast<std::size_t>(signal.size())}, 0, step);
  Derivatives derivatives{ArrayXd(signal.size()), ArrayXd(signal.size())};
  for (Index k = 0; k < signal.size(); ++k) {
    const UniformSpline::Point point = spline.At(std::min(static_cast<double>(k) * step, spline.end()));
    derivatives.slope[k] = point.slope;
    derivatives.curvature[k] = point.curvature;
  }
  return derivatives;
}

/// Mean squares within the bands of ride.
struct BandPower {
  double primary = 0;
  double secondary = 0;
};

BandPower BandsOf(const ArrayXd& signal, double rate_Hz) {
  const auto whole = static_cast<std::size_t>(signal.size());
  const std::size_t segment = std::min(whole, static_cast<std::size_t>(std::lround(kSegment_s * rate_Hz)));
  const std::span<const double> samples(signal.data(), whole);
  const Spectrum spectrum = WelchSpectrum(samples, samples, rate_Hz, segment);
  const double spacing = rate_Hz / static_cast<double>(segment);
  BandPower power;
  for (std::size_t k = 0; k < spectrum.frequency_Hz.size(); ++k) {
    const double f = spectrum.frequency_Hz[k];
    const double part = spacing * spectrum.first[k];
    if (f >= kPrimaryRide_Hz[0] && f < kPrimaryRide_Hz[1]) power.primary += part;
    if (f >= kSecondaryRide_Hz[0] && f < kSecondaryRide_Hz[1]) power.secondary += part;
  }
  return power;
}

/// Of |v|.
void ClassSpeeds(const ArrayXd& speed, RideMetrics::Strut& strut) {
  std::vector<double> sizes = Samples(speed.abs());
  std::sort(sizes.begin(), sizes.end());
  const auto count = static_cast<double>(sizes.size());
  strut.speed_rms = std::sqrt(speed.square().mean());
  strut.speed_95 = sizes[static_cast<std::size_t>(0.95 * (count - 1))];
  double below = 0;
  for (std::size_t i = 0; i <= kDamperSpeeds.size(); ++i) {
    const double within =
        i < kDamperSpeeds.size()
            ? static_cast<double>(std::lower_bound(sizes.begin(), sizes.end(), kDamperSpeeds[i]) - sizes.begin()) /
                  count
            : 1;
    strut.speed_share[i] = within - below;
    below = within;
  }
}

struct HistoryAnswer {
  const RideInstruments& instruments;
  const CondensedModel& model;
  std::span<const double> values;
  const TimeHistory& history;

  ArrayXd Reading(std::size_t sensor) const { return history.readings.col(static_cast<Index>(sensor)).array(); }

  RideMetrics::Comfort ComfortAt(const RideInstruments::Felt& felt) const {
    const ArrayXd acceleration = Reading(felt.sensor);
    const std::vector<double> weighted = WeightingFilter(felt.weighting).Apply(Samples(acceleration), history.rate_Hz);
    const BandPower power = BandsOf(acceleration, history.rate_Hz);
    return {.point = felt.name,
            .weighting = felt.weighting,
            .rms = RmsOf(acceleration),
            .primary = std::sqrt(power.primary),
            .secondary = std::sqrt(power.secondary),
            .weighted = MeasuresOf(weighted, history.rate_Hz)};
  }

  RideMetrics::Wheel WheelOf(std::size_t tyre) const {
    const ArrayXd force = model.preloads.tyre[tyre] + Reading(instruments.loads[tyre]);
    // Rounding of a force that is zero off the ground.
    const double zero = 1e-9 * model.preloads.tyre[tyre];
    return {.tyre = instruments.vehicle.tyres[tyre].name,
            .static_N = model.preloads.tyre[tyre],
            .mean_N = force.mean(),
            .rms_N = RmsOf(force),
            .least_N = force.minCoeff(),
            .off_ground = static_cast<double>((force <= zero).count()) / static_cast<double>(force.size())};
  }

  RideMetrics::Strut StrutOf(std::size_t i) const {
    const Damper& damper = instruments.vehicle.dampers[i];
    const ArrayXd extension = Reading(instruments.dampers[i]);
    const ArrayXd speed = DerivativesOf(extension, history.rate_Hz).slope;
    RideMetrics::Strut strut{.damper = damper.name,
                             .mean_m = extension.mean(),
                             .travel_rms_m = RmsOf(extension),
                             .most_m = extension.maxCoeff(),
                             .least_m = extension.minCoeff(),
                             .power_W = std::numeric_limits<double>::quiet_NaN()};
    ClassSpeeds(speed, strut);
    if (damper.hydraulic || damper.series) return strut;
    std::vector<double> force(static_cast<std::size_t>(speed.size()));
    damper.law.At(values).Forces({speed.data(), force.size()}, force);
    strut.power_W = (speed * Eigen::Map<const ArrayXd>(force.data(), speed.size())).mean();
    if (const std::optional<DahlFriction> friction = damper.law.StickingAt(values))
      strut.power_W += PowerOf(*friction, extension);
    return strut;
  }

  /// Over a record that begins at rest; springs that it leaves bent count as lost.
  double PowerOf(const DahlFriction& friction, const ArrayXd& extension) const {
    double force = 0;
    double work = 0;
    for (Eigen::Index k = 1; k < extension.size(); ++k) {
      const double stroke = extension[k] - extension[k - 1];
      const double after = friction.After(force, stroke).force;
      work += 0.5 * (force + after) * stroke;
      force = after;
    }
    return work * history.rate_Hz / static_cast<double>(extension.size() - 1);
  }

  std::vector<RideMetrics::Stop> Stops() const {
    std::vector<RideMetrics::Stop> stops;
    for (const RideInstruments::Stop& stop : instruments.stops) {
      const Spring& spring = instruments.vehicle.springs[stop.spring];
      const SpringLaw law = spring.law.At(values);
      for (const SpringLaw::Knee& knee : law.knees) {
        const ArrayXd left = knee.side * (knee.at - Reading(stop.sensor));
        stops.push_back({.stop = spring.name,
                         .is_bump = knee.side < 0,
                         .gap_m = knee.side * knee.at,
                         .left_m = left.minCoeff(),
                         .contact = static_cast<double>((left < 0).count()) / static_cast<double>(left.size())});
      }
    }
    return stops;
  }

  RideMetrics::Body BodyAt(const RideInstruments::Chassis& at) const {
    const ArrayXd heave = Reading(at.centre);
    const ArrayXd pitch = (heave - Reading(at.ahead)) / RideInstruments::kLever_m;
    const ArrayXd roll = (Reading(at.left) - heave) / RideInstruments::kLever_m;
    const auto acceleration = [&](const ArrayXd& signal) { return DerivativesOf(signal, history.rate_Hz).curvature; };
    const auto weighted = [&](const ArrayXd& signal) {
      return MeasuresOf(WeightingFilter(Weighting::kWe).Apply(Samples(acceleration(signal)), history.rate_Hz),
                        history.rate_Hz)
          .rms;
    };
    return {.heave_rms = RmsOf(heave),
            .pitch_rms = RmsOf(pitch),
            .roll_rms = RmsOf(roll),
            .heave_acceleration = RmsOf(acceleration(heave)),
            .pitch_acceleration = RmsOf(acceleration(pitch)),
            .roll_acceleration = RmsOf(acceleration(roll)),
            .pitch_weighted = weighted(pitch),
            .roll_weighted = weighted(roll),
            .mean_heave = heave.mean()};
  }

  RideMetrics::Axle AxleOf(const RideInstruments::Axle& axle) const {
    RideMetrics::Axle answer{.name = axle.name};
    if (!axle.height || axle.posts.empty()) return answer;
    ArrayXd height = Reading(*axle.height);
    for (const std::size_t post : axle.posts)
      height -= history.posts.col(static_cast<Index>(post)).array() / static_cast<double>(axle.posts.size());
    answer.ride_height_rms = RmsOf(height);
    return answer;
  }
};

}  // namespace

RideMetrics RideOfHistory(const RideInstruments& instruments, const CondensedModel& model,
                          std::span<const double> values, const TimeHistory& history) {
  RequireOption(history.size() >= 4, "RideOfHistory: samples", history.size(), "four at least");
  const HistoryAnswer answer{instruments, model, values, history};
  RideMetrics metrics{.duration_s = static_cast<double>(history.size() - 1) / history.rate_Hz};
  for (const RideInstruments::Felt& felt : instruments.points) metrics.comfort.push_back(answer.ComfortAt(felt));
  for (std::size_t i = 0; i < instruments.loads.size(); ++i) metrics.wheels.push_back(answer.WheelOf(i));
  for (std::size_t i = 0; i < instruments.dampers.size(); ++i) metrics.struts.push_back(answer.StrutOf(i));
  metrics.stops = answer.Stops();
  if (instruments.chassis) metrics.body = answer.BodyAt(*instruments.chassis);
  for (const RideInstruments::Axle& axle : instruments.axles) metrics.axles.push_back(answer.AxleOf(axle));
  SumWheels(instruments, metrics);
  return metrics;
}

}  // namespace fourpost
