#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "analysis/csv_writer.h"
#include "analysis/nearest.h"
#include "analysis/number.h"
#include "analysis/output_folder.h"
#include "analysis/text_file.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/fit_section.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/text_table.h"
#include "identify/fit.h"
#include "identify/loaded_study.h"
#include "identify/profile_chart.h"
#include "identify/recording_lint.h"
#include "identify/report/report_page.h"
#include "identify/result_json.h"
#include "identify/study_context.h"
#include "identify/study_methods.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

/// In the folder of the results, from the first evaluation on.
constexpr const char* kArchive = "archive.sqlite";

/// What a part of an EvaluationContext stands for.
std::string InWords(const std::string& part) {
  if (part == "vehicle") return "the vehicle";
  if (part == "data") return "the recordings, their channels, the static loads, the band or the window";
  if (part == "settings") return "the free parameters, the model error or the deadline";
  return "the version of fourpost";
}

/// Throws FaultyInput when the archive is one of something else.
void RequireSameContext(const FitCommand& command, const EvaluationContext& context) {
  if (!std::filesystem::exists(command.output / kArchive))
    std::fprintf(stderr, "there is no %s to resume from: starting from the beginning\n",
                 (command.output / kArchive).c_str());
  std::string changed;
  for (const std::string& part : ChangedParts(command.output / kArchive, context))
    changed += (changed.empty() ? "" : "; ") + InWords(part);
  if (changed.empty()) return;
  Diagnostics diagnostics;
  diagnostics.Error(command.study.string(), 0,
                    "cannot resume, for what " + (command.output / kArchive).string() +
                        " holds was evaluated with another state of: " + changed +
                        "; undo the change, or leave --resume out to fit anew beside it");
  throw FaultyInput(diagnostics);
}

void TellRestored(const EvaluationCounts& counts, const EvaluationStore& store) {
  if (counts.restored == 0) return;
  std::fprintf(stderr, "%lld of %lld evaluations come from %s\n", static_cast<long long>(counts.restored),
               static_cast<long long>(counts.paid), store.file().c_str());
}

/// Places among the free parameters. Throws FaultyInput.
std::vector<Eigen::Index> Profiled(const VehicleObjective& objective, const std::vector<std::string>& names) {
  std::vector<std::string> legal = {"all"};
  for (const std::size_t index : objective.free()) legal.push_back(objective.vehicle().parameters[index].name);
  Diagnostics diagnostics;
  std::vector<Eigen::Index> profiled;
  for (const std::string& name : names) {
    const auto found = std::find(legal.begin(), legal.end(), name);
    if (found == legal.end())
      diagnostics.Error("--profile", 0, "the study frees no parameter '" + name + "'" + DidYouMean(name, legal));
    else if (found != legal.begin()) profiled.push_back(found - legal.begin() - 1);
    else
      for (std::size_t i = 1; i < legal.size(); ++i) profiled.push_back(static_cast<Eigen::Index>(i) - 1);
  }
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return profiled;
}

