#pragma once

#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/simulation/sensor_model.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// The single wheel station on a sweep from 1 to 20 Hz in 6 s, recorded at 500 Hz through a filter.
inline TimeHistory RecordStation(const Vehicle& vehicle, std::optional<SensorModel::Filter> filter,
                                 double amplitude_m = 0.01, double top_speed = 0.15) {
  const SweptSine sweep{
      .first_Hz = 1, .last_Hz = 20, .duration_s = 6, .amplitude_m = amplitude_m, .top_speed = top_speed};
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  TimeHistory history = SimulateCondensed(model, RigViewOf(vehicle), FollowPattern(sweep.Signal(), {1}),
                                          {.start_s = 0, .end_s = 6.5, .rate_Hz = 500}, {.error = 1e-4})
                            .history;
  SensorModel{.filter = filter}.Apply(history);
  return history;
}

/// As a recording: time, z_ground, the sensors; with offsets, which are not told.
inline std::string StationCsv(const TimeHistory& history, const Vehicle& vehicle) {
  std::ostringstream csv;
  csv.precision(9);
  csv << "time,z_ground";
  for (const Sensor& sensor : vehicle.sensors) csv << ',' << sensor.name;
  csv << "\ns,m,m,m,m/s^2,m/s^2,N\n";
  for (Eigen::Index k = 0; k < history.size(); ++k) {
    csv << history.TimeAt(k) << ',' << history.posts(k, 0) - 0.012;
    for (Eigen::Index i = 0; i < history.readings.cols(); ++i) csv << ',' << history.readings(k, i) + 0.1;
    csv << '\n';
  }
  return csv.str();
}

}  // namespace fourpost
