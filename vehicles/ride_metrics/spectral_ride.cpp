#include "vehicles/ride_metrics/spectral_ride.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/text/option_check.h"
#include "vehicles/condensed/port.h"

namespace fourpost {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::RowVectorXcd;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// |v| below this many deviations in 95 % of time.
constexpr double kNinetyFive = 1.959963984540054;

/// Index in the model's dashpots of each damper, -1 for a hydraulic one; a hydraulic damper's friction is one more.
std::vector<int> DashpotsOf(const Vehicle& vehicle) {
  std::vector<int> dashpots;
  int next = 0;
  for (const Damper& damper : vehicle.dampers) {
    dashpots.push_back(damper.hydraulic ? -1 : next);
    next += damper.hydraulic && damper.law.friction && !damper.law.Sticks() ? 2 : 1;
  }
  return dashpots;
}

/// Of a normal speed.
void ClassSpeeds(double deviation, RideMetrics::Strut& strut) {
  strut.speed_rms = deviation;
  strut.speed_95 = kNinetyFive * deviation;
  double below = 0;
  for (std::size_t i = 0; i <= kDamperSpeeds.size(); ++i) {
    const double within =
        i < kDamperSpeeds.size() && deviation > 0 ? 1 - 2 * NormalShareBelow(-kDamperSpeeds[i] / deviation) : 1;
    strut.speed_share[i] = within - below;
    below = within;
  }
}

}  // namespace

SpectralRide::SpectralRide(RideInstruments instruments, const SpectralGrid& grid, double duration_s)
    : instruments_(std::move(instruments)), duration_s_(duration_s) {
  RequirePositive("SpectralRide: duration_s", duration_s);
  const auto size = static_cast<Index>(grid.size());
  const ArrayXd frequency = Eigen::Map<const ArrayXd>(grid.frequency_Hz.data(), size);
  shares_ = Eigen::Map<const ArrayXd>(grid.share_Hz.data(), size);
  const ArrayXd square = (2 * std::numbers::pi * frequency).square();
  rate_shares_ = shares_ * square;
  acceleration_shares_ = rate_shares_ * square;
  const auto within = [&](const std::array<double, 2>& band) {
    return (frequency >= band[0] && frequency < band[1]).select(shares_, 0.0).eval();
  };
  primary_shares_ = within(kPrimaryRide_Hz);
  secondary_shares_ = within(kSecondaryRide_Hz);
  for (const Weighting weighting : kWeightings) {
    const WeightingFilter filter(weighting);
    weighted_shares_[static_cast<std::size_t>(weighting)] =
        shares_ * frequency.unaryExpr([&](double f) { return std::norm(filter.Response(f)); });
  }
  turn_shares_ = weighted_shares_[static_cast<std::size_t>(Weighting::kWe)] * square.square();
}

double SpectralRide::DeviationOf(const RowVectorXcd& amplitudes, const ArrayXd& shares) const {
  const Index sources = amplitudes.size() / shares.size();
  double square = 0;
  for (Index k = 0; k < shares.size(); ++k) {
    double here = 0;
    for (Index s = 0; s < sources; ++s) here += std::norm(amplitudes[k * sources + s]);
    square += shares[k] * here;
  }
  return std::sqrt(square);
}

SpectralRide::Motion SpectralRide::MotionOf(const RowVectorXcd& amplitudes) const {
  return {DeviationOf(amplitudes, shares_), DeviationOf(amplitudes, rate_shares_)};
}

double SpectralRide::PeakOf(const Motion& motion) const {
  if (motion.deviation == 0) return 0;
  const double rate = motion.rate_deviation / (2 * std::numbers::pi * motion.deviation);
  return motion.deviation * std::sqrt(2 * std::log(std::max(1.0, rate * duration_s_)));
}

/// One answer: a vehicle at its values on one road.
struct SpectralRide::Answer {
  const SpectralRide& ride;
  const CondensedModel& model;
  std::span<const double> values;
  const RandomResponse& response;
  const PostSpectra& posts;

  const RideInstruments& instruments() const { return ride.instruments_; }
  const Vehicle& vehicle() const { return ride.instruments_.vehicle; }
  RowVectorXcd Reading(std::size_t sensor) const { return response.readings.row(static_cast<Index>(sensor)); }
  double Mean(std::size_t sensor) const { return response.mean_readings[static_cast<Index>(sensor)]; }

  RideMetrics::Comfort ComfortAt(const RideInstruments::Felt& felt) const;
  std::vector<RideMetrics::Wheel> Wheels() const;
  RideMetrics::Wheel Lifting(RideMetrics::Wheel wheel, std::size_t liftoff) const;
  RideMetrics::Wheel Curved(RideMetrics::Wheel wheel, std::size_t curved) const;
  std::vector<RideMetrics::Strut> Struts() const;
  std::vector<RideMetrics::Stop> Stops() const;
  RideMetrics::Body BodyAt(const RideInstruments::Chassis& at) const;
  RideMetrics::Axle AxleOf(const RideInstruments::Axle& axle) const;
};