FitOptions OptionsOf(const Study& study, const VehicleObjective& objective, const FitCommand& command) {
  const StudySearch& search = study.search;
  FitOptions options;
  Diagnostics diagnostics;
  options.search = ExplorationOf(study, objective.MakeProblem(), diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  options.seed = command.seed.value_or(search.seed);
  options.stop.max_evaluations = search.evaluations.value_or(100);
  options.stop.max_generations = search.generations;
  options.stop.max_stagnant_generations = search.stagnation;
  options.stop.max_seconds = search.time_s;
  options.candidates.count = search.starts;
  options.starts = search.starts;
  options.threads = command.threads;
  options.identify_first = true;
  options.accept_unidentified = command.accept_unidentified;
  options.profiled = Profiled(objective, command.profile);
  options.deadline_s = search.deadline_s;
  options.refine.differences = Differences::kAutomatic;
  const LossKind loss = study.refine.loss;
  options.refine.loss = RobustLoss(loss, study.refine.scale.value_or(UsualScale(loss)), objective.prior_count());
  return options;
}

std::string ProgressText(const FitProgress& progress, std::int64_t search_evaluations, double seconds) {
  const std::int64_t computed = progress.paid - progress.restored;
  const double rate = static_cast<double>(computed) / std::max(seconds, 1e-3);
  std::string text = std::string(progress.stage) + ": ";
  std::string left;
  if (progress.stage == "search") {
    // The last generation is not cut short.
    const std::int64_t of_search = std::min(progress.in_stage, search_evaluations);
    text += std::to_string(of_search) + " of " + std::to_string(search_evaluations) + " evaluations, ";
    if (computed > 0)
      left = TimeLeft(static_cast<double>(of_search) / static_cast<double>(search_evaluations), seconds);
  }
  return text + std::to_string(progress.paid) + " evaluations in all (" + std::to_string(progress.reused) +
         " reused, " + std::to_string(progress.failed) + " failed, " + std::to_string(progress.restored) +
         " from the archive), " + Rounded(rate, 3) + " per second, best cost " + Rounded(progress.best_cost, 5) +
         (left.empty() ? "" : left + " of the search");
}

FitResult FitWithProgress(const VehicleObjective& objective, const FitOptions& options, EvaluationStore& store) {
  CatchInterrupts();
  ProgressLine line;
  FitHooks hooks;
  hooks.progress = [&](const FitProgress& progress) {
    line.Show(ProgressText(progress, options.stop.max_evaluations, line.seconds()));
  };
  hooks.stop = Interrupted;
  return Fit(objective, options, hooks, &store);
}

/// In the unit of the vehicle file, at the digits that deviations of some per mille make sense of.
std::string Shown(double value, const std::string& unit) { return InUnit(value, unit, 4); }

/// The compromise cost has none.
bool TellsDeviations(const LoadedStudy& loaded) {
  return loaded.histories.empty() || loaded.study.history_cost != HistoryCost::kCompromise;
}

std::string Deviation(const FittedParameter& parameter) {
  if (std::isnan(parameter.sd)) return "-";
  return std::isinf(parameter.sd) ? "undetermined" : Shown(parameter.sd, parameter.unit);
}

std::string Interval(const FittedParameter& parameter) {
  if (!std::isfinite(parameter.sd)) return "";
  return Shown(parameter.lower_95, parameter.unit) + " .. " + Shown(parameter.upper_95, parameter.unit);
}

/// What to look at twice.
std::string Remark(const FittedParameter& parameter) {
  // A good prior is this far off in one fit of twenty.
  constexpr double kFar = 2;
  std::string remark = parameter.at_bound ? "at its bound" : "";
  if (const double distance = std::abs(parameter.FromPrior()); distance > kFar)
    remark += (remark.empty() ? "" : ", ") + Rounded(distance, 2) + " sd from prior";
  return remark;
}

std::string ParameterTable(const std::vector<FittedParameter>& parameters) {
  TextTable table({"parameter", "start", "fitted", "sd", "95 %", "lower", "upper", "unit", ""});
  for (const FittedParameter& p : parameters)
    table.Add({p.name, Shown(p.start, p.unit), Shown(p.value, p.unit), Deviation(p), Interval(p),
               Shown(p.lower, p.unit), Shown(p.upper, p.unit), p.unit, Remark(p)});
  return table.Format();
}

std::string ProfileTable(const FitResult& fit) {
  if (fit.profiles.empty()) return "";
  TextTable table({"profile", "fitted", "95 % by deviation", "95 % by profile", "unit", ""});
  for (const Profile& profile : fit.profiles) {
    const FittedParameter& p = *std::find_if(fit.parameters.begin(), fit.parameters.end(),
                                             [&](const FittedParameter& other) { return other.name == profile.name; });
    const auto end = [&](double value) { return std::isfinite(value) ? Shown(value, p.unit) : std::string("open"); };
    const std::string remark = profile.interrupted    ? "interrupted"
                               : profile.found_better ? "went below the fit: not its best optimum"
                                                      : "";
    table.Add({p.name, Shown(p.value, p.unit), Interval(p), end(profile.lower_95) + " .. " + end(profile.upper_95),
               p.unit, remark});
  }
  return table.Format() + '\n';
}

std::string PriorShare(const FitResult& fit) {
  if (fit.prior_count == 0) return "";
  return ", of which priors " + Rounded(fit.prior_cost, 3) + " for " + std::to_string(fit.prior_count);
}

std::string LossWords(const RobustLoss& loss) {
  if (loss.kind() == LossKind::kNone) return "";
  return " by " + std::string(loss.name()) + " beyond " + FormatNumber(loss.scale()) + " sd";
}

std::string Summary(const FitResult& fit) {
  const EvaluationCounts& counts = fit.evaluations;
  return "fit " + std::string(FitEndName(fit.end)) + ": cost " + Rounded(fit.cost, 5) +
         LossWords(fit.options.refine.loss) + " for " + std::to_string(fit.residual_count) + " residuals" +
         PriorShare(fit) + "; " + std::to_string(counts.paid) + " evaluations paid, " + std::to_string(counts.reused) +
         " reused, " + std::to_string(counts.failed()) + " failed; " + std::to_string(fit.agreeing) + " of " +
         std::to_string(fit.starts) + " refinements agree\n" + "search ended by " + fit.search.reason + "\n";
}

/// How large the misfit is, and what the data say worst, in words.
std::string Judgement(const LoadedStudy& loaded, const FitResult& fit) {
  if (!TellsDeviations(loaded))
    return "no deviations: the compromise cost weighs outputs by their own errors, not by noise; 'cost: whitened' has "
           "them\n";
  if (!fit.covariance) return "ended before deviations could be computed\n";
  const Covariance& covariance = *fit.covariance;
  std::string text = "the misfit is " + Rounded(fit.Misfit(), 2) + " times what noise and the stated model error explain\n";
  text +=
      covariance.rank < covariance.directions.cols()
          ? "undetermined: the data do not change when these change together; fix one, give it a prior, or measure a "
            "force:\n"
          : "the data tell least about these changing together (condition " + Rounded(covariance.condition, 2) + "):\n";
  for (const std::string& combination : fit.weakest) text += "  " + combination + "\n";
  return text;
}

/// Throws FaultyInput.
[[noreturn]] void RefuseUnidentified(const LoadedStudy& loaded, const Identifiability& before) {
  Diagnostics diagnostics;
  const Eigen::MatrixXd& directions = before.covariance.directions;
  for (std::size_t i = 0; i < before.weakest.size(); ++i)
    diagnostics.Error(loaded.study.file.string(), loaded.study.free_line,
                      "the data do not change when these change together: " + before.weakest[i] + "; " +
                          RemedyFor(directions.col(before.covariance.rank + static_cast<Eigen::Index>(i))) +
                          "; --accept-unidentified fits all the same");
  throw FaultyInput(diagnostics);
}

void DropDeviations(FitResult& fit) {
  fit.covariance.reset();
  for (FittedParameter& parameter : fit.parameters)
    parameter.sd = parameter.lower_95 = parameter.upper_95 = std::nan("");
}

/// Of a Kalman filter; shows how it gets on.
void EstimateNoise(LoadedStudy& loaded) {
  ProgressLine line;
  loaded.EstimateNoise(
      [&](int runs) { line.Show("noise of the Kalman filter: " + std::to_string(runs) + " runs of it"); });
}

/// Values of the file, as those of parts on their benches, and fitted ones side by side; SI.
std::string ParametersCsv(const Vehicle& vehicle, const std::vector<FittedParameter>& parameters) {
  const auto finite = [](double number) { return std::isfinite(number) ? number : std::nan(""); };
  CsvWriter csv({"parameter", "unit", "start", "fitted", "difference_percent", "sd", "lower_95", "upper_95", "at_bound",
                 "source_of_start"});
  for (const FittedParameter& p : parameters) {
    const auto told = std::find_if(vehicle.parameters.begin(), vehicle.parameters.end(),
                                   [&](const Parameter& parameter) { return parameter.name == p.name; });
    csv.Add(p.name).Add(SiUnit(p.dimension)).Add(p.start).Add(p.value);
    csv.Add(p.start != 0 ? 100 * (p.value - p.start) / p.start : std::nan(""));
    csv.Add(finite(p.sd)).Add(finite(p.lower_95)).Add(finite(p.upper_95));
    csv.Add(p.at_bound ? "yes" : "no").Add(told == vehicle.parameters.end() ? "" : told->source);
  }
  return csv.text();
}

int CodeOf(FitEnd end) {
  switch (end) {
    case FitEnd::kConverged: return kGood;
    case FitEnd::kAllFailed: return kAllSimulationsFailed;
    case FitEnd::kInterrupted: return kInterrupted;
    case FitEnd::kUnidentified: return kUnreadableInput;
    case FitEnd::kNotRun:
    case FitEnd::kNotConverged: return kNotGood;
  }
  return kNotGood;
}

/// The vehicle, its fitted parameters telling where their values come from, without priors.
Vehicle WithSources(const LoadedStudy& loaded, std::uint64_t seed, const FitResult& fit) {
  constexpr std::string_view kFitted = "fitted: ";
  Vehicle vehicle = loaded.vehicle;
  for (std::size_t i = 0; i < loaded.free.size(); ++i) {
    Parameter& parameter = vehicle.parameters[loaded.free[i]];
    const FittedParameter& fitted = fit.parameters[i];
    std::string source = std::string(kFitted) + loaded.study.file.filename().string() + ", seed " +
                         std::to_string(seed) +
                         (std::isnan(fitted.sd) ? "" : ", sd " + Deviation(fitted) + " " + fitted.unit) + "; was " +
                         Shown(fitted.start, fitted.unit) + " " + fitted.unit;
    if (!parameter.source.starts_with(kFitted)) source += ", " + parameter.source;
    parameter.source = source;
    // The data are in the value now: known before them, they would count twice.
    parameter.prior_sd.reset();
  }
  return vehicle;
}

std::string TextOf(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) throw FaultyInput(diagnostics);
  return *text;
}

