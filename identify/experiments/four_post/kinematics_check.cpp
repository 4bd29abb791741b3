#include "identify/experiments/four_post/kinematics_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "identify/experiments/four_post/modelled_response.h"

namespace fourpost {
namespace {

/// Places in the run's frequencies.
std::set<std::size_t> PlacesToCompare(const MeasuredRun& run) {
  const std::vector<double>& amplitude = run.excitation.amplitude_m;
  std::set<std::size_t> places = {
      0, amplitude.size() - 1,
      static_cast<std::size_t>(std::max_element(amplitude.begin(), amplitude.end()) - amplitude.begin())};
  struct Peak {
    double gain = 0;
    std::size_t place = 0;
  };
  std::map<std::string, Peak> peaks;
  for (const MeasuredChannel& channel : run.channels)
    for (std::size_t i = 0; i < channel.response.size(); ++i)
      if (const double gain = std::abs(channel.response[i]); gain > peaks[channel.unit].gain)
        peaks[channel.unit] = {gain, i};
  for (const auto& [unit, peak] : peaks) places.insert(peak.place);
  return places;
}

RunKinematics CheckOne(const MeasuredRun& run, Vehicle vehicle) {
  std::vector<Sensor> measured;
  for (const MeasuredChannel& channel : run.channels) measured.push_back(vehicle.sensors[channel.sensor]);
  vehicle.sensors = std::move(measured);
  Excitation excitation{.shape = run.excitation.shape};
  for (const std::size_t i : PlacesToCompare(run)) {
    excitation.frequency_Hz.push_back(run.excitation.frequency_Hz[i]);
    excitation.amplitude_m.push_back(run.excitation.amplitude_m[i]);
  }
  RunKinematics out{.recording = run.name, .frequency_Hz = excitation.frequency_Hz};
  try {
    const SteadyResponse answer = SteadySolver(vehicle).Check(excitation, kFitBalance);
    out.error = answer.kinematics_error;
    out.not_estimated = answer.not_estimated;
  } catch (const std::runtime_error& fault) {
    out.not_estimated = fault.what();
  }
  return out;
}

}  // namespace

std::vector<RunKinematics> CheckKinematics(const std::vector<MeasuredRun>& runs, const Vehicle& vehicle,
                                           const std::vector<double>& values) {
  Vehicle fitted = vehicle;
  for (std::size_t i = 0; i < values.size(); ++i) fitted.parameters[i].value = values[i];
  std::vector<RunKinematics> checked;
  for (const MeasuredRun& run : runs)
    if (!run.channels.empty() && !run.excitation.frequency_Hz.empty()) checked.push_back(CheckOne(run, fitted));
  return checked;
}

}  // namespace fourpost
