#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "identify/command_line/fit_section.h"
#include "identify/command_line/history_table.h"
#include "identify/command_line/text_table.h"
#include "identify/history_fit_files.h"
#include "identify/history_residuals.h"
#include "identify/motion_file.h"

namespace fourpost {

namespace {

double LongestSample(const std::vector<MeasuredHistory>& histories) {
  double sample_s = 0;
  for (const MeasuredHistory& history : histories) sample_s = std::max(sample_s, 1 / history.rate_Hz);
  return sample_s;
}

/// A fit may hide a swap: what the vehicle file's own values show of one, and the fitted ones do not.
std::string SwapsAtStart(const Vehicle& vehicle, const HistoryResiduals& residuals,
                         const std::vector<HistoryMisfit>& fitted) {
  std::string remarks;
  const std::vector<HistoryMisfit> start =
      HistoryMisfits(residuals.histories(), residuals.Modelled(vehicle.ParameterValues()));
  for (std::size_t i = 0; i < start.size(); ++i)
    if (start[i].swapped_with && !fitted[i].swapped_with)
      remarks += "'" + start[i].name + "' of '" + start[i].recording + "' is measured like '" + *start[i].swapped_with +
                 "' of the vehicle file, and the other way round, as if the two channels were swapped\n";
  return remarks;
}

/// Where the steps that the file's values need are too long for the fitted ones.
std::string StepRemarks(const HistoryResiduals& residuals, const FitResult& fit) {
  std::string remarks;
  const std::vector<double> changes = residuals.ChangesByHalfStep(fit.values);
  for (std::size_t h = 0; h < changes.size(); ++h)
    if (changes[h] > residuals.options().error)
      remarks += "the fitted values need shorter steps than those of the vehicle file: half of the " +
                 Rounded(1e3 * residuals.Steps()[h], 3) + " ms taken changes a channel of '" +
                 residuals.histories()[h].name + "' by " + Rounded(100 * changes[h], 2) +
                 " % of its rms; fit again from the vehicle.urdf of these results\n";
  return remarks;
}

/// Table and files; `name` of the files.
std::vector<HistoryMisfit> Show(const Vehicle& vehicle, const HistoryResiduals& residuals, const FitResult& fit,
                                bool predicts, const std::string& name, FitSection& section) {
  const std::vector<MeasuredHistory>& histories = residuals.histories();
  const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(fit.values);
  std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
  if (predicts) AddOneStepErrors(histories, residuals.Predicted(fit.values), misfits);
  section.text += HistoryTable(misfits) + HistoryRemarks(misfits, LongestSample(histories)) +
                  SwapsAtStart(vehicle, residuals, misfits) + StepRemarks(residuals, fit) + '\n';
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
    section.misfits.histories = Show(loaded.vehicle, residuals, fit, predicts, "history", section);
    AddMotions(model, residuals, motions);
  }
  if (!loaded.validation.empty()) {
    section.text += "Not fitted:\n";
    const HistoryResiduals residuals(condensed, loaded.validation, {});
    section.misfits.validation = Show(loaded.vehicle, residuals, fit, false, "validation", section);
    AddMotions(model, residuals, motions);
  }
  // A report cannot compute it anew: the folder of a run has no recordings.
  section.files.emplace_back("motion.csv", MotionCsv(loaded.vehicle, motions));
  return section;
}

}  // namespace fourpost
