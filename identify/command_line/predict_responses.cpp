#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/frequency_response_file.h"
#include "analysis/output_folder.h"
#include "identify/command_line/engine_text.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/measured_channels.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/predictions.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/solve_sweep.h"
#include "identify/four_post_data.h"
#include "identify/json_text.h"
#include "identify/lint/recording_lint.h"
#include "identify/lint/tyre_pull_lint.h"
#include "identify/misfit.h"
#include "identify/modelled_response.h"
#include "identify/post_shape.h"
#include "identify/response_chart.h"
#include "identify/sweep_files.h"
#include "identify/versions.h"
#include "identify/warning_texts.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> ChannelsIn(const std::filesystem::path& recording) {
  Diagnostics diagnostics;
  const std::optional<FrequencyResponse> measured = ReadFrequencyResponse(recording, diagnostics);
  if (!measured) throw FaultyInput(diagnostics);
  std::vector<std::string> names;
  for (const ChannelResponse& channel : measured->channels) names.push_back(channel.name);
  return names;
}

/// The recording in place of those fitted; its posts are told later.
MeasuredRun LoadRun(const PredictCommand& command, const FittedRun& model) {
  Study study = model.study;
  KeepMeasured(command.recording, ChannelsIn(command.recording), study.channels);
  study.file = command.run / "study.yaml";
  study.static_loads_file.reset();
  StudyRecording recording = study.recordings.front();
  recording.file = command.recording;
  recording.name = command.recording.stem().string();
  study.recordings = {recording};
  Diagnostics diagnostics;
  const std::optional<FourPostData> data = LoadFourPostData(study, model.vehicle, diagnostics);
  if (!data) throw FaultyInput(diagnostics);
  return data->runs.front();
}

/// Sum over the channels, each at most 1: a strut that friction holds at low frequencies says nothing of the pattern.
double SquaredMisfit(const MeasuredRun& run, const FrequencyResponse& modelled) {
  double square = 0;
  for (const MeasuredChannel& channel : run.channels) {
    double error = 0;
    double measured = 0;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      error += std::norm(modelled.channels[channel.sensor].response[i] - channel.response[i]);
      measured += std::norm(channel.response[i]);
    }
    square += measured > 0 ? std::min(1.0, error / measured) : 0;
  }
  return square;
}

FrequencyResponse Respond(const FittedRun& model, const CondensedModel& condensed, const MeasuredRun& run) {
  return ModelledResponses(condensed, model.vehicle.sensors, {run}).front();
}

/// Nothing where it was interrupted.
std::optional<SteadyResponse> Answer(const PredictCommand& command, const FittedRun& model, const MeasuredRun& run) {
  CatchInterrupts();
  ProgressLine progress;
  SteadySolver solver(model.vehicle);
  std::optional<SteadyResponse> answer =
      SolveSweep(solver, run.name, run.excitation, command.engine.value_or(Engine::kAuto), kFitBalance, progress);
  if (answer && !answer->unanswered.empty()) {
    if (Interrupted()) return std::nullopt;
    throw SimulationError("'" + run.name + "': " + answer->unanswered.front().why);
  }
  return answer;
}

/// The pattern whose responses are nearest, and the posts of `run` set to it. At the lowest frequencies a car follows
/// its posts, whatever its parameters are.
std::string GuessPattern(const FittedRun& model, const CondensedModel& condensed, MeasuredRun& run) {
  constexpr std::size_t kFrequencies = 8;
  const std::vector<double>& all = run.excitation.frequency_Hz;
  const double last = all[std::min(kFrequencies, all.size()) - 1];
  MeasuredRun low = InBand({run}, all.front(), last).front();
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::string_view pattern : kPostPatterns) {
    try {
      low.excitation.shape = PostPattern(model.vehicle, std::string(pattern));
    } catch (const std::invalid_argument&) {
      continue;  // Posts in a line make no roll.
    }
    const double misfit = SquaredMisfit(low, Respond(model, condensed, low));
    if (!(misfit < least)) continue;
    least = misfit;
    best = pattern;
  }
  // Of a pattern that is right, a car misses some per cent.
  constexpr double kNoFit = 0.5;
  if (!(least < kNoFit * static_cast<double>(run.channels.size()))) {
    Diagnostics faults;
    faults.Error(run.name, 0,
                 "no pattern that the posts of " + model.vehicle.name +
                     " can make is like this recording at its lowest frequencies: tell --mode, or check that the "
                     "vehicle can move so");
    throw FaultyInput(faults);
  }
  run.excitation.shape = PostPattern(model.vehicle, best);
  std::fprintf(stderr, "posts: %s, which fits best up to %.3g Hz; --mode tells another\n", best.c_str(), last);
  return best;
}