RideMetrics::Comfort SpectralRide::Answer::ComfortAt(const RideInstruments::Felt& felt) const {
  const RowVectorXcd acceleration = Reading(felt.sensor);
  const double rms = ride.DeviationOf(acceleration, ride.weighted_shares_[static_cast<std::size_t>(felt.weighting)]);
  return {.point = felt.name,
          .weighting = felt.weighting,
          .rms = ride.DeviationOf(acceleration, ride.shares_),
          .primary = ride.DeviationOf(acceleration, ride.primary_shares_),
          .secondary = ride.DeviationOf(acceleration, ride.secondary_shares_),
          .weighted = {.rms = rms,
                       .mtvv = kUnknown,
                       .vdv = VibrationDoseOfRandom(rms, ride.duration_s_),
                       .duration_s = ride.duration_s_}};
}

std::vector<RideMetrics::Wheel> SpectralRide::Answer::Wheels() const {
  std::vector<RideMetrics::Wheel> wheels;
  std::size_t liftoff = 0;
  std::size_t curved = 0;
  for (std::size_t i = 0; i < vehicle().tyres.size(); ++i) {
    const Tyre& tyre = vehicle().tyres[i];
    const Motion force = ride.MotionOf(Reading(instruments().loads[i]));
    RideMetrics::Wheel wheel{.tyre = tyre.name, .static_N = model.preloads.tyre[i]};
    wheel.mean_N = wheel.static_N + Mean(instruments().loads[i]);
    wheel.rms_N = force.deviation;
    wheel.least_N = wheel.mean_N - ride.PeakOf(force);
    wheel.off_ground = force.deviation > 0 ? NormalShareBelow(-wheel.mean_N / force.deviation) : 0;
    if (!tyre.law.IsLinear()) wheel = Curved(wheel, curved++);
    else if (tyre.lifts_off) wheel = Lifting(wheel, liftoff++);
    wheels.push_back(wheel);
  }
  return wheels;
}

/// The tyre's motion makes a normal force, of which the tyre keeps what pushes. `wheel`: by the linear law in its
/// place, which has the same rate of zero crossings.
RideMetrics::Wheel SpectralRide::Answer::Lifting(RideMetrics::Wheel wheel, std::size_t liftoff) const {
  const CondensedModel::Liftoff& law = model.liftoffs[liftoff];
  const PortMotion& motion = response.ports[response.ports.size() - model.liftoffs.size() + liftoff];
  const double mean = law.preload + law.stiffness * motion.mean;
  const double deviation = std::hypot(law.stiffness * motion.extension_sd, law.damping * motion.rate_sd);
  const double peak = wheel.rms_N > 0 ? (wheel.mean_N - wheel.least_N) / wheel.rms_N : 0;
  const LiftingForce force = LiftingForceOf(mean, deviation);
  wheel.mean_N = force.mean;
  wheel.rms_N = force.deviation;
  wheel.least_N = std::max(0.0, mean - peak * deviation);
  wheel.off_ground = force.off_ground;
  return wheel;
}

/// The same of a tyre whose rate changes with its load. The least force is that of the least deflection, in which a
/// damping force counts as the deflection that makes it.
RideMetrics::Wheel SpectralRide::Answer::Curved(RideMetrics::Wheel wheel, std::size_t curved) const {
  const CondensedModel::CurvedTyre& tyre = model.curved_tyres[curved];
  const std::size_t first = response.ports.size() - model.liftoffs.size() - model.curved_tyres.size();
  const PortMotion& motion = response.ports[first + curved];
  const double rate = tyre.law.Rate(motion.mean);
  const double deviation = std::hypot(motion.extension_sd, tyre.damping / rate * motion.rate_sd);
  const double peak = wheel.rms_N > 0 ? (wheel.mean_N - wheel.least_N) / wheel.rms_N : 0;
  const LiftingForce force = LiftingForceOf(TyreRemainder{tyre.law, tyre.damping, rate}, motion);
  wheel.mean_N = force.mean;
  wheel.rms_N = force.deviation;
  wheel.least_N = std::max(0.0, tyre.law.Force(motion.mean - peak * deviation));
  wheel.off_ground = force.off_ground;
  return wheel;
}

