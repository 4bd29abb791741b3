#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "identify/command_line/engine_text.h"
#include "identify/command_line/fit_section.h"
#include "identify/command_line/history_table.h"
#include "identify/history_fit_files.h"
#include "identify/history_residuals.h"
#include "identify/lint/history_lint.h"
#include "identify/lint/tyre_pull_lint.h"
#include "identify/motion_file.h"

namespace fourpost {

namespace {

/// Table and files; `name` of the files.
std::vector<HistoryMisfit> Show(const LoadedStudy& loaded, const HistoryResiduals& residuals, const FitResult& fit,
                                const std::vector<Eigen::MatrixXd>& modelled, bool predicts, const std::string& name,
                                FitSection& section) {
  const std::vector<MeasuredHistory>& histories = residuals.histories();
  std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
  if (predicts) AddOneStepErrors(histories, residuals.Predicted(fit.values), misfits);
  LintHistories(loaded, fit, residuals, misfits, section.findings);
  LintTyrePulls(loaded.vehicle, fit.values, histories, residuals.Steps(), section.findings);
  section.text += HistoryTable(misfits) + '\n';
  section.files.emplace_back(name + ".csv", HistoryFitCsv(histories, modelled));
  auto misfit = misfits.begin();
  for (std::size_t h = 0; h < histories.size(); ++h) {
    const auto next = misfit + static_cast<std::ptrdiff_t>(histories[h].signals.size());
    const std::string number = histories.size() == 1 ? "" : "_" + std::to_string(h + 1);
    section.files.emplace_back(name + number + ".svg", HistoryFitSvg(histories[h], modelled[h], {misfit, next}));
    misfit = next;
  }
  return misfits;
}

/// How the fitted vehicle moved in each.
void AddMotions(const CondensedModel& model, const HistoryResiduals& residuals, std::vector<RecordedHistory>& motions) {
  const std::vector<double> steps = residuals.Steps();
  for (std::size_t h = 0; h < steps.size(); ++h) {
    const MeasuredHistory& history = residuals.histories()[h];
    const Eigen::Index columns = static_cast<Eigen::Index>(history.posts.count) + model.mass.rows();
    motions.push_back(
        {history.name, HistorySimulation(history, steps[h]).Motion(model, FrameStride(history, columns))});
  }
}

void AddEngines(const LoadedStudy& loaded, const std::vector<HistoryEngine>& engines, FitSection& section) {
  for (std::size_t h = 0; h < engines.size(); ++h) {
    const std::string& name = loaded.histories[h].name;
    section.misfits.modelled_by.push_back(
        {.recording = name, .by = engines[h], .error = loaded.HistoryOptions().error});
    section.text += FitEngineText(name, engines[h]);
    if (engines[h].engine == Engine::kReduced && engines[h].kinematics_error &&
        engines[h].kinematics_error->IsVisible())
      section.findings.Warning(loaded.study.file.string(), 0,
                               "history '" + name + "': " + KinematicsText(*engines[h].kinematics_error) +
                                   ", and a cost by prediction is not corrected for it; take another 'cost'");
  }
  if (!engines.empty()) section.text += '\n';
}

/// Histories kept for validation and what the fitted vehicle makes of each, by the engine that it needs.
struct Predictions {
  std::vector<MeasuredHistory> histories;
  std::vector<Eigen::MatrixXd> modelled;
  std::vector<ModelledHistory> by;
};

/// Of those that the fitted vehicle can go through; a fit stands without the others.
Predictions Predict(const LoadedStudy& loaded, const std::shared_ptr<const CondensedVehicle>& condensed,
                    const FitResult& fit, FitSection& section) {
  const HistorySolver::Options options{.error = loaded.HistoryOptions().error};
  Predictions out;
  for (const MeasuredHistory& history : loaded.validation) {
    Diagnostics found;
    try {
      // Remarks on it and the motion shown are the reduced model's.
      HistoryResiduals(condensed, {history}, {}).Modelled(fit.values);
      EngineHistory answer = SimulateBy(options, history, loaded.vehicle, fit.values).value();
      out.histories.push_back(history);
      out.modelled.push_back(std::move(answer.modelled));
      out.by.push_back(
          {.recording = history.name, .is_fitted = false, .by = std::move(answer.by), .error = options.error});
    } catch (const std::runtime_error& failure) {
      found.Error(loaded.study.file.string(), 0,
                  "'" + history.name + "' cannot be predicted by the fitted vehicle: " + failure.what() +
                      "; `fourpost check` of the vehicle.urdf of the results tells more");
    }
    if (std::optional<LeftOutRecording> left_out = LeftOutFor(found, history.name, {}, section.findings))
      section.misfits.left_out.push_back(*std::move(left_out));
  }
  return out;
}

void AddValidation(const LoadedStudy& loaded, const std::shared_ptr<const CondensedVehicle>& condensed,
                   const FitResult& fit, FitSection& section, std::vector<RecordedHistory>& motions) {
  Predictions predictions = Predict(loaded, condensed, fit, section);
  if (predictions.histories.empty()) return;
  const HistoryResiduals residuals(condensed, predictions.histories, {});
  FitSection validation;
  validation.misfits.validation = Show(loaded, residuals, fit, predictions.modelled, false, "validation", validation);
  for (const ModelledHistory& history : predictions.by) validation.text += FitEngineText(history.recording, history.by);
  AddMotions(condensed->At(fit.values), residuals, motions);
  section.misfits.validation = std::move(validation.misfits.validation);
  std::move(predictions.by.begin(), predictions.by.end(), std::back_inserter(section.misfits.modelled_by));
  section.text += "Not fitted:\n" + validation.text;
  for (const Diagnostic& finding : validation.findings.items())
    section.findings.Warning(finding.file, finding.line, finding.message);
  std::move(validation.files.begin(), validation.files.end(), std::back_inserter(section.files));
}

}  // namespace

FitSection HistorySection(const LoadedStudy& loaded, const FitResult& fit, const std::vector<HistoryEngine>& engines) {
  FitSection section;
  if (loaded.histories.empty() && loaded.validation.empty()) return section;
  const auto condensed = std::make_shared<const CondensedVehicle>(loaded.vehicle);
  const CondensedModel model = condensed->At(fit.values);
  std::vector<RecordedHistory> motions;
  if (!loaded.histories.empty()) {
    const HistoryResiduals residuals(condensed, loaded.histories, loaded.HistoryOptions());
    const bool predicts = loaded.study.history_cost == HistoryCost::kPrediction;
    section.misfits.histories =
        Show(loaded, residuals, fit, residuals.Modelled(fit.values), predicts, "history", section);
    section.misfits.shares = ErrorShares(section.misfits.histories);
    AddMotions(model, residuals, motions);
    AddEngines(loaded, engines, section);
  }
  if (!loaded.validation.empty()) AddValidation(loaded, condensed, fit, section, motions);
  // A report cannot compute it anew: the folder of a run has no recordings.
  section.files.emplace_back("motion.csv", MotionCsv(loaded.vehicle, motions));
  return section;
}

}  // namespace fourpost