std::string SetPosts(const PredictCommand& command, const FittedRun& model, const CondensedModel& condensed,
                     MeasuredRun& run) {
  if (command.mode.empty()) return GuessPattern(model, condensed, run);
  Diagnostics diagnostics;
  run.excitation.shape = ReadPostShape(command.mode, model.vehicle, diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return command.mode;
}

/// What the recording can hardly be so of, which is told.
std::vector<std::string> TellLints(const FittedRun& model, const CondensedModel& condensed, const MeasuredRun& whole) {
  Diagnostics findings;
  LintRuns({model.study, model.vehicle, condensed}, {whole}, findings);
  LintTyrePulls(model.vehicle, model.vehicle.ParameterValues(),
                InBand({whole}, model.study.band_lower_Hz, model.study.band_upper_Hz), findings);
  Tell(findings);
  return WarningTexts(findings);
}

/// Frequencies of the band in the place of those of the whole recording.
void PutInBand(const FrequencyResponse& band, FrequencyResponse& whole) {
  const auto first = std::find(whole.frequency_Hz.begin(), whole.frequency_Hz.end(), band.frequency_Hz.front());
  const std::ptrdiff_t at = first - whole.frequency_Hz.begin();
  for (std::size_t c = 0; c < whole.channels.size(); ++c) {
    const ChannelResponse& from = band.channels[c];
    ChannelResponse& to = whole.channels[c];
    std::copy(from.response.begin(), from.response.end(), to.response.begin() + at);
    std::copy(from.mean.begin(), from.mean.end(), to.mean.begin() + at);
    std::copy(from.second_harmonic.begin(), from.second_harmonic.end(), to.second_harmonic.begin() + at);
  }
}

std::string AsJson(const PredictCommand& command, const FittedRun& model, const std::string& mode,
                   const SteadyResponse& answer, const std::vector<ChannelMisfit>& misfits,
                   const std::vector<std::string>& warnings) {
  Json channels = Json::array();
  for (const ChannelMisfit& misfit : misfits)
    channels.push_back({{"name", misfit.name},
                        {"rms_dB", misfit.rms_dB},
                        {"rms_deg", misfit.rms_deg},
                        {"nmse_percent", misfit.nmse_percent},
                        {"vaf_percent", 100 - misfit.nmse_percent}});
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  Json json = {{"vehicle", model.vehicle.name},
               {"recording", command.recording.filename().string()},
               {"was_fitted", model.has_seen}};
  if (model.load) json["added_load"] = AddedLoadJson(*model.load);
  json.update({{"posts", mode},
               {"band_Hz", {model.study.band_lower_Hz, model.study.band_upper_Hz}},
               {"engine", EngineName(answer.engine)},
               {"linear_kinematics_error", KinematicsJson(answer.kinematics_error, answer.not_estimated)},
               {"channels", channels},
               {"warnings", warnings},
               {"versions", versions}});
  return JsonText(json);
}

}  // namespace

int PredictResponses(const PredictCommand& command, const FittedRun& model) {
  MeasuredRun whole = LoadRun(command, model);
  const double lower = model.study.band_lower_Hz;
  const double upper = model.study.band_upper_Hz;
  if (InBand({whole}, lower, upper).front().excitation.frequency_Hz.empty()) {
    Diagnostics faults;
    faults.Error(command.recording.string(), 0, "has no frequency within the band of the study that was fitted");
    throw FaultyInput(faults);
  }
  const CondensedModel condensed = CondensedVehicle(model.vehicle).At(model.vehicle.ParameterValues());
  const std::string mode = SetPosts(command, model, condensed, whole);
  const std::vector<std::string> warnings = TellLints(model, condensed, whole);
  const std::vector<MeasuredRun> in_band = InBand({whole}, lower, upper);
  const std::optional<SteadyResponse> answer = Answer(command, model, in_band.front());
  if (!answer) return kInterrupted;
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(in_band, {answer->response});
  const std::string json = AsJson(command, model, mode, *answer, misfits, warnings);
  if (!command.output.empty()) {
    std::vector<FrequencyResponse> modelled = {Respond(model, condensed, whole)};
    PutInBand(answer->response, modelled.front());
    OutputFolder output(command.output);
    output.Add("response.csv", ResponseCsv({whole}, modelled, lower, upper));
    output.Add("response.svg", ResponseSvg({whole}, modelled, misfits, lower, upper));
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  }
  Print(command.json ? json : LoadText(model) + MisfitTable(misfits, {}) + EngineText(whole.name, *answer));
  return kGood;
}

}  // namespace fourpost
