#include "vehicles/response/response_recorder.h"

#include <cmath>
#include <numbers>

namespace fourpost {

std::string UnitOf(Sensor::Type type) {
  switch (type) {
    case Sensor::Type::kAccelerometer: return "m/s^2";
    case Sensor::Type::kDisplacement:
    case Sensor::Type::kStrut: return "m";
    case Sensor::Type::kLoadCell: return "N";
    case Sensor::Type::kGyro: return "rad/s";
  }
  return "";
}

double ReferencePerMetre(Sensor::Type type, double frequency_Hz) {
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  return type == Sensor::Type::kAccelerometer ? -omega * omega : 1;
}

ResponseRecorder::ResponseRecorder(const std::vector<Sensor>& sensors, const Excitation& excitation) {
  response_.frequency_Hz = excitation.frequency_Hz;
  response_.amplitude_m = excitation.amplitude_m;
  const std::size_t points = excitation.frequency_Hz.size();
  for (const Sensor& sensor : sensors) {
    ChannelResponse channel;
    channel.name = sensor.name;
    channel.unit = UnitOf(sensor.type);
    channel.response.resize(points);
    channel.mean.resize(points);
    channel.second_harmonic.resize(points);
    response_.channels.push_back(std::move(channel));
    types_.push_back(sensor.type);
  }
}

void ResponseRecorder::Record(std::size_t frequency_index, const SensorHarmonics& harmonics) {
  const double amplitude = response_.amplitude_m[frequency_index];
  for (std::size_t i = 0; i < response_.channels.size(); ++i) {
    const Eigen::Index row = static_cast<Eigen::Index>(i);
    const double reference = ReferencePerMetre(types_[i], response_.frequency_Hz[frequency_index]) * amplitude;
    ChannelResponse& channel = response_.channels[i];
    channel.response[frequency_index] = harmonics(row, 1) / reference;
    channel.mean[frequency_index] = harmonics(row, 0).real();
    channel.second_harmonic[frequency_index] = std::sqrt(std::norm(harmonics(row, 2)));
  }
}

void ResponseRecorder::RecordChange(std::size_t frequency_index, const SensorHarmonics& harmonics,
                                    const SensorHarmonics& changes) {
  Record(frequency_index, changes);
  for (std::size_t i = 0; i < response_.channels.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double size = std::sqrt(std::norm(harmonics(row, 2)));
    response_.channels[i].second_harmonic[frequency_index] =
        size > 0 ? (std::conj(harmonics(row, 2)) * changes(row, 2)).real() / size : 0;
  }
}

}  // namespace fourpost
