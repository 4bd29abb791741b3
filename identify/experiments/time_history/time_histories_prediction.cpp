// What a vehicle that is given makes of recordings over time.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "analysis/text/text_table.h"
#include "identify/experiments/time_history/covered_histories.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/experiments/time_history/history_bands.h"
#include "identify/experiments/time_history/history_fit_files.h"
#include "identify/experiments/time_history/history_misfits.h"
#include "identify/experiments/time_history/history_remark.h"
#include "identify/experiments/time_history/history_tyre_pull_lint.h"
#include "identify/experiments/time_history/kalman_noise_json.h"
#include "identify/experiments/time_history/kalman_progress.h"
#include "identify/experiments/time_history/release_text.h"
#include "identify/experiments/time_history/remedied_error.h"
#include "identify/experiments/time_history/time_histories.h"
#include "identify/residuals/history_misfit_json.h"
#include "identify/residuals/history_table.h"
#include "identify/study_file/measured_channels.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/history_files.h"

namespace fourpost {
namespace {

/// Nothing where it is interrupted.
std::optional<EngineHistory> Answer(const Subject& subject, const MeasuredHistory& history,
                                    const HistorySolver::Options& options, const WorkHooks& hooks) {
  const double end = history.TimeAt(history.count - 1);
  return SimulateBy(options, history, subject.vehicle(), subject.vehicle().ParameterValues(),
                    [&](const std::string& work, double t) {
                      // It runs in before the first sample.
                      hooks.Show(work + ": " + Rounded(std::max(0.0, t), 3) + " of " + Rounded(end, 3) + " s");
                      return !hooks.IsStopped();
                    });
}

/// One recording and what is asked of it.
class HistoryPrediction {
 public:
  HistoryPrediction(const HistoryPlan& plan, const Subject& subject, const PredictionRequest& request,
                    const WorkHooks& hooks)
      : plan_(plan), subject_(subject), request_(request), hooks_(hooks) {}

  std::optional<ExperimentResults> Run() const {
    ExperimentResults results;
    const std::vector<MeasuredHistory> histories = {Load(request_.recording, results.findings)};
    const MeasuredHistory& history = histories.front();
    const HistoryResiduals reduced(subject_.Condensed(), histories, {});
    const std::vector<double> values = subject_.vehicle().ParameterValues();
    WarnOfRelease(history, results.findings);
    LintTyrePulls(subject_.vehicle(), values, histories, reduced.Steps(), results.findings);
    WarnOfLeaving(ReadCovered(request_.run / "result.json"),
                  CoveredByHistories(subject_.vehicle(), values, histories, reduced.Steps()),
                  {request_.recording.string()}, results.findings);
    hooks_.Find(results.findings);
    const std::optional<EngineHistory> answer =
        Answer(subject_, history, {.engine = request_.engine.value_or(Engine::kAuto)}, hooks_);
    if (!answer) return std::nullopt;
    const std::vector<Eigen::MatrixXd> modelled = {reduced.WithStart(0, values, answer->modelled)};
    std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
    if (answer->by.engine == Engine::kFull) AddReducedErrors(history, reduced.Modelled(values).front(), misfits);
    if (request_.has_kalman) AddKalman(history, misfits);
    if (hooks_.IsStopped()) return std::nullopt;
    results.json = EngineJson(answer->by, HistorySolver::Options{}.error);
    results.json.update({{"start_s", history.TimeAt(0)},
                         {"end_s", history.TimeAt(history.count - 1)},
                         {"samples", history.count},
                         {"channels", HistoryMisfitsJson(misfits)}});
    results.files = {{"history.csv", HistoryFitCsv(histories, modelled)},
                     {"history.svg", HistoryFitSvg(history, modelled.front(), misfits)}};
    results.text = HistoryTable(misfits) + EngineText(answer->by);
    AddBands(reduced, modelled.front(), results);
    if (hooks_.IsStopped()) return std::nullopt;
    for (const HistoryRemark& remark : RemarksOn(misfits, 1 / history.rate_Hz, RemediedErrors(histories, modelled)))
      results.findings.Report(*remark.found.kind, {request_.recording.string()}, remark.found.words);
    return results;
  }

