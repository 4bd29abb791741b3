#include "vehicles/ride_metrics/spectral_ride.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"
#include "tests/vehicles/hydraulic_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/band_noise.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/ride_metrics/history_ride.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost::spectral_ride_test {
namespace {

using std::numbers::pi;

constexpr double kRoughness = 256e-6;
constexpr double kSpeed = 60 / 3.6;

Vehicle LinearCar(const std::string& name) {
  Vehicle vehicle = WithLinearTyres(ShippedVehicle(name));
  for (Damper& damper : vehicle.dampers) {
    damper.law.rebound = damper.law.compression;
    damper.law.friction.reset();
  }
  return vehicle;
}

/// A road that repeats: sums of sines of one spacing, whose mean squares over a period are those of their amplitudes.
struct PeriodicRoad {
  static constexpr SineGrid kGrid{.step_s = 1.0 / 1920, .count = 1 << 17};
  static constexpr double kPeriod_s = (1 << 17) / 1920.0;
  /// 2^15 samples in a period.
  static constexpr double kRate_Hz = 480;

  /// The band that lines from 0.5 to 30 Hz stand for, each for the spacing about it.
  static double Lower() { return (std::ceil(0.5 / kGrid.spacing_Hz()) - 0.5) * kGrid.spacing_Hz(); }
  static double Upper() { return (std::floor(30 / kGrid.spacing_Hz()) + 0.5) * kGrid.spacing_Hz(); }

