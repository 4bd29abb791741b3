#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "analysis/decibel.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/text_table.h"
#include "identify/loaded_study.h"
#include "identify/modelled_response.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/march.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// The vehicle as its file has it, answering by any of the engines.
class Respondent {
 public:
  Respondent(const Vehicle& vehicle, Engine engine) : vehicle_(vehicle), engine_(engine) {
    const std::vector<double> values = vehicle.ParameterValues();
    const CondensedVehicle condensed(vehicle);
    model_ = condensed.At(values);
    if (engine == Engine::kLinearised) return;
    multibody_.emplace(vehicle);
    multibody_->SetParameters(values, model_.preloads);
  }

  FrequencyResponse Answer(const MeasuredRun& run) {
    switch (engine_) {
      case Engine::kLinearised:
        return Periodic(SolveHarmonicBalance(model_, vehicle_.sensors, run.excitation, kFitBalance), run);
      case Engine::kFull: return Periodic(SolveFullBalance(*multibody_, model_, run.excitation), run);
      case Engine::kMarch: return Marched(run);
    }
    throw std::logic_error("no such engine");
  }

 private:
  static FrequencyResponse Periodic(PeriodicResponse balanced, const MeasuredRun& run) {
    RequirePeriodic(balanced.unconverged_Hz, run);
    return std::move(balanced.response);
  }

  FrequencyResponse Marched(const MeasuredRun& run) {
    const std::string total = std::to_string(run.excitation.frequency_Hz.size());
    MarchedResponse marched = March(*multibody_, run.excitation, {}, [&](std::size_t done) {
      progress_.Show("march " + run.name + ": " + std::to_string(done) + " of " + total + " frequencies");
    });
    if (!marched.unsteady.empty())
      throw std::runtime_error("'" + run.name + "': " + UnsteadyMessage(vehicle_, run.excitation, marched.unsteady[0]));
    return std::move(marched.response);
  }

  static void RequirePeriodic(const std::vector<double>& failed_Hz, const MeasuredRun& run) {
    if (!failed_Hz.empty())
      throw std::runtime_error("no periodic motion was found at " + Rounded(failed_Hz[0], 4) + " Hz of '" + run.name +
                               "'");
  }

  const Vehicle& vehicle_;
  Engine engine_;
  CondensedModel model_;
  std::optional<Multibody> multibody_;
  ProgressLine progress_;
};

/// The full balance needs independent coordinates, and none but series springs behind dampers.
void RequireBalanceable(const Vehicle& vehicle) {
  Diagnostics faults;
  const auto refuse = [&](const auto& closures) {
    for (const auto& closure : closures)
      faults.Error(vehicle.file, closure.source_line, "--engine full takes no loop closures; use march, or linearised");
  };
  refuse(vehicle.rods);
  refuse(vehicle.balls);
  refuse(vehicle.welds);
  refuse(vehicle.hinges);
  for (const Damper& damper : vehicle.dampers)
    if (damper.hydraulic)
      faults.Error(vehicle.file, damper.source_line,
                   "--engine full takes no hydraulic damper; use march, or linearised");
  if (faults.HasErrors()) throw FaultyInput(faults);
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
  Tell(diagnostics);
  if (command.engine == Engine::kFull) RequireBalanceable(loaded->vehicle);
  const std::vector<MeasuredRun> runs =
      InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz);
  Respondent vehicle(loaded->vehicle, command.engine);
  std::vector<FrequencyResponse> modelled;
  for (const MeasuredRun& run : runs) modelled.push_back(vehicle.Answer(run));
  const std::vector<ChannelMisfit> misfits = Misfits(runs, modelled);
  Print(command.json ? AsJson(runs, modelled, misfits) : MisfitTable(misfits));
  return kGood;
}

}  // namespace fourpost
