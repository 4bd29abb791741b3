#include "identify/experiments/four_post/four_post.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>

#include "analysis/files/json_text.h"
#include "analysis/files/recording_layout.h"
#include "analysis/signals/decibel.h"
#include "analysis/text/number.h"
#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/experiments/audited_vehicle.h"
#include "identify/experiments/four_post/covered_sines.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/four_post_residuals.h"
#include "identify/experiments/four_post/kinematics_check.h"
#include "identify/experiments/four_post/lacking_force.h"
#include "identify/experiments/four_post/misfit_lint.h"
#include "identify/experiments/four_post/misfit_table.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/recording_lint.h"
#include "identify/experiments/four_post/response_bands.h"
#include "identify/experiments/four_post/response_chart.h"
#include "identify/experiments/four_post/response_discrepancy.h"
#include "identify/experiments/four_post/response_misfit.h"
#include "identify/experiments/four_post/response_misfit_json.h"
#include "identify/experiments/four_post/study_recording.h"
#include "identify/experiments/four_post/tyre_pull_lint.h"
#include "identify/experiments/four_post/unit_of_sines_lint.h"
#include "identify/experiments/four_post/wheelpan_lint.h"
#include "identify/fit/fit.h"
#include "identify/missing_force/missing_force.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/requests/sweep_files.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

void CheckBand(const FourPostPlan& plan, const std::vector<MeasuredRun>& runs, Diagnostics& diagnostics) {
  for (const MeasuredRun& run : InBand(runs, plan.band_lower_Hz, plan.band_upper_Hz))
    if (run.excitation.frequency_Hz.empty())
      diagnostics.Report(kBandWithoutFrequency, {plan.file, plan.band_line}, {run.name});
}

void Add(Sha256& digest, const MeasuredChannel& channel) {
  digest.Add(static_cast<double>(channel.sensor));
  for (const std::complex<double>& response : channel.response) {
    digest.Add(response.real());
    digest.Add(response.imag());
  }
  digest.Add(channel.radial_sd);
  digest.Add(channel.tangential_sd);
  digest.Add(channel.mean);
  if (!channel.mean_sd.empty()) digest.Add(channel.mean_sd);
  digest.Add(channel.second_harmonic);
}

Json RecordingsJson(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                    const std::vector<ChannelMisfit>& misfits) {
  Json list = Json::array();
  for (std::size_t r = 0; r < misfits.size(); ++r) {
    Json posts = Json::object();
    for (std::size_t p = 0; p < vehicle.posts.size(); ++p) posts[vehicle.posts[p].name] = runs[r].excitation.shape[p];
    Json entry = {{"name", runs[r].name}, {"posts", posts}};
    entry.update(ErrorsJson(misfits[r]));
    if (!runs[r].preparations.empty()) entry["preparation"] = runs[r].preparations;
    list.push_back(std::move(entry));
  }
  return list;
}

/// The error of the fit's linear kinematics; a warning where it is not small compared with the stated model error.
void AddKinematics(const FourPostPlan& plan, const std::vector<MeasuredRun>& runs, const Vehicle& vehicle,
                   const std::vector<double>& values, ExperimentResults& results) {
  constexpr double kMuch = 0.5;
  const ModelError& allowed = plan.model_error;
  for (const RunKinematics& run : CheckKinematics(runs, vehicle, values)) {
    results.json["responses"].push_back({{"recording", run.recording},
                                         {"engine", EngineName(Engine::kReduced)},
                                         {"compared_at_Hz", run.frequency_Hz},
                                         {"linear_kinematics_error", KinematicsJson(run.error, run.not_estimated)}});
    if (!run.error) {
      results.text +=
          run.recording + ": the error of linear kinematics could not be estimated: " + run.not_estimated + '\n';
      continue;
    }
    results.text += run.recording + ": " + KinematicsText(*run.error) + '\n';
    if (run.error->IsVisible() && (run.error->gain_dB.value > kMuch * allowed.gain_dB ||
                                   run.error->phase_deg.value > kMuch * DegreesFromRadians(allowed.phase_rad)))
      results.findings.Report(kSineKinematicsVisible, {plan.file},
                              {run.recording, KinematicsText(*run.error), Rounded(allowed.gain_dB, 2),
                               Rounded(DegreesFromRadians(allowed.phase_rad), 2)});
  }
  results.text += '\n';
}

