#include "identify/experiments/bench/damper_bench.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/experiments/band_count.h"
#include "identify/experiments/bench/bench_bands.h"
#include "identify/experiments/bench/bench_chart.h"
#include "identify/experiments/bench/bench_cycle.h"
#include "identify/experiments/bench/bench_residuals.h"
#include "identify/experiments/bench/bench_result.h"
#include "identify/experiments/bench/findings.h"
#include "identify/fit/fit.h"
#include "identify/residuals/history_misfit_json.h"
#include "identify/residuals/history_table.h"
#include "identify/uncertainty/model_criteria.h"
#include "vehicles/reader/damper_text.h"
#include "vehicles/requests/engine_text.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

void AddRows(const std::vector<HistoryMisfit>& misfits, const std::string& use, TextTable& table) {
  for (const HistoryMisfit& misfit : misfits)
    table.Add({misfit.recording, use, Rounded(misfit.nmse_percent, 3), Rounded(misfit.vaf_percent, 4)});
}

std::string CriteriaText(const ModelCriteria& criteria) {
  return "AICc " + Rounded(criteria.aicc, 6) + ", BIC " + Rounded(criteria.bic, 6) + " of " +
         std::to_string(criteria.parameters) + " parameters for " + std::to_string(criteria.residuals) +
         " residuals; `fourpost rank` compares them with those of other models\n";
}

Json CriteriaJson(const ModelCriteria& criteria) {
  return {{"residuals", criteria.residuals},
          {"parameters", criteria.parameters},
          {"aicc", NumberOrNull(criteria.aicc)},
          {"bic", NumberOrNull(criteria.bic)}};
}

/// Before the elements of damper.xml.
constexpr const char* kPasteNote =
    "<!-- Fitted to a bench. To use it in place of a vehicle's damper: set parent, child and points to those of that "
    "damper, and take out each fp:parameter that only that damper used. -->\n";

/// A fit stands though its damper cannot move as in some of what was kept for validation.
std::vector<ModelledRecording> Predicted(const BenchDamper& damper, const std::vector<BenchRecording>& recordings,
                                         const std::vector<double>& values, ExperimentResults& results) {
  std::vector<ModelledRecording> predicted;
  for (const BenchRecording& recording : recordings) {
    Diagnostics found;
    try {
      predicted.push_back(Modelled(damper, recording, values));
    } catch (const std::runtime_error& failure) {
      found.Report(kBenchNotPredicted, {}, {recording.name, failure.what()});
    }
    if (const std::optional<LeftOutRecording> out = LeftOutFor(found, recording.name, {}, results.findings))
      results.json["validation_left_out"].push_back(LeftOutJson(*out));
  }
  return predicted;
}

/// Of the one recording that is predicted; nothing of a fit that does not say how far it is off.
std::optional<BenchBands> AddBands(const BenchDamper& damper, const ModelledRecording& modelled, const Vehicle& vehicle,
                                   const PredictionRequest& request, ExperimentResults& results) {
  if (!request.spread) return std::nullopt;
  const std::optional<double> discrepancy = ReadForceDiscrepancy(request.run / "result.json");
  if (!discrepancy) return std::nullopt;
  std::optional<BenchBands> bands = BandsOfForce(damper, modelled, vehicle, *request.spread, *discrepancy);
  if (!bands) return std::nullopt;
  results.text += '\n' + BandCountsText({bands->count}, bands->evaluations);
  results.json["band_95"] = BandCountsJson({bands->count}, bands->evaluations);
  return bands;
}

/// The integration error of each force, and a warning where it is visible.
void AddIntegration(const BenchDamper& damper, const std::vector<ModelledRecording>& recordings,
                    const std::vector<double>& values, ExperimentResults& results) {
  constexpr double kVisible = 1e-3;
  const ModelledRecording* worst = nullptr;
  double largest = 0;
  for (const ModelledRecording& modelled : recordings) {
    const double error = IntegrationError(damper, modelled, values);
    nlohmann::ordered_json entry = {{"recording", modelled.recording.name}, {"error", error}};
    if (!modelled.recording.preparations.empty()) entry["preparation"] = modelled.recording.preparations;
    results.json["integration"].push_back(std::move(entry));
    if (worst != nullptr && error <= largest) continue;
    worst = &modelled;
    largest = error;
  }
  if (worst == nullptr) return;
  const std::string size = Percent(std::max(1e-6, largest), 2) + " of its rms";
  results.text += "halving the step changed no force by more than " + size + '\n';
  if (largest > kVisible) results.findings.Report(kBenchForceInaccurate, {worst->recording.name}, {size});
}

/// Fitted ones first.
std::vector<BenchStudy::Recording> AllOf(const BenchStudy& plan) {
  std::vector<BenchStudy::Recording> all = plan.recordings;
  all.insert(all.end(), plan.validation.begin(), plan.validation.end());
  return all;
}

