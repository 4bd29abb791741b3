#include "identify/experiments/four_post/four_post.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>

#include "analysis/files/recording_layout.h"
#include "analysis/signals/decibel.h"
#include "analysis/text/number.h"
#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/audit/audit.h"
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
#include "identify/experiments/four_post/response_misfit_json.h"
#include "identify/experiments/four_post/study_recording.h"
#include "identify/experiments/four_post/tyre_pull_lint.h"
#include "identify/experiments/four_post/unit_of_sines_lint.h"
#include "identify/experiments/four_post/wheelpan_lint.h"
#include "identify/fit/fit.h"
#include "identify/missing_force/missing_force.h"
#include "vehicles/requests/engine_text.h"
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

/// What the fitted vehicle makes of recordings that the fit has not seen.
void AddValidation(const std::vector<MeasuredRun>& unseen, const std::vector<FrequencyResponse>& predicted,
                   const ModelError& model_error, ExperimentResults& results) {
  if (unseen.empty()) return;
  results.json["validation"] = UnseenMisfitsJson(unseen, predicted, model_error);
  results.unseen_text +=
      MisfitTable(ResponseMisfits(unseen, predicted), RecordingMisfits(unseen, predicted), results.text) + '\n';
}

/// In the band, of runs that stand first in `modelled`.
std::vector<ChannelMisfit> ShownMisfits(const std::vector<MeasuredRun>& drawn,
                                        const std::vector<FrequencyResponse>& modelled, const FourPostPlan& plan) {
  const std::vector<FrequencyResponse> of_drawn(modelled.begin(), modelled.begin() + std::ssize(drawn));
  return ResponseMisfits(InBand(drawn, plan.band_lower_Hz, plan.band_upper_Hz),
                         InBand(of_drawn, plan.band_lower_Hz, plan.band_upper_Hz));
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
  if (runs.empty()) return std::nullopt;
  return FourPostResiduals(subject.Condensed(), RunsInBand(), plan.model_error, subject.calibrations(),
                           subject.integrates(), subject.known_answers());
}

bool FourPost::MeasuresForce() const {
  const auto is_force = [](const MeasuredChannel& channel) { return ParseUnit(channel.unit)->dimension == kForce; };
  return std::any_of(runs.begin(), runs.end(), [&](const MeasuredRun& run) {
    return std::any_of(run.channels.begin(), run.channels.end(), is_force);
  });
}

Audit FourPost::AuditOf(const Subject& subject) const {
  AuditedVehicle audited(subject);
  AddRecordings(audited);
  return AuditRig(audited.audited());
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
  const auto audit = [&] { return AuditOf(subject); };
  LintWheelpans(vehicle, sure, ModelledResponses(model, vehicle.sensors, sure), audit, warnings);
}

void FourPost::CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const {
  const auto is_cleared = [&](const std::vector<std::string>& channels) {
    return ClearsChannels(AuditOf(subject), channels);
  };
  LintChannels(plan, RunsInBand(), subject.vehicle(), subject.Condensed()->At(fit.values), is_cleared, diagnostics);
}

ExperimentResults FourPost::Results(const Subject& subject, const FitResult& fit) const {
  const Vehicle& vehicle = subject.vehicle();
  const CondensedModel model = subject.Condensed()->At(fit.values);
  const CondensedModel start = subject.Condensed()->At(vehicle.ParameterValues());
  std::vector<MeasuredRun> all = runs;
  all.insert(all.end(), validation.begin(), validation.end());
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, vehicle.sensors, all);
  ExperimentResults results;
  for (const LeftOutRecording& recording : left_out_)
    results.json["validation_left_out"].push_back(LeftOutJson(recording));
  const std::vector<OctaveDiscrepancy> discrepancies = AddFitted(subject, fit, model, results);
  const std::vector<FrequencyResponse> predicted(modelled.begin() + std::ssize(runs), modelled.end());
  AddValidation(InBand(validation, plan.band_lower_Hz, plan.band_upper_Hz),
                InBand(predicted, plan.band_lower_Hz, plan.band_upper_Hz), plan.model_error, results);
  const std::vector<MeasuredRun>& drawn = runs.empty() ? validation : runs;
  results.files.emplace_back(
      "response.csv",
      ResponseCsv(all, modelled, plan.band_lower_Hz, plan.band_upper_Hz, ModelledResponses(start, vehicle.sensors, all),
                  BandsOf(subject, all, modelled, fit.Spread(), discrepancies, fit.options.threads)));
  if (!drawn.empty())
    results.files.emplace_back("response.svg", ResponseSvg(drawn, modelled, ShownMisfits(drawn, modelled, plan),
                                                           plan.band_lower_Hz, plan.band_upper_Hz));
  if (fit.end != FitEnd::kInterrupted && !runs.empty())
    AddMissingForce(subject, fit.values, fit.options.threads, results);
  return results;
}

std::vector<OctaveDiscrepancy> FourPost::AddFitted(const Subject& subject, const FitResult& fit,
                                                   const CondensedModel& model, ExperimentResults& results) const {
  const Vehicle& vehicle = subject.vehicle();
  const std::vector<MeasuredRun> in_band = RunsInBand();
  const std::vector<FrequencyResponse> fitted = ModelledResponses(model, vehicle.sensors, in_band);
  std::vector<ChannelMisfit> misfits = ResponseMisfits(in_band, fitted);
  AddDeviations(in_band, fitted, plan.model_error, misfits);
  for (ChannelMisfit& misfit : misfits)
    misfit.worst = WorstOctaveOf(misfit.name, in_band, fitted, plan.model_error,
                                 {.lower_Hz = plan.band_lower_Hz, .upper_Hz = plan.band_upper_Hz});
  const std::vector<ChannelMisfit> by_recording = RecordingMisfits(in_band, fitted);
  const std::vector<OctaveDiscrepancy> discrepancies = ResponseDiscrepancies(in_band, fitted);
  results.json.update({{"band_Hz", {plan.band_lower_Hz, plan.band_upper_Hz}},
                       {"recordings", RecordingsJson(vehicle, runs, by_recording)},
                       {"channels", ResponseMisfitsJson(misfits)},
                       {"discrepancy", DiscrepancyJson(discrepancies)},
                       {"covered", CoveredJson(CoveredBySines(vehicle, fit.values, in_band))}});
  if (runs.empty()) return discrepancies;
  LintTyrePulls(vehicle, fit.values, in_band, results.findings);
  results.shares = ErrorShares(in_band, fitted);
  results.text = MisfitTable(misfits, by_recording) + '\n';
  if (fit.end != FitEnd::kInterrupted) AddKinematics(plan, in_band, vehicle, fit.values, results);
  return discrepancies;
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

bool FourPost::Reads(const RecordedTable& table) const {
  // Of a time history responses are made.
  return IsSteppedSine(table) || IsTimeHistory(table) || TimesAsIn(plan.Stated(), table);
}

}  // namespace fourpost
