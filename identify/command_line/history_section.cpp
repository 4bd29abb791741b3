#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "identify/command_line/fit_section.h"
#include "identify/command_line/history_table.h"
#include "identify/history_fit_files.h"
#include "identify/history_residuals.h"
#include "identify/lint/history_lint.h"
#include "identify/motion_file.h"

namespace fourpost {

namespace {

/// Table and files; `name` of the files.
std::vector<HistoryMisfit> Show(const LoadedStudy& loaded, const HistoryResiduals& residuals, const FitResult& fit,
                                bool predicts, const std::string& name, FitSection& section) {
  const std::vector<MeasuredHistory>& histories = residuals.histories();
  const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(fit.values);
  std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
  if (predicts) AddOneStepErrors(histories, residuals.Predicted(fit.values), misfits);
  LintHistories(loaded, fit, residuals, misfits, section.findings);
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

/// A fit stands though its vehicle cannot go through what was kept for validation.
void AddValidation(const LoadedStudy& loaded, const std::shared_ptr<const CondensedVehicle>& condensed,
                   const FitResult& fit, FitSection& section, std::vector<RecordedHistory>& motions) {
  FitSection validation;
  try {
    const HistoryResiduals residuals(condensed, loaded.validation, {});
    validation.misfits.validation = Show(loaded, residuals, fit, false, "validation", validation);
    AddMotions(condensed->At(fit.values), residuals, motions);
  } catch (const std::runtime_error& failure) {
    section.findings.Warning(loaded.study.file.string(), 0,
                             std::string("what was kept for validation cannot be foretold by the fitted vehicle: ") +
                                 failure.what() + "; `fourpost check` of the vehicle.urdf of the results tells more");
    return;
  }
  section.misfits.validation = std::move(validation.misfits.validation);
  section.text += "Not fitted:\n" + validation.text;
  for (const Diagnostic& finding : validation.findings.items())
    section.findings.Warning(finding.file, finding.line, finding.message);
  std::move(validation.files.begin(), validation.files.end(), std::back_inserter(section.files));
}

}  // namespace

FitSection HistorySection(const LoadedStudy& loaded, const FitResult& fit) {
  FitSection section;
  if (loaded.histories.empty() && loaded.validation.empty()) return section;
  const auto condensed = std::make_shared<const CondensedVehicle>(loaded.vehicle);
  const CondensedModel model = condensed->At(fit.values);
  std::vector<RecordedHistory> motions;
  if (!loaded.histories.empty()) {
    const HistoryResiduals residuals(condensed, loaded.histories, loaded.HistoryOptions());
    const bool predicts = loaded.study.history_cost == HistoryCost::kPrediction;
    section.misfits.histories = Show(loaded, residuals, fit, predicts, "history", section);
    AddMotions(model, residuals, motions);
  }
  if (!loaded.validation.empty()) AddValidation(loaded, condensed, fit, section, motions);
  // A report cannot compute it anew: the folder of a run has no recordings.
  section.files.emplace_back("motion.csv", MotionCsv(loaded.vehicle, motions));
  return section;
}

}  // namespace fourpost