bool HasColumns(const RecordedTable& table, const BenchStudy& plan, const BenchStudy::Recording& of) {
  return table.FindColumn(of.displacement.value_or(plan.displacement).name) &&
         table.FindColumn(of.force.value_or(plan.force).name);
}

/// The first recording whose columns a file has.
std::optional<BenchStudy::Recording> WithColumnsOf(const BenchStudy& plan, const RecordedTable& table) {
  for (const BenchStudy::Recording& one : AllOf(plan))
    if (HasColumns(table, plan, one)) return one;
  return std::nullopt;
}

/// With all that the study says of this file, if it does; else with columns that the file has.
BenchStudy::Recording AsStated(const BenchStudy& plan, const PredictionRequest& request) {
  const std::vector<BenchStudy::Recording> all = AllOf(plan);
  const auto stated = std::find_if(all.begin(), all.end(), [&](const BenchStudy::Recording& one) {
    std::error_code is_missing;
    return std::filesystem::equivalent(one.file, request.recording, is_missing);
  });
  BenchStudy::Recording recording = {.name = request.recording.stem().string(), .file = request.recording};
  if (stated != all.end()) recording = *stated;
  Diagnostics left_to_loading;
  const std::optional<RecordedTable> table = ReadRecordedTable(request.recording, left_to_loading);
  if (stated == all.end() && table && !HasColumns(*table, plan, recording))
    if (const std::optional<BenchStudy::Recording> like = WithColumnsOf(plan, *table)) {
      recording.displacement = like->displacement;
      recording.force = like->force;
      recording.time = like->time;
    }
  if (request.setting) recording.setting = request.setting;
  return recording;
}

}  // namespace

std::unique_ptr<Experiment> DamperBench::Read(const StrictMap& study) {
  if (!study.Has("bench")) return nullptr;
  auto bench = std::make_unique<DamperBench>();
  bench->file = study.file();
  bench->plan = ReadBenchStudy(study.Get("bench"), study.file(), study.diagnostics());
  return bench;
}

std::vector<ExperimentFile> DamperBench::Files() const {
  std::vector<ExperimentFile> files;
  for (const BenchStudy::Recording& recording : plan.recordings)
    files.push_back({.path = recording.file, .line = recording.line});
  for (const BenchStudy::Recording& recording : plan.validation)
    files.push_back({.path = recording.file, .line = recording.line, .use = ExperimentFile::Use::kValidation});
  return files;
}

std::vector<double> DamperBench::Settings() const {
  std::vector<double> settings;
  for (const BenchStudy::Recording& recording : plan.recordings)
    if (recording.setting) settings.push_back(*recording.setting);
  return settings;
}

void DamperBench::Load(const Subject& subject, Diagnostics& diagnostics) {
  std::optional<BenchData> loaded = LoadBenchData(plan, file, subject.vehicle(), diagnostics, subject.control());
  if (!loaded) return;
  data = *std::move(loaded);
  left_out_ = data.left_out;
}

void DamperBench::AddTo(Sha256& digest, Sha256& settings) const {
  digest.Add(static_cast<double>(data.damper));
  for (const BenchRecording& recording : data.fitted) {
    digest.Add(recording.name);
    fourpost::AddTo(digest, recording.setting);
    digest.Add(recording.sample_s);
    digest.Add(recording.cutoff_Hz);
    digest.Add(recording.motion.extension);
    digest.Add(recording.force);
    for (const char is_unknown : recording.is_unknown) digest.Add(static_cast<double>(is_unknown));
  }
  settings.Add(plan.model_error);
}

std::optional<ResidualBlock> DamperBench::Residuals(const Subject& subject) const {
  return BenchResiduals(subject.vehicle(), data, plan.model_error);
}

