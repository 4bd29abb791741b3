// What live_calls.h answers in the native program, for comparison with WebAssembly: `live_answers FILE...` prints a
// line of JSON for each vehicle file that can be condensed.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/text/base64.h"
#include "analysis/text/diagnostics.h"
#include "identify/live/live_calls.h"
#include "vehicles/condensed/condense.h"
#include "vehicles/condensed/reduced_bytes.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride_metrics/ride_bytes.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

void Put(const std::vector<double>& numbers) {
  std::memcpy(live_room(numbers.size() * sizeof(double)), numbers.data(), numbers.size() * sizeof(double));
}

Json Answer(std::size_t count) {
  Json list = Json::array();
  for (const double* at = live_answer(); count > 0; ++at, --count)
    list.push_back(std::isfinite(*at) ? Json(*at) : Json());
  return list;
}

/// The file's values, changed by a fifth at most within their bounds.
std::vector<double> Drawn(const std::vector<Parameter>& parameters, std::mt19937_64& random) {
  std::uniform_real_distribution<double> factor(0.8, 1.2);
  std::vector<double> values;
  for (const Parameter& parameter : parameters) {
    const double drawn = factor(random) * parameter.value;
    values.push_back(parameter.lower < parameter.upper ? std::clamp(drawn, parameter.lower, parameter.upper)
                                                       : parameter.value);
  }
  return values;
}

/// The vehicle's ride over each road; a reason where there is none.
Json RidesOver(const std::vector<std::vector<double>>& roads, const RideInstruments& instruments) {
  Json rides = Json::array();
  for (const std::vector<double>& road : roads) {
    Put(road);
    const int frequencies = live_ride();
    const std::size_t points = instruments.points.size();
    const std::size_t numbers = 3 + points + 2 * instruments.loads.size() + instruments.dampers.size();
    const std::size_t spectra = static_cast<std::size_t>(std::max(frequencies, 0)) * (1 + points);
    rides.push_back({{"road", road},
                     {"frequencies", frequencies},
                     {"fault", live_fault()},
                     {"numbers", frequencies < 0 ? Json() : Answer(numbers + spectra)}});
  }
  return rides;
}

Json AnswersAt(const std::vector<double>& values, const ReducedData& data, const RideInstruments& instruments) {
  Put(values);
  const int is_hysteretic = live_set(values.size());
  std::vector<double> shares;
  for (std::size_t i = 0; i < data.posts.size(); ++i) shares.push_back(i % 2 == 0 ? 1 : 0.7);
  std::vector<double> frequencies;
  std::vector<double> amplitudes;
  for (double frequency = 0.5; frequency < 30; frequency *= 1.11) {
    frequencies.push_back(frequency);
    amplitudes.push_back(0.008 * std::min(1.0, 1.5 / frequency));
  }
  std::vector<double> given = shares;
  given.insert(given.end(), frequencies.begin(), frequencies.end());
  given.insert(given.end(), amplitudes.begin(), amplitudes.end());
  Put(given);
  const int channels = live_response(shares.size(), frequencies.size());
  const Json response = Answer(3 * frequencies.size() * static_cast<std::size_t>(std::max(channels, 0)));
  const Json rides = RidesOver({{256e-6, 60 / 3.6, 0.5, 30}, {64e-6, 30, 0.5, 30}}, instruments);
  const int modes = live_modes();
  const auto size = static_cast<std::size_t>(5 + 2 * data.coordinates);
  return {{"values", values},         {"hysteretic", is_hysteretic},
          {"shares", shares},         {"frequencies", frequencies},
          {"amplitudes", amplitudes}, {"channels", channels},
          {"response", response},     {"rides", rides},
          {"modes", modes},           {"mode_numbers", Answer(size * static_cast<std::size_t>(modes))}};
}

std::optional<RideInstruments> InstrumentsOf(const std::string& file) {
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle = ReadVehicle(file, diagnostics);
  if (!vehicle || vehicle->posts.empty()) return std::nullopt;
  try {
    RideInstruments instruments = InstrumentRide(*vehicle);
    Condense(instruments.vehicle);
    return instruments;
  } catch (const FaultyInput&) {
    return std::nullopt;
  }
}

void Print(const std::string& file) {
  const std::optional<RideInstruments> instruments = InstrumentsOf(file);
  if (!instruments) return;
  const ReducedData data = Condense(instruments->vehicle).data();
  const std::string vehicle = BytesOf(data);
  const std::string ride = BytesOf(*instruments);
  const std::string bytes = vehicle + ride;
  std::memcpy(live_room(bytes.size()), bytes.data(), bytes.size());
  if (live_open(vehicle.size(), ride.size()) < 0) throw std::runtime_error(live_fault());
  std::mt19937_64 random(1);
  Json draws = Json::array();
  for (int i = 0; i < 3; ++i) draws.push_back(AnswersAt(Drawn(data.parameters, random), data, *instruments));
  std::cout << Json({{"file", file},
                     {"coordinates", data.coordinates},
                     {"vehicle", Base64(vehicle)},
                     {"instruments", Base64(ride)},
                     {"points", instruments->points.size()},
                     {"tyres", instruments->loads.size()},
                     {"dampers", instruments->dampers.size()},
                     {"draws", draws}})
            << '\n';
}

}  // namespace
}  // namespace fourpost

int main(int count, char** files) {
  for (int i = 1; i < count; ++i) fourpost::Print(files[i]);
}