 private:
  /// The recording does not say from where it was let go.
  void WarnOfRelease(const MeasuredHistory& history, Diagnostics& findings) const {
    std::string heights;
    if (history.release && request_.release.empty())
      for (const Release::Hold& hold : history.release->held)
        if (hold.reading_m)
          heights += (heights.empty() ? "" : ", ") + hold.sensor + " " + Rounded(1e3 * *hold.reading_m, 4) + " mm";
    if (!heights.empty())
      findings.Report(kReleaseOfStudy, {request_.recording.string()},
                      {request_.recording.filename().string(), heights});
  }

  void AddBands(const HistoryResiduals& reduced, const Eigen::MatrixXd& modelled, ExperimentResults& results) const {
    if (!request_.spread) return;
    hooks_.Show(reduced.histories().front().name + ": bands");
    const HistoryBands bands = BandsOfHistory(reduced, subject_.vehicle(), modelled, *request_.spread,
                                              ReadHistoryDiscrepancies(request_.run / "result.json"));
    if (bands.counts.empty()) return;
    results.text += '\n' + BandCountsText(bands.counts, bands.evaluations);
    results.json["band_95"] = BandCountsJson(bands.counts, bands.evaluations);
  }

  /// The first of the study's histories, of this recording.
  StudyHistory Layout(const std::filesystem::path& recording, Diagnostics& findings) const {
    StudyHistory history = plan_.histories.front();
    history.file = recording;
    history.name = recording.stem().string();
    history.end_s.reset();
    // Beside this file there is none.
    history.preparation.others.clear();
    history.setting = request_.setting;
    if (recording == request_.recording) {
      if (request_.start_s) history.start_s = request_.start_s;
      if (!request_.release.empty()) LetGo(history);
    }
    Diagnostics diagnostics;
    const std::optional<RecordedTable> table = ReadRecordedTable(recording, diagnostics);
    if (!table) throw FaultyInput(diagnostics);
    MapByName(subject_.vehicle(), history);
    KeepMeasured(recording, table->names(), history.channels, findings);
    return history;
  }

  /// No post moves it then.
  void LetGo(StudyHistory& history) const {
    history.release = ParseRelease(request_.release);
    if (!history.release) Refuse(kReleaseOption, Place::Option("--release"), {request_.release});
    history.posts.clear();
    history.has_posts_by_name = false;
  }

  MeasuredHistory Load(const std::filesystem::path& recording, Diagnostics& findings) const {
    return Load(Layout(recording, findings), findings);
  }

  MeasuredHistory Load(const StudyHistory& layout, Diagnostics& diagnostics) const {
    const std::optional<std::vector<MeasuredHistory>> histories =
        LoadHistories({layout}, subject_.study_file().string(), subject_.vehicle(), diagnostics, subject_.control());
    if (!histories) throw FaultyInput(diagnostics);
    return histories->front();
  }

  /// As recorded: a Kalman filter takes no filter back.
  MeasuredHistory LoadAsRecorded(const std::filesystem::path& recording, std::optional<double> end_s) const {
    // Those of the recording with its filter have been found.
    Diagnostics findings;
    StudyHistory layout = Layout(recording, findings);
    layout.filter.reset();
    layout.end_s = end_s;
    return Load(layout, findings);
  }

  CondensedModel Model(const MeasuredHistory& history) const {
    return subject_.Condensed()->At(history.setting.At(subject_.vehicle().ParameterValues()));
  }

  /// Never of the recording that is judged.
  KalmanNoise NoiseOf(const MeasuredHistory& judged) const {
    if (request_.noise_from.empty()) {
      const std::optional<KalmanNoise> held = ReadKalmanNoise(request_.run / "result.json", judged);
      if (held) return *held;
      Refuse(kKalmanWithoutNoise, {request_.run.string()});
    }
    const MeasuredHistory recorded = LoadAsRecorded(request_.noise_from, std::nullopt);
    return KalmanPredictor(recorded).Estimate(Model(recorded), {.progress = KalmanProgress(hooks_)});
  }

