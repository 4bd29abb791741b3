#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identify/choice/metric.h"
#include "identify/choice/settings_file.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride_metrics/ride_instruments.h"
#include "vehicles/ride_metrics/ride_spectra.h"

namespace fourpost {

/// How a car rides, by three engines. Metrics: "comfort", the root mean square over the points of the chassis of
/// vertical accelerations weighted by Wk; "grip", the variation of all tyre loads; those of NamedMetrics() that spectra
/// know; and of the body's modes, "heave.damping" and the like, the damping ratio.
class CarMetrics {
 public:
  /// Throws FaultyInput where the vehicle cannot be assembled, held, or has no posts on a road.
  explicit CarMetrics(const Vehicle& vehicle);

  const std::vector<Metric>& metrics() const { return metrics_; }

  /// By power spectra with statistical linearisation, within a band. It refers to this object, which must outlive it.
  MetricsOf Spectra(const SettingsFile& settings) const;

  enum class TimeEngine { kReduced, kMultibody };
  /// Over time, on one random road of each kind, the same for every setting.
  MetricsOf Histories(const SettingsFile& settings, TimeEngine engine) const;

  /// Of each damper on each road at these values: the speed that is not exceeded in 95 % of time [m/s].
  Eigen::MatrixXd DamperSpeeds(const SettingsFile& settings, std::span<const double> parameters) const;

  /// On the first of the roads with the largest weight.
  RideSpectra SpectraAt(const SettingsFile& settings, std::span<const double> parameters) const;

 private:
  class SpectralCar;
  class HistoryCar;

  std::shared_ptr<const SpectralCar> MakeSpectral(const SettingsFile& settings) const;

  const Vehicle& vehicle_;
  RideInstruments instruments_;
  std::vector<Metric> metrics_;
};

}  // namespace fourpost