/// The page that shows what the folder will hold.
std::string Page(const LoadedStudy& loaded, const FitResult& fit, const FitSection& report) {
  Vehicle fitted = loaded.vehicle;
  for (std::size_t i = 0; i < fit.values.size(); ++i) fitted.parameters[i].value = fit.values[i];
  return ReportPage({.files = {report.files.begin(), report.files.end()}, .vehicle = std::move(fitted)});
}

/// What the folder will hold, result.json last, and what is shown.
FitSection Report(const LoadedStudy& loaded, std::uint64_t seed, const FitResult& fit,
                  const std::filesystem::path& folder) {
  FitSection report = loaded.bench ? BenchSection(loaded, fit) : FourPostSection(loaded, fit);
  FitSection histories = HistorySection(loaded, fit);
  report.text += histories.text;
  if (!loaded.bench) report.misfits.validation = std::move(histories.misfits.validation);
  std::move(histories.misfits.histories.begin(), histories.misfits.histories.end(),
            std::back_inserter(report.misfits.histories));
  std::move(histories.files.begin(), histories.files.end(), std::back_inserter(report.files));
  // Predictions of other recordings take from it how they are made.
  report.files.emplace_back("parameters.csv", ParametersCsv(loaded.vehicle, fit.parameters));
  report.files.emplace_back("study.yaml", TextOf(loaded.study.file));
  if (!fit.profiles.empty()) report.files.emplace_back("profile.svg", ProfileSvg(fit));
  report.text =
      ParameterTable(fit.parameters) + '\n' + ProfileTable(fit) + report.text + Summary(fit) + Judgement(loaded, fit);
  report.files.emplace_back("vehicle.urdf", VehicleTextWithValues(WithSources(loaded, seed, fit), fit.values, folder));
  report.files.emplace_back("result.json", ResultJson(loaded, seed, fit, report.misfits));
  return report;
}

}  // namespace