  static PostMotion Under(const RoadTracks& tracks) {
    const auto source = [&](const char* name, double sign) {
      RandomStream draws(5, name);
      return SumOfSines(kGrid, 0.5, 30, [&](double f) {
        const double share = 0.5 * (1 + sign * TrackCoherence(f / kSpeed, tracks.distance));
        return std::polar(std::sqrt(2 * RoadDensity(kRoughness, kSpeed, f) * kGrid.spacing_Hz() * share),
                          2 * pi * draws.Uniform());
      });
    };
    const std::vector<double> alike = source("alike", 1);
    const std::vector<double> apart = source("apart", -1);
    std::vector<DelayedTrack> followed;
    for (const RoadTracks::Place& place : tracks.posts) {
      std::vector<double> heights;
      for (std::size_t k = 0; k < 3 * kGrid.count; ++k)
        heights.push_back(alike[k % kGrid.count] + place.side * apart[k % kGrid.count]);
      followed.push_back({UniformSpline(0, kGrid.step_s, heights), place.behind / kSpeed});
    }
    return FollowTracks(std::move(followed));
  }
};

struct Both {
  std::map<std::string, double> spectra;
  std::map<std::string, double> time;
};

std::map<std::string, double> ByName(const RideMetrics& metrics) {
  std::map<std::string, double> named;
  for (const NamedMetric& metric : NamedMetrics(metrics)) named[metric.name] = metric.value;
  return named;
}

Both BothWays(const Vehicle& vehicle) {
  const RideInstruments instruments = InstrumentRide(vehicle);
  const CondensedVehicle condensed(instruments.vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = condensed.At(values);
  const RoadTracks tracks = RoadTracksOf(vehicle);
  const SpectralGrid grid =
      SpectralGrid::For(PeriodicRoad::Lower(), PeriodicRoad::Upper(), tracks.length() / kSpeed, 0.05);
  const PostSpectra road = RoadSpectra(tracks, kRoughness, kSpeed, grid);
  const RandomResponse response = RandomVehicle(model, grid).Solve(road);
  EXPECT_TRUE(response.converged);
  const SpectralRide ride(instruments, grid, PeriodicRoad::kPeriod_s);
  CondensedHistory history =
      SimulateCondensed(model, RigViewOf(instruments.vehicle), PeriodicRoad::Under(tracks),
                        {0, 2.5 * PeriodicRoad::kPeriod_s, PeriodicRoad::kRate_Hz, 0}, {.error = 2e-4});
  // A period, after the start has died away.
  history.history.DropFirst(1 << 15);
  const auto period = static_cast<Eigen::Index>(1 << 15);
  history.history.readings = history.history.readings.topRows(period).eval();
  history.history.posts = history.history.posts.topRows(period).eval();
  return {ByName(ride.MetricsOf(model, values, response, road)),
          ByName(RideOfHistory(instruments, model, values, history.history))};
}

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether both ways give the same number: not a peak, a dose or a quantile of a normal distribution, nor what is known
/// in one way only.
bool IsMeanSquare(const std::string& name) {
  for (const char* end : {".mtvv", ".vdv", ".least_load", ".off_ground", ".bump", ".rebound", ".speed_95", ".remaining",
                          ".contact", ".mean_heave"})
    if (EndsWith(name, end)) return false;
  return true;
}

/// Whether it belongs to one side of the car: over one period of the road both of its sources are not uncorrelated, by
/// a percent of a sided number, with opposite signs left and right.
bool IsSided(const std::string& name) {
  for (const char* side : {"_FL", "_FR", "_RL", "_RR", "_left", "_right"})
    if (name.find(side) != std::string::npos) return true;
  return false;
}

/// Largest relative difference of a number known in both ways.
struct Difference {
  double size = 0;
  std::string metric;
  int compared = 0;
};

Difference LargestOf(const Both& both, const std::function<bool(const std::string&)>& counts) {
  Difference largest;
  for (const auto& [metric, value] : both.spectra) {
    const double time = both.time.at(metric);
    if (!IsMeanSquare(metric) || IsSided(metric) || !counts(metric)) continue;
    if (std::abs(value) < 1e-9 || std::isnan(time)) continue;
    ++largest.compared;
    if (const double size = std::abs(value / time - 1); size > largest.size)
      largest = {.size = size, .metric = metric, .compared = largest.compared};
  }
  return largest;
}

bool IsBand(const std::string& name) { return EndsWith(name, ".primary") || EndsWith(name, ".secondary"); }

TEST(SpectralRide, OfLinearCarsIsThatOfTheirHistories) {
  for (const char* name : {"quarter_car", "landrover110_model1", "landrover110_model3"}) {
    const Both both = BothWays(LinearCar(name));
    const Difference whole = LargestOf(both, [](const std::string& metric) { return !IsBand(metric); });
    EXPECT_LT(whole.size, 0.005) << name << ' ' << whole.metric;
    EXPECT_GT(whole.compared, 10) << name;
    // Of time histories by Welch's method, whose window smears a band's ends by a quarter of a hertz.
    const Difference bands = LargestOf(both, IsBand);
    EXPECT_LT(bands.size, 0.01) << name << ' ' << bands.metric;
  }
}

// What statistical linearisation leaves: up to 4 % of a mean square's root; of roll, whose damping bilinear dampers
// modulate by heave, 12 %.
TEST(SpectralRide, OfNonlinearCarsIsAnEstimate) {
  for (const char* name : {"landrover110_linkage", "landrover110_model3", "independent_roadster"}) {
    const Both both = BothWays(ShippedVehicle(name));
    const auto is_roll = [](const std::string& metric) { return metric == "body.roll" || metric == "body.roll_We"; };
    const Difference most = LargestOf(both, [&](const std::string& metric) { return !is_roll(metric); });
    EXPECT_LT(most.size, 0.05) << name << ' ' << most.metric;
    EXPECT_GT(most.compared, 10) << name;
    const Difference roll = LargestOf(both, is_roll);
    EXPECT_LT(roll.size, 0.15) << name << ' ' << roll.metric;
    // Jacking.
    EXPECT_NEAR(both.spectra.at("body.mean_heave") / both.time.at("body.mean_heave"), 1, 0.05) << name;
  }
}

// Oil has a memory, which a sine of the same deviations stands for.
TEST(SpectralRide, OfHydraulicDampersIsAnEstimate) {
  const Both both = BothWays(LinkageCarOnOil());
  const Difference most = LargestOf(both, [](const std::string&) { return true; });
  EXPECT_LT(most.size, 0.15) << most.metric;
  EXPECT_GT(most.compared, 10);
  EXPECT_TRUE(std::isnan(both.spectra.at("front_damper.power")));
}

}  // namespace
}  // namespace fourpost::spectral_ride_test
