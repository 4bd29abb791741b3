#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/random_response/random_vehicle.h"
#include "vehicles/ride_metrics/ride_instruments.h"
#include "vehicles/ride_metrics/ride_metrics.h"

namespace fourpost {

/// Ride metrics of a vehicle's spectra. What does not depend on the vehicle's parameters is prepared once:
///
///     const RideInstruments instruments = InstrumentRide(vehicle);
///     const CondensedVehicle condensed(instruments.vehicle);
///     const SpectralRide ride(instruments, grid);
///     const PostSpectra road = RoadSpectra(RoadTracksOf(vehicle), roughness, speed, grid);
///     // For each set of values:
///     const CondensedModel model = condensed.At(values);
///     const RandomVehicle random(model, grid);
///     // For each road:
///     const RideMetrics metrics = ride.MetricsOf(model, values, random.Solve(road), road);
///
/// Normal distributions throughout. Power of a dashpot is E[f(v) v]; that of hydraulic dampers is NaN. Immutable; one
/// object serves any number of threads.
class SpectralRide {
 public:
  /// Peaks are those of this duration, doses as well.
  SpectralRide(RideInstruments instruments, const SpectralGrid& grid, double duration_s = 60);

  /// `response`: of the model at these values on these posts.
  RideMetrics MetricsOf(const CondensedModel& model, std::span<const double> values, const RandomResponse& response,
                        const PostSpectra& posts) const;

  const RideInstruments& instruments() const { return instruments_; }

 private:
  struct Answer;
  /// What a normal motion is.
  struct Motion {
    double deviation = 0;
    /// Of its rate.
    double rate_deviation = 0;
  };

  Motion MotionOf(const Eigen::RowVectorXcd& amplitudes) const;
  double DeviationOf(const Eigen::RowVectorXcd& amplitudes, const Eigen::ArrayXd& shares) const;
  double PeakOf(const Motion& motion) const;

  RideInstruments instruments_;
  double duration_s_;
  /// Shares of an integral over the band, and these times w^2, w^4; of the bands of ride; times |W|^2 of each
  /// weighting.
  Eigen::ArrayXd shares_;
  Eigen::ArrayXd rate_shares_;
  Eigen::ArrayXd acceleration_shares_;
  Eigen::ArrayXd primary_shares_;
  Eigen::ArrayXd secondary_shares_;
  std::array<Eigen::ArrayXd, kWeightings.size()> weighted_shares_;
  /// Times w^4 |We|^2, for angles.
  Eigen::ArrayXd turn_shares_;
};

}  // namespace fourpost
