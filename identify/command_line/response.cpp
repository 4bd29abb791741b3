#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/decibel.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/progress_line.h"
#include "identify/loaded_study.h"
#include "identify/modelled_response.h"
#include "vehicles/march.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

FrequencyResponse MarchRun(Multibody& multibody, const MeasuredRun& run, ProgressLine& progress) {
  const std::string total = std::to_string(run.excitation.frequency_Hz.size());
  const MarchedResponse marched = March(multibody, run.excitation, {}, [&](std::size_t done) {
    progress.Show("march " + run.name + ": " + std::to_string(done) + " of " + total + " frequencies");
  });
  if (!marched.unsteady_Hz.empty())
    throw std::runtime_error("the motion does not become periodic at " + std::to_string(marched.unsteady_Hz[0]) +
                             " Hz of '" + run.name + "'");
  return marched.response;
}

std::vector<FrequencyResponse> MarchRuns(const LoadedStudy& loaded, const CondensedVehicle& condensed,
                                         const std::vector<MeasuredRun>& runs) {
  Multibody multibody(loaded.vehicle);
  const std::vector<double> values = loaded.vehicle.ParameterValues();
  multibody.SetParameters(values, condensed.PreloadsAt(values));
  ProgressLine progress;
  std::vector<FrequencyResponse> responses;
  for (const MeasuredRun& run : runs) responses.push_back(MarchRun(multibody, run, progress));
  return responses;
}

Json Channel(const ChannelResponse& channel) {
  Json gain = Json::array();
  Json phase = Json::array();
  for (const std::complex<double>& value : channel.response) {
    gain.push_back(std::abs(value));
    phase.push_back(DegreesFromRadians(std::arg(value)));
  }
  return {{"name", channel.name}, {"unit", channel.unit}, {"gain", gain},
          {"phase_deg", phase},   {"mean", channel.mean}, {"second_harmonic", channel.second_harmonic}};
}

std::string AsJson(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                   const std::vector<ChannelMisfit>& misfits) {
  Json recordings = Json::array();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Json channels = Json::array();
    for (const ChannelResponse& channel : modelled[r].channels) channels.push_back(Channel(channel));
    recordings.push_back({{"name", runs[r].name},
                          {"frequency_Hz", modelled[r].frequency_Hz},
                          {"post_amplitude_m", modelled[r].amplitude_m},
                          {"channels", channels}});
  }
  Json channels = Json::array();
  for (const ChannelMisfit& misfit : misfits)
    channels.push_back({{"name", misfit.name}, {"rms_dB", misfit.rms_dB}, {"rms_deg", misfit.rms_deg}});
  return Json{{"recordings", recordings}, {"channels", channels}}.dump(2) + '\n';
}

}  // namespace

int Run(const ResponseCommand& command) {
  Diagnostics diagnostics;
  const std::optional<LoadedStudy> loaded = LoadStudy(command.study, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  const CondensedVehicle condensed(loaded->vehicle);
  const std::vector<MeasuredRun> runs =
      InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz);
  const std::vector<FrequencyResponse> modelled =
      command.march ? MarchRuns(*loaded, condensed, runs)
                    : ModelledResponses(condensed.At(loaded->vehicle.ParameterValues()), loaded->vehicle.sensors, runs);
  const std::vector<ChannelMisfit> misfits = Misfits(runs, modelled);
  std::fputs((command.json ? AsJson(runs, modelled, misfits) : MisfitTable(misfits)).c_str(), stdout);
  return kGood;
}

}  // namespace fourpost