/// A misfit needs an answer at every frequency; nothing when interrupted before.
std::optional<SteadyResponse> WholeAnswer(const MeasuredRun& run, SteadySolver& solver, Engine engine,
                                          const WorkHooks& hooks) {
  std::optional<SteadyResponse> answer = SolveSweep(solver, run.name, run.excitation, engine, kFitBalance, hooks);
  if (!answer) return std::nullopt;
  if (answer->unanswered.empty()) return answer;
  if (hooks.IsStopped()) return std::nullopt;
  const Unanswered& first = answer->unanswered.front();
  throw SimulationError(kResponseUnanswered, {run.name, Rounded(first.frequency_Hz, 3), WithoutId(first.why)});
}

Json AnswerJson(const MeasuredRun& run, const SteadyResponse& answer) {
  Json channels = Json::array();
  for (const ChannelResponse& channel : answer.response.channels) channels.push_back(ChannelJson(channel));
  Json engines = Json::array();
  for (const Engine engine : answer.engine_at) engines.push_back(EngineName(engine));
  return {{"name", run.name},
          {"engine", EngineName(answer.engine)},
          {"linear_kinematics_error", KinematicsJson(answer.kinematics_error, answer.not_estimated)},
          {"frequency_Hz", answer.response.frequency_Hz},
          {"post_amplitude_m", answer.response.amplitude_m},
          {"engine_at", engines},
          {"channels", channels}};
}

/// What the fitted vehicle makes of recordings that the fit has not seen.
void AddValidation(const std::vector<MeasuredRun>& unseen, const Vehicle& vehicle, const CondensedModel& model,
                   ExperimentResults& results) {
  if (unseen.empty()) return;
  const std::vector<FrequencyResponse> predicted = ModelledResponses(model, vehicle.sensors, unseen);
  Json& list = results.json["validation"] = Json::array();
  for (std::size_t r = 0; r < unseen.size(); ++r)
    for (const ChannelMisfit& misfit : ResponseMisfits({unseen[r]}, {predicted[r]})) {
      Json entry = {{"recording", unseen[r].name}, {"name", misfit.name}};
      entry.update(ErrorsJson(misfit));
      entry["vaf_percent"] = NumberOrNull(100 - misfit.nmse_percent);
      list.push_back(std::move(entry));
    }
  results.unseen_text +=
      "Not fitted:\n" + MisfitTable(ResponseMisfits(unseen, predicted), RecordingMisfits(unseen, predicted)) + '\n';
}

/// One per run; none where a fit has no deviations.
std::vector<ResponseBands> BandsOf(const Subject& subject, const std::vector<MeasuredRun>& runs,
                                   const std::vector<FrequencyResponse>& modelled,
                                   const std::optional<ParameterSpread>& spread,
                                   const std::vector<OctaveDiscrepancy>& discrepancies, int threads) {
  if (!spread || discrepancies.empty()) return {};
  std::vector<ResponseBands> bands;
  for (std::size_t r = 0; r < runs.size(); ++r)
    bands.push_back(BandsOfResponse(subject, runs[r], modelled[r], *spread, discrepancies, threads));
  return bands;
}

}  // namespace

std::vector<MeasuredRun> FourPost::RunsInBand() const { return InBand(runs, plan.band_lower_Hz, plan.band_upper_Hz); }

std::vector<ExperimentFile> FourPost::Files() const {
  std::vector<ExperimentFile> files;
  for (const StudyRecording& recording : plan.recordings)
    files.push_back({.path = recording.file, .line = recording.line});
  for (const StudyRecording& recording : plan.recordings)
    for (const OtherFile& other : recording.preparation.others)
      files.push_back({.path = other.path, .line = recording.line});
  for (const StudyRecording& recording : plan.validation) {
    files.push_back({.path = recording.file, .line = recording.line, .use = ExperimentFile::Use::kValidation});
    for (const OtherFile& other : recording.preparation.others)
      files.push_back({.path = other.path, .line = recording.line, .use = ExperimentFile::Use::kValidation});
  }
  return files;
}

