#pragma once

#include <complex>
#include <string>

#include <Eigen/Core>

#include "analysis/signals/frequency_response.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// Unit of a sensor's readings: "m/s^2", "m", "N", "rad/s".
std::string UnitOf(Sensor::Type type);

/// What responses of such a sensor are relative to, per metre of the reference post's amplitude: its acceleration,
/// -w^2, for accelerometers, else its height, 1.
double ReferencePerMetre(Sensor::Type type, double frequency_Hz);

/// Harmonics of every sensor at one frequency: sensors x (0, 1, 2, ...), y(t) = Re sum_h Y_h exp(i h w t).
using SensorHarmonics = Eigen::MatrixXcd;

/// Collects sensor harmonics into a frequency response with the definitions of the recordings: accelerometers relative
/// to the acceleration of the reference post, all others, gyros too, relative to its displacement; mean and second
/// harmonic absolute.
class ResponseRecorder {
 public:
  ResponseRecorder(const std::vector<Sensor>& sensors, const Excitation& excitation);

  /// `harmonics` has at least the columns 0, 1, 2; the reference post moves as Re(amplitude exp(i w t)).
  void Record(std::size_t frequency_index, const SensorHarmonics& harmonics);

  /// A derivative of the response instead, for these `changes` of the harmonics.
  void RecordChange(std::size_t frequency_index, const SensorHarmonics& harmonics, const SensorHarmonics& changes);

  FrequencyResponse Take() { return std::move(response_); }

 private:
  FrequencyResponse response_;
  std::vector<Sensor::Type> types_;
};

}  // namespace fourpost
