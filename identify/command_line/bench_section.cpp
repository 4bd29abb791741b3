#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "identify/bench_chart.h"
#include "identify/bench_cycle.h"
#include "identify/bench_result.h"
#include "identify/command_line/engine_text.h"
#include "identify/command_line/fit_section.h"
#include "identify/command_line/text_table.h"
#include "vehicles/reader/damper_text.h"

namespace fourpost {
namespace {

void AddRows(const std::vector<HistoryMisfit>& misfits, const std::string& use, TextTable& table) {
  for (const HistoryMisfit& misfit : misfits)
    table.Add({misfit.recording, use, Rounded(misfit.nmse_percent, 3), Rounded(misfit.vaf_percent, 4)});
}

std::string CriteriaText(const ModelCriteria& criteria) {
  return "AICc " + Rounded(criteria.aicc, 6) + ", BIC " + Rounded(criteria.bic, 6) + " of " +
         std::to_string(criteria.parameters) + " parameters for " + std::to_string(criteria.residuals) +
         " residuals; `fourpost rank` compares them with those of other models\n";
}

/// Before the elements of damper.xml.
constexpr const char* kPasteNote =
    "<!-- Fitted to a bench. To use it in place of a vehicle's damper: set parent, child and points to those of that "
    "damper, and take out each fp:parameter that only that damper used. -->\n";

/// A fit stands though its damper cannot move as in some of what was kept for validation.
std::vector<ModelledRecording> Predicted(const BenchDamper& damper, const std::vector<BenchRecording>& recordings,
                                         const std::vector<double>& values, FitSection& section) {
  std::vector<ModelledRecording> predicted;
  for (const BenchRecording& recording : recordings) {
    Diagnostics found;
    try {
      predicted.push_back(Modelled(damper, recording, values));
    } catch (const std::runtime_error& failure) {
      found.Error(recording.name, 0, failure.what());
    }
    if (std::optional<LeftOutRecording> out = LeftOutFor(found, recording.name, {}, section.findings))
      section.misfits.left_out.push_back(*std::move(out));
  }
  return predicted;
}

/// What each force is integrated to, and a warning where that is seen.
void AddIntegration(const BenchDamper& damper, const std::vector<ModelledRecording>& recordings,
                    const std::vector<double>& values, FitSection& section) {
  constexpr double kVisible = 1e-3;
  std::vector<std::pair<std::string, double>>& errors = section.misfits.integration;
  for (const ModelledRecording& modelled : recordings)
    errors.emplace_back(modelled.recording.name, IntegrationError(damper, modelled, values));
  const auto worst =
      std::max_element(errors.begin(), errors.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (worst == errors.end()) return;
  const std::string size = Percent(std::max(1e-6, worst->second), 2) + " of its rms";
  section.text = "halving the step changed no force by more than " + size + '\n';
  if (worst->second > kVisible)
    section.findings.Warning(worst->first, 0,
                             "the force is integrated to " + size + " only: its damper is too stiff for its samples");
}

}  // namespace

FitSection BenchSection(const LoadedStudy& loaded, const FitResult& fit) {
  if (!loaded.bench) return {};
  const BenchDamper damper(loaded.vehicle, loaded.bench->damper);
  const std::vector<ModelledRecording> fitted = ModelledRecordings(damper, loaded.bench->fitted, fit.values);
  FitSection section;
  std::vector<ModelledRecording> all = Predicted(damper, loaded.bench->validation, fit.values, section);
  section.misfits.histories = BenchMisfits(fitted);
  section.misfits.validation = BenchMisfits(all);
  section.misfits.shares = ErrorShares(section.misfits.histories);
  section.misfits.criteria =
      CriteriaOf(fit.data_squares, static_cast<std::size_t>(fit.residual_count - fit.prior_count), loaded.free.size());
  TextTable table({"recording", "", "NMSE, %", "VAF, %"});
  AddRows(section.misfits.histories, "fitted", table);
  AddRows(section.misfits.validation, "validation", table);
  std::vector<ModelledRecording> shown = fitted;
  shown.insert(shown.end(), all.begin(), all.end());
  AddIntegration(damper, shown, fit.values, section);
  section.text = table.Format() + section.text + CriteriaText(*section.misfits.criteria) + '\n';

  all.insert(all.begin(), fitted.begin(), fitted.end());
  const std::string& title = loaded.vehicle.name;
  section.files = {{"bench.csv", BenchCsv(all)},
                   {"cycles.csv", CyclesCsv(all)},
                   {"diagrams.svg", DiagramSvg(title + ": work and characteristic diagrams", all)},
                   {"frequency.svg", FrequencySvg(title + ": force, speed and frequency", fitted)},
                   {"equivalent.svg", EquivalentSvg(title + ": linear equivalents of every cycle", fitted)}};
  std::string elements;
  for (const Damper& one : damper.dampers()) elements += DamperText(loaded.vehicle, one.name, fit.values);
  if (!elements.empty()) section.files.emplace_back("damper.xml", kPasteNote + elements);
  return section;
}

}  // namespace fourpost
