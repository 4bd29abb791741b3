#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/comfort/weighted_acceleration.h"
#include "analysis/comfort/weighting.h"
#include "vehicles/ride_metrics/ride_instruments.h"

namespace fourpost {

/// Bands of ride [Hz]: body motion, and what is felt as harshness.
inline constexpr std::array<double, 2> kPrimaryRide_Hz = {0.5, 5};
inline constexpr std::array<double, 2> kSecondaryRide_Hz = {5, 25};

/// Bounds of the classes of a damper's speed [m/s].
inline constexpr std::array<double, 6> kDamperSpeeds = {0.025, 0.05, 0.1, 0.2, 0.4, 0.8};

/// What a vehicle's ride amounts to, of spectra (SpectralRide) or of a time history (RideOfHistory). SI. "rms": about
/// the mean. Peaks of spectra are those reached once in the duration on average, deviation sqrt(2 ln(rate duration)).
struct RideMetrics {
  /// Accelerations at a point.
  struct Comfort {
    std::string point;
    Weighting weighting = Weighting::kWk;
    /// Unweighted, whole band, and in the bands of primary and secondary ride.
    double rms = 0;
    double primary = 0;
    double secondary = 0;
    /// ISO 2631-1. Of spectra the MTVV is not known, NaN, and the VDV is that of normal accelerations.
    WeightedAcceleration weighted;
  };
  std::vector<Comfort> comfort;

  /// Vertical force of a tyre.
  struct Wheel {
    std::string tyre;
    double static_N = 0;
    double mean_N = 0;
    double rms_N = 0;
    double least_N = 0;
    /// Share of time off the ground; for a tyre that may pull, of time with a pull.
    double off_ground = 0;

    /// Coefficient of load variation CPLV, rms over static force.
    double Variation() const { return rms_N / static_N; }
  };
  std::vector<Wheel> wheels;

  struct Axle {
    std::string name;
    /// sqrt(sum of mean squares over sum of squared static forces) of its wheels.
    double variation = 0;
    /// Sum of its wheels' mean squares [N^2], see the car's.
    double load_variance = 0;
    /// Of the chassis above the road under the axle [m]: the platform's variation.
    std::optional<double> ride_height_rms;
  };
  std::vector<Axle> axles;
  /// As of an axle, of all wheels.
  double variation = 0;
  /// Sum of the wheels' mean squares [N^2]: with a lateral force a F - b F^2 of each tyre, b times this is the mean
  /// loss of grip.
  double load_variance = 0;

  /// A damper and its line. Bump is negative.
  struct Strut {
    std::string damper;
    double mean_m = 0;
    double travel_rms_m = 0;
    /// Furthest extension either way, rebound and bump [m].
    double most_m = 0;
    double least_m = 0;
    double speed_rms = 0;
    /// Shares of time within the classes of speed of kDamperSpeeds, slow to fast, the last one without an upper bound.
    std::array<double, kDamperSpeeds.size() + 1> speed_share{};
    /// Speed that is not exceeded in 95 % of time.
    double speed_95 = 0;
    /// Mean power that the dashpot turns into heat [W]; NaN where it is not known, see the source.
    double power_W = 0;
  };
  std::vector<Strut> struts;

  struct Stop {
    std::string stop;
    bool is_bump = true;
    /// Travel to the stop in the design pose, and what the motion leaves of it at the furthest; negative: compressed.
    double gap_m = 0;
    double left_m = 0;
    /// Share of time in contact.
    double contact = 0;
  };
  std::vector<Stop> stops;

  /// Motion of the chassis at its centre of mass, and accelerations. Angles [rad].
  struct Body {
    double heave_rms = 0;
    double pitch_rms = 0;
    double roll_rms = 0;
    double heave_acceleration = 0;
    double pitch_acceleration = 0;
    double roll_acceleration = 0;
    /// Of pitch and roll, weighted by We [rad/s^2].
    double pitch_weighted = 0;
    double roll_weighted = 0;
    /// Mean heave by the forces of dampers (jacking) and stops.
    double mean_heave = 0;
  };
  std::optional<Body> body;

  double duration_s = 0;
};

/// One number of them by its name, e.g. "a_cg.Wk", "front_tyre.variation".
struct NamedMetric {
  std::string name;
  double value = 0;
  /// SI, e.g. "m/s^2"; "1" for a share.
  std::string unit;
};

/// All that a setting may be chosen by; NaN where not known.
std::vector<NamedMetric> NamedMetrics(const RideMetrics& metrics);

/// Completes the sums of axles and car from the wheels.
void SumWheels(const RideInstruments& instruments, RideMetrics& metrics);

}  // namespace fourpost