void FourPost::CheckFiles(Diagnostics& diagnostics) const {
  for (const StudyRecording& recording : plan.recordings)
    ReadStudyRecording(recording, plan.file, plan.channels, {}, {}, diagnostics);
}

void FourPost::Load(const Subject& subject, Diagnostics& diagnostics) {
  AddChannelsByName(subject.vehicle(), plan);
  runs = LoadRuns(plan, subject.vehicle(), diagnostics);
  // What is wrong with the channels is wrong with them in these as well.
  if (diagnostics.HasErrors()) return;
  CheckBand(plan, runs, diagnostics);
  validation = LoadValidationRuns(plan, subject.vehicle(), diagnostics, left_out_);
}

void FourPost::AddTo(Sha256& data, Sha256& settings) const {
  for (const MeasuredRun& run : RunsInBand()) {
    data.Add(run.name);
    data.Add(run.excitation.frequency_Hz);
    data.Add(run.excitation.amplitude_m);
    data.Add(run.excitation.shape);
    for (const MeasuredChannel& channel : run.channels) Add(data, channel);
  }
  const ModelError& error = plan.model_error;
  for (const double number : {error.gain_dB, error.phase_rad, error.mean_m, error.second_harmonic_m, error.floor})
    settings.Add(number);
}

std::optional<ResidualBlock> FourPost::Residuals(const Subject& subject) const {
  return FourPostResiduals(subject.Condensed(), RunsInBand(), plan.model_error, subject.calibrations(),
                           subject.integrates());
}

bool FourPost::MeasuresForce() const {
  const auto is_force = [](const MeasuredChannel& channel) { return ParseUnit(channel.unit)->dimension == kForce; };
  return std::any_of(runs.begin(), runs.end(), [&](const MeasuredRun& run) {
    return std::any_of(run.channels.begin(), run.channels.end(), is_force);
  });
}

void FourPost::Check(const Subject& subject, Severity wrong_posts, Diagnostics& diagnostics) const {
  const Vehicle& vehicle = subject.vehicle();
  const CondensedModel model = subject.Condensed()->At(vehicle.ParameterValues());
  // Responses over time go with the amplitude: what is said of them then has this one cause.
  if (!LintAmplitudes(plan, runs, wrong_posts, diagnostics)) return;
  const std::vector<MeasuredRun> in_band = RunsInBand();
  LintSineUnits(plan, vehicle, in_band, ModelledResponses(model, vehicle.sensors, in_band), wrong_posts, diagnostics);
  const std::vector<MeasuredRun> sure = LintRuns({plan, vehicle, model, wrong_posts}, runs, diagnostics);
  ChannelWarnings warnings(plan.file, plan.channels, diagnostics);
  LintWheelpans(vehicle, sure, ModelledResponses(model, vehicle.sensors, sure), warnings);
}

void FourPost::CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const {
  LintChannels(plan, RunsInBand(), subject.vehicle(), subject.Condensed()->At(fit.values), diagnostics);
}

