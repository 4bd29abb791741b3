#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "identify/command_line/fit_section.h"
#include "identify/command_line/history_table.h"
#include "identify/history_fit_files.h"
#include "identify/history_residuals.h"

namespace fourpost {

FitSection HistorySection(const LoadedStudy& loaded, const FitResult& fit) {
  const std::vector<MeasuredHistory>& histories = loaded.histories;
  if (histories.empty()) return {};
  const auto condensed = std::make_shared<const CondensedVehicle>(loaded.vehicle);
  const HistoryResiduals residuals(condensed, histories, loaded.HistoryOptions());
  const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(fit.values);
  FitSection section;
  section.misfits.histories = HistoryMisfits(histories, modelled);
  if (loaded.study.history_cost == HistoryCost::kPrediction)
    AddOneStepErrors(histories, residuals.Predicted(fit.values), section.misfits.histories);
  double sample_s = 0;
  for (const MeasuredHistory& history : histories) sample_s = std::max(sample_s, 1 / history.rate_Hz);
  section.text = HistoryTable(section.misfits.histories) + HistoryRemarks(section.misfits.histories, sample_s) + '\n';
  section.files.emplace_back("history.csv", HistoryFitCsv(histories, modelled));
  auto misfit = section.misfits.histories.begin();
  for (std::size_t h = 0; h < histories.size(); ++h) {
    const auto next = misfit + static_cast<std::ptrdiff_t>(histories[h].signals.size());
    const std::string name = histories.size() == 1 ? "history.svg" : "history_" + std::to_string(h + 1) + ".svg";
    section.files.emplace_back(name, HistoryFitSvg(histories[h], modelled[h], {misfit, next}));
    misfit = next;
  }
  return section;
}

}  // namespace fourpost