  void AddKalman(const MeasuredHistory& judged, std::vector<HistoryMisfit>& misfits) const {
    for (const Damper& damper : subject_.vehicle().dampers) {
      if (damper.hydraulic) Refuse(kKalmanHydraulic, {(request_.run / "vehicle.urdf").string()}, {damper.name});
      if (damper.law.Sticks()) Refuse(kKalmanFriction, {(request_.run / "vehicle.urdf").string()}, {damper.name});
    }
    const MeasuredHistory recorded =
        LoadAsRecorded(request_.recording, judged.TimeAt(judged.count - 1) + 0.5 / judged.rate_Hz);
    const KalmanPrediction prediction = KalmanPredictor(recorded).Run(Model(recorded), NoiseOf(recorded));
    AddOneStepErrors({recorded}, {prediction}, misfits);
  }

  const HistoryPlan& plan_;
  const Subject& subject_;
  const PredictionRequest& request_;
  const WorkHooks& hooks_;
};

/// Integrated in time, a steady response is one of the full geometry.
Engine HistoryEngineOf(std::optional<Engine> engine) {
  return engine == Engine::kTimeIntegration ? Engine::kFull : engine.value_or(Engine::kAuto);
}

/// By the engine that each needs; of those before an interruption.
std::vector<HistoryMisfit> Answers(std::vector<MeasuredHistory> histories, const Subject& subject,
                                   std::optional<Engine> engine, const WorkHooks& hooks, const std::string& file,
                                   ExperimentResults& results) {
  if (histories.empty() || !results.is_whole) return {};
  const HistoryResiduals reduced(subject.Condensed(), histories, {});
  const std::vector<double> values = subject.vehicle().ParameterValues();
  LintTyrePulls(subject.vehicle(), values, histories, reduced.Steps(), results.findings);
  hooks.Find(results.findings);
  std::vector<Eigen::MatrixXd> modelled;
  for (const MeasuredHistory& history : histories) {
    const HistorySolver::Options options{.engine = HistoryEngineOf(engine), .error = reduced.options().error};
    std::optional<EngineHistory> answer = Answer(subject, history, options, hooks);
    if (!answer) break;
    nlohmann::ordered_json entry = {{"recording", history.name}};
    entry.update(EngineJson(answer->by, options.error));
    results.json["histories"].push_back(entry);
    results.text += FitEngineText(history.name, answer->by);
    modelled.push_back(reduced.WithStart(modelled.size(), values, answer->modelled));
  }
  if (modelled.size() < histories.size())
    hooks.Note("interrupted: " + std::to_string(modelled.size()) + " of " + std::to_string(histories.size()) +
               " recordings are answered");
  results.is_whole = modelled.size() == histories.size();
  histories.resize(modelled.size());
  if (histories.empty()) return {};
  results.files.emplace_back(file, HistoryFitCsv(histories, modelled));
  return HistoryMisfits(histories, modelled);
}

}  // namespace

std::optional<ExperimentResults> TimeHistories::Predict(const Subject& subject, const PredictionRequest& request,
                                                        const WorkHooks& hooks) const {
  std::optional<ExperimentResults> results = HistoryPrediction(plan, subject, request, hooks).Run();
  if (results && !request.mode.empty())
    results->findings.Report(kModeOfHistory, Place::Option("--mode"), {request.recording.filename().string()});
  return results;
}

std::optional<ExperimentResults> TimeHistories::Respond(const Subject& subject, std::optional<Engine> engine,
                                                        const WorkHooks& hooks) const {
  ExperimentResults results;
  const std::vector<HistoryMisfit> fit = Answers(fitted, subject, engine, hooks, "history.csv", results);
  const std::vector<HistoryMisfit> kept = Answers(validation, subject, engine, hooks, "validation.csv", results);
  if (!results.is_whole && fit.empty() && kept.empty()) return std::nullopt;
  results.json["channels"] = HistoryMisfitsJson(fit);
  if (!kept.empty()) results.json["validation"] = HistoryMisfitsJson(kept);
  std::vector<HistoryMisfit> all = fit;
  all.insert(all.end(), kept.begin(), kept.end());
  results.text = HistoryTable(all) + results.text;
  return results;
}

}  // namespace fourpost