ExperimentResults FourPost::Results(const Subject& subject, const FitResult& fit) const {
  const Vehicle& vehicle = subject.vehicle();
  const CondensedModel model = subject.Condensed()->At(fit.values);
  const CondensedModel start = subject.Condensed()->At(vehicle.ParameterValues());
  const std::vector<MeasuredRun> in_band = RunsInBand();
  std::vector<MeasuredRun> all = runs;
  all.insert(all.end(), validation.begin(), validation.end());
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, vehicle.sensors, all);
  const std::vector<FrequencyResponse> fitted = ModelledResponses(model, vehicle.sensors, in_band);
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(in_band, fitted);
  const std::vector<ChannelMisfit> by_recording = RecordingMisfits(in_band, fitted);
  const std::vector<OctaveDiscrepancy> discrepancies = ResponseDiscrepancies(in_band, fitted);
  ExperimentResults results;
  for (const LeftOutRecording& recording : left_out_)
    results.json["validation_left_out"].push_back(LeftOutJson(recording));
  results.json.update({{"band_Hz", {plan.band_lower_Hz, plan.band_upper_Hz}},
                       {"recordings", RecordingsJson(vehicle, runs, by_recording)},
                       {"channels", ResponseMisfitsJson(misfits)},
                       {"discrepancy", DiscrepancyJson(discrepancies)},
                       {"covered", CoveredJson(CoveredBySines(vehicle, fit.values, in_band))}});
  LintTyrePulls(vehicle, fit.values, in_band, results.findings);
  results.shares = ErrorShares(in_band, fitted);
  results.text = MisfitTable(misfits, by_recording) + '\n';
  if (fit.end != FitEnd::kInterrupted) AddKinematics(plan, in_band, vehicle, fit.values, results);
  AddValidation(InBand(validation, plan.band_lower_Hz, plan.band_upper_Hz), vehicle, model, results);
  results.files = {
      {"response.csv", ResponseCsv(all, modelled, plan.band_lower_Hz, plan.band_upper_Hz,
                                   ModelledResponses(start, vehicle.sensors, all),
                                   BandsOf(subject, all, modelled, fit.Spread(), discrepancies, fit.options.threads))},
      {"response.svg", ResponseSvg(runs, modelled, misfits, plan.band_lower_Hz, plan.band_upper_Hz)}};
  if (fit.end != FitEnd::kInterrupted) AddMissingForce(subject, fit.values, fit.options.threads, results);
  return results;
}

void FourPost::AddMissingForce(const Subject& subject, const std::vector<double>& values, int threads,
                               ExperimentResults& results) const {
  AuditedVehicle audited(subject);
  AddRecordings(audited);
  const ForceRecord record = LackingForce(subject, values, RunsInBand(), audited.audited(), threads);
  const std::vector<ForceCurve> curves = ForceCurves(record);
  results.json["missing_force"] = MissingForceJson(record, ExplainForce(record));
  results.text += MissingForceText(results.json["missing_force"]);
  results.files.emplace_back("missing_force.csv", MissingForceCsv(record, curves));
  if (std::string picture = MissingForceSvg(record, curves); !picture.empty())
    results.files.emplace_back("missing_force.svg", std::move(picture));
}

std::optional<ExperimentResults> FourPost::Respond(const Subject& subject, std::optional<Engine> engine,
                                                   const WorkHooks& hooks) const {
  std::vector<MeasuredRun> answered = RunsInBand();
  ExperimentResults results;
  LintTyrePulls(subject.vehicle(), subject.vehicle().ParameterValues(), answered, results.findings);
  hooks.Find(results.findings);
  SteadySolver solver(subject.vehicle());
  RequireStable(subject.vehicle(), solver);
  std::vector<FrequencyResponse> modelled;
  std::string engines;
  for (const MeasuredRun& run : answered) {
    const std::optional<SteadyResponse> answer = WholeAnswer(run, solver, engine.value_or(Engine::kAuto), hooks);
    if (!answer) break;
    results.json["recordings"].push_back(AnswerJson(run, *answer));
    engines += EngineText(run.name, *answer);
    modelled.push_back(answer->response);
    if (hooks.IsStopped()) break;
  }
  if (modelled.size() < answered.size())
    hooks.Note("interrupted: " + std::to_string(modelled.size()) + " of " + std::to_string(answered.size()) +
               " recordings are answered");
  if (modelled.empty()) return std::nullopt;
  results.is_whole = modelled.size() == answered.size();
  answered.resize(modelled.size());
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(answered, modelled);
  for (const ChannelMisfit& misfit : misfits)
    results.json["channels"].push_back({{"name", misfit.name}, {"rms_dB", misfit.rms_dB}, {"rms_deg", misfit.rms_deg}});
  results.text = MisfitTable(misfits, RecordingMisfits(answered, modelled)) + engines;
  results.files = {{"response.csv", ResponseCsv(answered, modelled, plan.band_lower_Hz, plan.band_upper_Hz)},
                   {"response.svg", ResponseSvg(answered, modelled, misfits, plan.band_lower_Hz, plan.band_upper_Hz)}};
  return results;
}

bool FourPost::Reads(const RecordedTable& table) const {
  // Of a time history responses are made.
  return IsSteppedSine(table) || IsTimeHistory(table) || TimesAsIn(plan.recordings, table);
}

}  // namespace fourpost
