#include "identify/live/live_calls.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "identify/live/live_ride.h"
#include "identify/live/live_vehicle.h"
#include "vehicles/condensed/reduced_bytes.h"
#include "vehicles/ride_metrics/ride_bytes.h"

namespace {

using namespace fourpost;

struct Instance {
  std::vector<double> room;
  std::vector<double> answer;
  std::string fault;
  std::optional<LiveVehicle> vehicle;
  std::optional<LiveRide> ride;
};

Instance& Here() {
  static Instance instance;
  return instance;
}

/// `call` returns the answer's count, or fails.
template <typename Call>
int Guarded(const Call& call) {
  Instance& here = Here();
  here.answer.clear();
  here.fault.clear();
  try {
    return static_cast<int>(call(here));
  } catch (const std::exception& error) {
    here.fault = error.what();
  }
  return -1;
}

/// Of the vehicle as its file has it.
ReducedData WithoutInstruments(ReducedData data, std::size_t file_sensors) {
  data.sensors.resize(file_sensors);
  const auto rows = static_cast<Eigen::Index>(file_sensors);
  for (Eigen::MatrixXd* reading : {&data.on_position, &data.on_velocity, &data.on_acceleration})
    reading->conservativeResize(rows, Eigen::NoChange);
  return data;
}

void Open(std::string_view vehicle, std::string_view ride, Instance& here) {
  ReducedData data = ReducedDataOf(vehicle);
  std::optional<LiveRide> opened;
  if (!ride.empty()) {
    opened.emplace(data, RideInstrumentsOf(ride));
    data = WithoutInstruments(std::move(data), opened->instruments().file_sensors);
  }
  here.vehicle.emplace(std::move(data));
  here.ride = std::move(opened);
}

void WriteRide(const RoadRide& ride, std::vector<double>& answer) {
  double contact = 0;
  for (const RideMetrics::Stop& stop : ride.metrics.stops) contact = std::max(contact, stop.contact);
  answer = {ride.converged ? 1.0 : 0.0, ride.grid_change, contact};
  for (const RideMetrics::Comfort& comfort : ride.metrics.comfort) answer.push_back(comfort.weighted.rms);
  for (const RideMetrics::Wheel& wheel : ride.metrics.wheels)
    answer.insert(answer.end(), {wheel.Variation(), wheel.off_ground});
  for (const RideMetrics::Strut& strut : ride.metrics.struts) answer.push_back(strut.travel_rms_m);
  const std::vector<double>& frequencies = ride.spectra.frequency_Hz;
  answer.insert(answer.end(), frequencies.begin(), frequencies.end());
  for (std::size_t i = 0; i < ride.metrics.comfort.size(); ++i) {
    const std::vector<double> density = WeightedDensity(ride.spectra, i, ride.metrics.comfort[i].weighting);
    answer.insert(answer.end(), density.begin(), density.end());
  }
}

}  // namespace

extern "C" {

void* live_room(std::size_t bytes) {
  Here().room.assign((bytes + sizeof(double) - 1) / sizeof(double), 0);
  return Here().room.data();
}

const double* live_answer() { return Here().answer.data(); }

const char* live_fault() { return Here().fault.c_str(); }

int live_open(std::size_t vehicle_bytes, std::size_t ride_bytes) {
  return Guarded([&](Instance& here) {
    const std::string_view all(reinterpret_cast<const char*>(here.room.data()), vehicle_bytes + ride_bytes);
    Open(all.substr(0, vehicle_bytes), all.substr(vehicle_bytes), here);
    return here.vehicle->data().parameters.size();
  });
}

int live_set(std::size_t count) {
  return Guarded([&](Instance& here) {
    here.vehicle.value().Set(std::span(here.room).first(count));
    return here.vehicle->IsHysteretic();
  });
}

int live_response(std::size_t posts, std::size_t frequencies) {
  return Guarded([&](Instance& here) {
    const auto shape = here.room.begin();
    const auto frequency = shape + static_cast<std::ptrdiff_t>(posts);
    const auto amplitude = frequency + static_cast<std::ptrdiff_t>(frequencies);
    const FrequencyResponse response = here.vehicle.value().Response({.frequency_Hz = {frequency, amplitude},
                                                                      .amplitude_m = {amplitude, here.room.end()},
                                                                      .shape = {shape, frequency}});
    for (const ChannelResponse& channel : response.channels) {
      for (const std::complex<double>& value : channel.response) here.answer.push_back(value.real());
      for (const std::complex<double>& value : channel.response) here.answer.push_back(value.imag());
      here.answer.insert(here.answer.end(), channel.mean.begin(), channel.mean.end());
    }
    return response.channels.size();
  });
}

int live_modes() {
  return Guarded([](Instance& here) {
    const std::vector<Mode> modes = here.vehicle.value().Modes();
    for (const Mode& mode : modes) {
      here.answer.insert(here.answer.end(), {static_cast<double>(mode.kind), mode.frequency_Hz, mode.damping_ratio,
                                             mode.pole.real(), mode.pole.imag()});
      for (const std::complex<double>& part : mode.shape)
        here.answer.insert(here.answer.end(), {part.real(), part.imag()});
    }
    return modes.size();
  });
}

int live_ride() {
  return Guarded([](Instance& here) {
    const std::vector<double>& road = here.room;
    const RoadRide ride = here.ride.value().Over(
        here.vehicle.value().values(),
        {.roughness_m3 = road.at(0), .speed = road.at(1), .lower_Hz = road.at(2), .upper_Hz = road.at(3)});
    WriteRide(ride, here.answer);
    return ride.spectra.frequency_Hz.size();
  });
}
}