int Run(const FitCommand& command) {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> loaded = LoadStudy(command.study, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  LintRecordings(*loaded, diagnostics);
  Tell(diagnostics);
  EstimateNoise(*loaded);
  const VehicleObjective objective = loaded->MakeObjective();
  RequireInputsElsewhere(InputsOf(*loaded), command.output);
  OutputFolder output(command.output, kArchive);
  const EvaluationContext context = ContextOf(*loaded);
  if (command.resume) RequireSameContext(command, context);
  EvaluationStore store(command.output / kArchive, context);

  const FitOptions options = OptionsOf(loaded->study, objective, command);
  FitResult fit = FitWithProgress(objective, options, store);
  if (!TellsDeviations(*loaded)) DropDeviations(fit);
  TellRestored(fit.evaluations, store);
  if (fit.end == FitEnd::kUnidentified) RefuseUnidentified(*loaded, *fit.before);
  if (fit.parameters.empty()) {
    std::fprintf(stderr, "fit %s: %s no results are written\n", std::string(FitEndName(fit.end)).c_str(),
                 fit.message.c_str());
    return CodeOf(fit.end);
  }
  const FitSection report = Report(*loaded, options.seed, fit, command.output);
  for (const auto& [name, text] : report.files) output.Add(name, text);
  output.Add("report.html", Page(*loaded, fit, report));
  output.Commit();
  std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  Print(command.json ? report.files.back().second : report.text);
  return CodeOf(fit.end);
}

}  // namespace fourpost
