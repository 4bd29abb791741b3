#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "identify/command_line/fit_section.h"
#include "identify/command_line/history_table.h"
#include "identify/history_fit_files.h"
#include "identify/history_residuals.h"

namespace fourpost {

namespace {

double LongestSample(const std::vector<MeasuredHistory>& histories) {
  double sample_s = 0;
  for (const MeasuredHistory& history : histories) sample_s = std::max(sample_s, 1 / history.rate_Hz);
  return sample_s;
}

/// Table and files; `name` of the files.
std::vector<HistoryMisfit> Show(const std::vector<MeasuredHistory>& histories, const HistoryResiduals& residuals,
                                const FitResult& fit, bool predicts, const std::string& name, FitSection& section) {
  const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(fit.values);
  std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
  if (predicts) AddOneStepErrors(histories, residuals.Predicted(fit.values), misfits);
  section.text += HistoryTable(misfits) + HistoryRemarks(misfits, LongestSample(histories)) + '\n';
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

}  // namespace

FitSection HistorySection(const LoadedStudy& loaded, const FitResult& fit) {
  FitSection section;
  if (loaded.histories.empty() && loaded.validation.empty()) return section;
  const auto condensed = std::make_shared<const CondensedVehicle>(loaded.vehicle);
  if (!loaded.histories.empty())
    section.misfits.histories =
        Show(loaded.histories, HistoryResiduals(condensed, loaded.histories, loaded.HistoryOptions()), fit,
             loaded.study.history_cost == HistoryCost::kPrediction, "history", section);
  if (!loaded.validation.empty()) {
    section.text += "Not fitted:\n";
    section.misfits.validation =
        Show(loaded.validation, HistoryResiduals(condensed, loaded.validation, {}), fit, false, "validation", section);
  }
  return section;
}

}  // namespace fourpost
