#include "identify/live/live_calls.h"

#include <exception>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "identify/live/live_vehicle.h"

namespace {

using namespace fourpost;

struct Instance {
  std::vector<double> room;
  std::vector<double> answer;
  std::string fault;
  std::optional<LiveVehicle> vehicle;
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

}  // namespace

extern "C" {

void* live_room(std::size_t bytes) {
  Here().room.assign((bytes + sizeof(double) - 1) / sizeof(double), 0);
  return Here().room.data();
}

const double* live_answer() { return Here().answer.data(); }

const char* live_fault() { return Here().fault.c_str(); }

int live_open(std::size_t bytes) {
  return Guarded([&](Instance& here) {
    here.vehicle.emplace(std::string_view(reinterpret_cast<const char*>(here.room.data()), bytes));
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
}