ExperimentResults DamperBench::Results(const Subject& subject, const FitResult& fit) const {
  const Vehicle& vehicle = subject.vehicle();
  const BenchDamper damper(vehicle, data.damper);
  const std::vector<ModelledRecording> fitted = ModelledRecordings(damper, data.fitted, fit.values);
  ExperimentResults results;
  const std::vector<ModelledRecording> kept = Predicted(damper, data.validation, fit.values, results);
  for (const LeftOutRecording& recording : left_out_)
    results.json["validation_left_out"].push_back(LeftOutJson(recording));
  std::vector<HistoryMisfit> misfits = BenchMisfits(fitted);
  std::vector<HistoryMisfit> kept_misfits = BenchMisfits(kept);
  const std::vector<YardstickRecord> records = YardstickRecords(fitted);
  AddYardsticks(records, records, misfits);
  AddYardsticks(records, YardstickRecords(kept), kept_misfits);
  results.json["channels"] = HistoryMisfitsJson(misfits);
  results.json["history_discrepancy"] = {{{"channel", "force"}, {"share", ForceDiscrepancy(fitted)}}};
  if (!kept_misfits.empty()) results.json["validation"] = HistoryMisfitsJson(kept_misfits);
  results.shares = ErrorShares(misfits);
  const ModelCriteria criteria = CriteriaOf(
      fit.data_squares, static_cast<std::size_t>(fit.residual_count - fit.prior_count), subject.free().size());
  results.json["criteria"] = CriteriaJson(criteria);
  TextTable table({"recording", "", "NMSE, %", "VAF, %"});
  AddRows(misfits, "fitted", table);
  AddRows(kept_misfits, "validation", table);
  results.text = table.Format();
  std::vector<HistoryMisfit> all_misfits = misfits;
  all_misfits.insert(all_misfits.end(), kept_misfits.begin(), kept_misfits.end());
  if (const std::string yardsticks = YardstickTable(all_misfits); !yardsticks.empty())
    results.text += '\n' + yardsticks + '\n';
  std::vector<ModelledRecording> all = fitted;
  all.insert(all.end(), kept.begin(), kept.end());
  AddIntegration(damper, all, fit.values, results);
  results.text += CriteriaText(criteria) + '\n';

  const std::string& title = vehicle.name;
  results.files = {{"bench.csv", BenchCsv(all)},
                   {"cycles.csv", CyclesCsv(all)},
                   {"diagrams.svg", DiagramSvg(title + ": work and characteristic diagrams", all)},
                   {"frequency.svg", FrequencySvg(title + ": force, speed and frequency", fitted)},
                   {"equivalent.svg", EquivalentSvg(title + ": linear equivalents of every cycle", fitted)}};
  std::string elements;
  for (const Damper& one : damper.dampers()) elements += DamperText(vehicle, one.name, fit.values);
  if (!elements.empty()) results.files.emplace_back("damper.xml", kPasteNote + elements);
  return results;
}

std::optional<ExperimentResults> DamperBench::Respond(const Subject& subject, std::optional<Engine> engine,
                                                      const WorkHooks&) const {
  if (engine) Refuse(kBenchEngine, Place::Option("--engine"));
  const BenchDamper damper(subject.vehicle(), data.damper);
  const std::vector<double> values = subject.vehicle().ParameterValues();
  std::vector<ModelledRecording> all = ModelledRecordings(damper, data.fitted, values);
  std::vector<HistoryMisfit> misfits = BenchMisfits(all);
  ExperimentResults results;
  results.json["channels"] = HistoryMisfitsJson(misfits);
  const std::vector<ModelledRecording> kept = ModelledRecordings(damper, data.validation, values);
  const std::vector<HistoryMisfit> kept_misfits = BenchMisfits(kept);
  if (!kept.empty()) results.json["validation"] = HistoryMisfitsJson(kept_misfits);
  misfits.insert(misfits.end(), kept_misfits.begin(), kept_misfits.end());
  all.insert(all.end(), kept.begin(), kept.end());
  results.text = HistoryTable(misfits);
  results.files = {{"bench.csv", BenchCsv(all)}};
  return results;
}

bool DamperBench::Reads(const RecordedTable& table) const {
  return HasColumns(table, plan, {}) || WithColumnsOf(plan, table).has_value();
}

std::optional<ExperimentResults> DamperBench::Predict(const Subject& subject, const PredictionRequest& request,
                                                      const WorkHooks&) const {
  ExperimentResults results;
  const auto refuse = [&](bool is_given, const char* option) {
    if (is_given) results.findings.Report(kBenchEngine, Place::Option(option));
  };
  refuse(request.engine.has_value(), "--engine");
  refuse(!request.mode.empty(), "--mode");
  refuse(request.has_kalman, "--kalman");
  refuse(!request.noise_from.empty(), "--noise-from");
  if (results.findings.HasErrors()) throw FaultyInput(results.findings);
  RefuseRelease(request);
  DamperBench other = *this;
  other.plan.recordings = {AsStated(plan, request)};
  other.plan.validation.clear();
  other.Load(subject, results.findings);
  if (results.findings.HasErrors()) throw FaultyInput(results.findings);
  const BenchDamper damper(subject.vehicle(), other.data.damper);
  const std::vector<double> values = subject.vehicle().ParameterValues();
  const std::vector<ModelledRecording> modelled = ModelledRecordings(damper, other.data.fitted, values);
  const std::vector<HistoryMisfit> misfits = BenchMisfits(modelled);
  results.text = HistoryTable(misfits);
  AddIntegration(damper, modelled, values, results);
  results.json["channels"] = HistoryMisfitsJson(misfits);
  const std::optional<BenchBands> bands = AddBands(damper, modelled.front(), subject.vehicle(), request, results);
  results.files = {
      {"bench.csv", BenchCsv(modelled, bands ? &bands->about : nullptr)},
      {"diagrams.svg", DiagramSvg(subject.vehicle().name + ": work and characteristic diagrams", modelled)}};
  return results;
}

}  // namespace fourpost
