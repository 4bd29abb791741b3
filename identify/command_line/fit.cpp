#include <cmath>
#include <cstdio>

#include "analysis/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/text_table.h"
#include "identify/fit.h"
#include "identify/loaded_study.h"
#include "identify/modelled_response.h"
#include "identify/response_chart.h"
#include "identify/result_json.h"
#include "vehicles/vehicle_file.h"

namespace fourpost {
namespace {

FitOptions OptionsOf(const StudySearch& search, const FitCommand& command) {
  FitOptions options;
  options.search = ThesisDvhde();
  options.search.seed = command.seed.value_or(search.seed);
  options.search.max_evaluations = search.evaluations;
  options.search.population = search.population;
  options.search.candidates = search.starts;
  options.starts = search.starts;
  options.threads = command.threads;
  return options;
}

std::string ProgressText(const FitProgress& progress, double seconds) {
  const double rate = static_cast<double>(progress.paid) / std::max(seconds, 1e-3);
  return std::string(progress.stage) + ": " + std::to_string(progress.paid) + " evaluations (" +
         std::to_string(progress.reused) + " reused, " + std::to_string(progress.failed) + " failed), " +
         Rounded(rate, 3) + " per second, best cost " + Rounded(progress.best_cost, 5);
}

FitResult FitWithProgress(const FourPostObjective& objective, const FitOptions& options) {
  CatchInterrupts();
  ProgressLine line;
  FitHooks hooks;
  hooks.progress = [&](const FitProgress& progress) { line.Show(ProgressText(progress, line.seconds())); };
  hooks.stop = Interrupted;
  return Fit(objective, options, hooks);
}

/// In the unit of the vehicle file; as many decimals as the deviation makes sense of.
std::string InUnit(double value, const std::string& unit) {
  return Rounded(value / ParseUnit(unit.empty() ? "1" : unit)->si, 4);
}

std::string ParameterTable(const std::vector<FittedParameter>& parameters) {
  TextTable table({"parameter", "start", "fitted", "sd", "lower", "upper", "unit", ""});
  for (const FittedParameter& p : parameters)
    table.Add({p.name, InUnit(p.start, p.unit), InUnit(p.value, p.unit),
               std::isfinite(p.sd) ? InUnit(p.sd, p.unit) : "undetermined", InUnit(p.lower, p.unit),
               InUnit(p.upper, p.unit), p.unit, p.at_bound ? "at its bound" : ""});
  return table.Format();
}

std::string Summary(const FitResult& fit) {
  const EvaluationCounts& counts = fit.evaluations;
  return "fit " + std::string(FitEndName(fit.end)) + ": cost " + Rounded(fit.cost, 5) + " for " +
         std::to_string(fit.residual_count) + " residuals; " + std::to_string(counts.paid) + " evaluations paid, " +
         std::to_string(counts.reused) + " reused, " + std::to_string(counts.failed()) + " failed; " +
         std::to_string(fit.agreeing) + " of " + std::to_string(fit.starts) + " refinements agree\n";
}

/// What the data say worst, in words.
std::string Weakness(const FourPostObjective& objective, const Covariance& covariance) {
  const Eigen::Index n = covariance.directions.cols();
  if (n == 0) return "";
  const Lattice lattice = objective.MakeProblem().lattice;
  std::string text;
  for (Eigen::Index i = covariance.rank; i < n; ++i)
    text += "undetermined: " + DescribeDirection(lattice, covariance.directions.col(i)) +
            " together change nothing; fix one of them, or measure a force\n";
  if (text.empty())
    text = "least determined (condition " + Rounded(covariance.condition, 2) +
           "): " + DescribeDirection(lattice, covariance.directions.col(n - 1)) + "\n";
  return text;
}

int CodeOf(FitEnd end) {
  switch (end) {
    case FitEnd::kConverged: return kGood;
    case FitEnd::kAllFailed: return kAllSimulationsFailed;
    case FitEnd::kInterrupted: return kInterrupted;
    case FitEnd::kNotRun:
    case FitEnd::kNotConverged: return kNotGood;
  }
  return kNotGood;
}

}  // namespace

int Run(const FitCommand& command) {
  Diagnostics diagnostics;
  const std::optional<LoadedStudy> loaded = LoadStudy(command.study, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  if (!diagnostics.items().empty()) std::fprintf(stderr, "%s\n", diagnostics.Format().c_str());
  const FourPostObjective objective = loaded->MakeObjective();
  OutputFolder output(command.output);

  const FitOptions options = OptionsOf(loaded->study.search, command);
  const FitResult fit = FitWithProgress(objective, options);
  if (fit.parameters.empty()) {
    std::fprintf(stderr, "fit %s: %s nothing is written\n", std::string(FitEndName(fit.end)).c_str(),
                 fit.message.c_str());
    return CodeOf(fit.end);
  }

  const Study& study = loaded->study;
  const CondensedModel model = objective.condensed().At(fit.values);
  const std::vector<MeasuredRun>& runs = loaded->data.runs;
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, loaded->vehicle.sensors, runs);
  const std::vector<MeasuredRun> in_band = InBand(runs, study.band_lower_Hz, study.band_upper_Hz);
  const std::vector<ChannelMisfit> misfits =
      Misfits(in_band, ModelledResponses(model, loaded->vehicle.sensors, in_band));
  const std::string result = ResultJson(*loaded, options.search.seed, fit, misfits);
  output.Add("vehicle.urdf", VehicleTextWithValues(loaded->vehicle, fit.values, command.output));
  output.Add("response.csv", ResponseCsv(runs, modelled, study.band_lower_Hz, study.band_upper_Hz));
  output.Add("response.svg", ResponseSvg(runs, modelled, misfits, study.band_lower_Hz, study.band_upper_Hz));
  output.Add("result.json", result);
  output.Commit();

  const std::string text = ParameterTable(fit.parameters) + '\n' + MisfitTable(misfits) + '\n' + Summary(fit) +
                           Weakness(objective, fit.covariance);
  std::fputs((command.json ? result : text).c_str(), stdout);
  return CodeOf(fit.end);
}

}  // namespace fourpost