std::vector<RideMetrics::Strut> SpectralRide::Answer::Struts() const {
  const std::vector<int> dashpots = DashpotsOf(vehicle());
  std::vector<RideMetrics::Strut> struts;
  for (std::size_t i = 0; i < vehicle().dampers.size(); ++i) {
    const Motion motion = ride.MotionOf(Reading(instruments().dampers[i]));
    RideMetrics::Strut strut{.damper = vehicle().dampers[i].name,
                             .mean_m = Mean(instruments().dampers[i]),
                             .travel_rms_m = motion.deviation,
                             .power_W = kUnknown};
    strut.most_m = strut.mean_m + ride.PeakOf(motion);
    strut.least_m = strut.mean_m - ride.PeakOf(motion);
    ClassSpeeds(motion.rate_deviation, strut);
    if (dashpots[i] >= 0) {
      const double speed = ride.DeviationOf(response.dashpots.row(dashpots[i]), ride.rate_shares_);
      const DashpotLaw& law = model.dashpots[static_cast<std::size_t>(dashpots[i])].law;
      strut.power_W = GainOf(DashpotRemainder{law, 0}, {.rate_sd = speed}).by_rate * speed * speed;
      if (const std::optional<DahlFriction> friction = vehicle().dampers[i].law.StickingAt(values))
        strut.power_W +=
            GainOf(FrictionRemainder{*friction}, {.extension_sd = motion.deviation, .rate_sd = motion.rate_deviation})
                .by_rate *
            motion.rate_deviation * motion.rate_deviation;
    }
    struts.push_back(std::move(strut));
  }
  return struts;
}

std::vector<RideMetrics::Stop> SpectralRide::Answer::Stops() const {
  std::vector<RideMetrics::Stop> stops;
  for (const RideInstruments::Stop& stop : instruments().stops) {
    const Spring& spring = vehicle().springs[stop.spring];
    const SpringLaw law = spring.law.At(values);
    const Motion motion = ride.MotionOf(Reading(stop.sensor));
    for (const SpringLaw::Knee& knee : law.knees) {
      const double gap = knee.side * (knee.at - Mean(stop.sensor));
      const bool is_bump = knee.side < 0;
      const double contact = motion.deviation > 0 ? NormalShareBelow(-gap / motion.deviation) : (gap < 0 ? 1.0 : 0.0);
      stops.push_back({.stop = spring.name,
                       .is_bump = is_bump,
                       .gap_m = knee.side * knee.at,
                       .left_m = gap - ride.PeakOf(motion),
                       .contact = contact});
    }
  }
  return stops;
}

RideMetrics::Body SpectralRide::Answer::BodyAt(const RideInstruments::Chassis& at) const {
  const RowVectorXcd heave = Reading(at.centre);
  const RowVectorXcd pitch = (heave - Reading(at.ahead)) / RideInstruments::kLever_m;
  const RowVectorXcd roll = (Reading(at.left) - heave) / RideInstruments::kLever_m;
  return {.heave_rms = ride.DeviationOf(heave, ride.shares_),
          .pitch_rms = ride.DeviationOf(pitch, ride.shares_),
          .roll_rms = ride.DeviationOf(roll, ride.shares_),
          .heave_acceleration = ride.DeviationOf(heave, ride.acceleration_shares_),
          .pitch_acceleration = ride.DeviationOf(pitch, ride.acceleration_shares_),
          .roll_acceleration = ride.DeviationOf(roll, ride.acceleration_shares_),
          .pitch_weighted = ride.DeviationOf(pitch, ride.turn_shares_),
          .roll_weighted = ride.DeviationOf(roll, ride.turn_shares_),
          .mean_heave = Mean(at.centre)};
}

RideMetrics::Axle SpectralRide::Answer::AxleOf(const RideInstruments::Axle& axle) const {
  RideMetrics::Axle answer{.name = axle.name};
  if (!axle.height || axle.posts.empty()) return answer;
  RowVectorXcd height = Reading(*axle.height);
  for (const std::size_t post : axle.posts)
    height -= posts.heights.row(static_cast<Index>(post)) / static_cast<double>(axle.posts.size());
  answer.ride_height_rms = ride.DeviationOf(height, ride.shares_);
  return answer;
}

RideMetrics SpectralRide::MetricsOf(const CondensedModel& model, std::span<const double> values,
                                    const RandomResponse& response, const PostSpectra& posts) const {
  const Answer answer{*this, model, values, response, posts};
  RideMetrics metrics{.duration_s = duration_s_};
  for (const RideInstruments::Felt& felt : instruments_.points) metrics.comfort.push_back(answer.ComfortAt(felt));
  metrics.wheels = answer.Wheels();
  metrics.struts = answer.Struts();
  metrics.stops = answer.Stops();
  if (instruments_.chassis) metrics.body = answer.BodyAt(*instruments_.chassis);
  for (const RideInstruments::Axle& axle : instruments_.axles) metrics.axles.push_back(answer.AxleOf(axle));
  SumWheels(instruments_, metrics);
  return metrics;
}

}  // namespace fourpost
