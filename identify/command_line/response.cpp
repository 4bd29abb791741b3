#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/decibel.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/progress_line.h"
#include "identify/loaded_study.h"
#include "identify/modelled_response.h"
#include "vehicles/full_balance.h"
#include "vehicles/march.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// The responses of the full multibody system.
class FullSystem {
 public:
  explicit FullSystem(const LoadedStudy& loaded) : multibody_(loaded.vehicle) {
    const std::vector<double> values = loaded.vehicle.ParameterValues();
    model_ = CondensedVehicle(loaded.vehicle).At(values);
    multibody_.SetParameters(values, model_.preloads);
  }

  std::vector<FrequencyResponse> Responses(const std::vector<MeasuredRun>& runs, Engine engine) {
    std::vector<FrequencyResponse> responses;
    for (const MeasuredRun& run : runs) responses.push_back(engine == Engine::kFull ? Balance(run) : Marched(run));
    return responses;
  }

 private:
  FrequencyResponse Balance(const MeasuredRun& run) {
    PeriodicResponse balanced = SolveFullBalance(multibody_, model_, run.excitation);
    RequirePeriodic(balanced.unconverged_Hz, run);
    return std::move(balanced.response);
  }

  FrequencyResponse Marched(const MeasuredRun& run) {
    const std::string total = std::to_string(run.excitation.frequency_Hz.size());
    MarchedResponse marched = March(multibody_, run.excitation, {}, [&](std::size_t done) {
      progress_.Show("march " + run.name + ": " + std::to_string(done) + " of " + total + " frequencies");
    });
    RequirePeriodic(marched.unsteady_Hz, run);
    return std::move(marched.response);
  }

  static void RequirePeriodic(const std::vector<double>& failed_Hz, const MeasuredRun& run) {
    if (!failed_Hz.empty())
      throw std::runtime_error("no periodic motion was found at " + std::to_string(failed_Hz[0]) + " Hz of '" +
                               run.name + "'");
  }

  Multibody multibody_;
  CondensedModel model_;
  ProgressLine progress_;
};

std::vector<FrequencyResponse> Responses(const LoadedStudy& loaded, const std::vector<MeasuredRun>& runs,
                                         Engine engine) {
  if (engine != Engine::kLinearised) return FullSystem(loaded).Responses(runs, engine);
  const CondensedModel model = CondensedVehicle(loaded.vehicle).At(loaded.vehicle.ParameterValues());
  return ModelledResponses(model, loaded.vehicle.sensors, runs);
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
  const std::vector<MeasuredRun> runs =
      InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz);
  const std::vector<FrequencyResponse> modelled = Responses(*loaded, runs, command.engine);
  const std::vector<ChannelMisfit> misfits = Misfits(runs, modelled);
  std::fputs((command.json ? AsJson(runs, modelled, misfits) : MisfitTable(misfits)).c_str(), stdout);
  return kGood;
}

}  // namespace fourpost
