// Both balances against the march: a row per vehicle, pattern of the posts and amplitude, 40 frequencies from 0.5 to
// 30 Hz, the largest deviations of gain and phase over all channels that are not silent and all frequencies at which
// the balance converged; the others are counted.
//   acceptance_sweep VEHICLE:PATTERN[:N[:SCALE]]...     such as landrover110_model3:roll; N: every N-th frequency only;
//   SCALE: one of the amplitudes only, such as 2
#include <algorithm>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "tests/vehicles/acceptance.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/march.h"

namespace fourpost {
namespace {

/// Of the march; 1e-7 leaves some 0.005 dB at 3 mm and 0.5 Hz.
constexpr double kAccuracy = 1e-8;

Vehicle Read(const std::string& name) {
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / (name + ".urdf"), diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return std::move(vehicle).value();
}

void Print(const DeviationAt& deviation) {
  std::cout << ',' << deviation.value << ',' << deviation.channel << ',' << deviation.frequency_Hz;
}

/// Where a balance has no answer it says so, and the march answers in its place.
FrequencyResponse Answered(const PeriodicResponse& balance, const FrequencyResponse& marched) {
  FrequencyResponse answered = balance.response;
  for (std::size_t i = 0; i < answered.frequency_Hz.size(); ++i) {
    const std::vector<double>& none = balance.unconverged_Hz;
    if (std::find(none.begin(), none.end(), answered.frequency_Hz[i]) == none.end()) continue;
    for (std::size_t c = 0; c < answered.channels.size(); ++c)
      answered.channels[c].response[i] = marched.channels[c].response[i];
  }
  return answered;
}

/// `only`: one of the amplitudes; 0: all of them.
void Sweep(const std::string& name, const std::string& pattern, std::size_t every, double only) {
  const Vehicle vehicle = Read(name);
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = CondensedVehicle(vehicle).At(values);
  Multibody multibody(vehicle);
  multibody.SetParameters(values, model.preloads);
  for (const double scale : kAcceptedScales) {
    if (only > 0 && scale != only) continue;
    const Excitation excitation = AcceptanceSine(vehicle, pattern, scale, 0, every);
    const std::clock_t start = std::clock();
    // Samples alias the kinks of dampers; near a node that takes a quarter of what is accepted. So does a tolerance of
    // 1e-4, which counts from a tenth of the loudest sensor.
    const MarchedResponse marched =
        March(multibody, excitation, {.accuracy = kAccuracy, .tolerance = 2e-5, .samples_per_cycle = 128});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const PeriodicResponse linearised = SolveHarmonicBalance(model, vehicle.sensors, excitation);
    const PeriodicResponse full = SolveFullBalance(multibody, model, excitation);
    for (const PeriodicResponse* balance : {&full, &linearised}) {
      const EngineDeviation deviation = DeviationOf(Answered(*balance, marched.response), marched.response);
      std::cout << name << ',' << pattern << ',' << scale << ',' << (balance == &full ? "full" : "linearised") << ','
                << excitation.frequency_Hz.size() << ',' << deviation.channels;
      Print(deviation.gain_dB);
      Print(deviation.phase_deg);
      std::cout << ',' << balance->unconverged_Hz.size() << ',' << marched.unsteady.size() << ',' << seconds << ','
                << kAccuracy << std::endl;
    }
  }
}

}  // namespace
}  // namespace fourpost

int main(int count, char** arguments) {
  std::cout << "vehicle,pattern,scale,balance,frequencies,channels,gain_dB,gain_channel,gain_Hz,phase_deg,"
               "phase_channel,phase_Hz,unconverged,unsteady,march_cpu_s,march_accuracy"
            << std::endl;
  for (int i = 1; i < count; ++i) {
    std::istringstream argument(arguments[i]);
    std::string vehicle;
    std::string pattern;
    std::string every = "1";
    std::getline(std::getline(argument, vehicle, ':'), pattern, ':');
    std::getline(argument, every, ':');
    std::string scale;
    std::getline(argument, scale);
    fourpost::Sweep(vehicle, pattern, std::stoul(every.empty() ? "1" : every), scale.empty() ? 0 : std::stod(scale));
  }
}
