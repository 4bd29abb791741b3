#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "analysis/nearest.h"
#include "analysis/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/fit_progress.h"
#include "identify/command_line/fit_section.h"
#include "identify/command_line/fit_text.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/result_kind.h"
#include "identify/command_line/text_table.h"
#include "identify/fit.h"
#include "identify/fitted_vehicle.h"
#include "identify/full_correction.h"
#include "identify/lint/misfit_lint.h"
#include "identify/lint/recording_lint.h"
#include "identify/loaded_study.h"
#include "identify/profile_chart.h"
#include "identify/report/report_page.h"
#include "identify/result_json.h"
#include "identify/study_context.h"
#include "identify/study_fit.h"
#include "identify/warning_texts.h"
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
  if (std::error_code failure; !std::filesystem::exists(command.output / kArchive, failure))
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

void TellRestored(const EvaluationCounts& counts, const std::filesystem::path& archive) {
  if (counts.restored == 0) return;
  std::fprintf(stderr, "%lld of %lld evaluations come from %s\n", static_cast<long long>(counts.restored),
               static_cast<long long>(counts.paid), archive.c_str());
}

void TellDamaged(std::size_t damaged, const std::filesystem::path& archive) {
  if (damaged == 0) return;
  std::fprintf(stderr, "damaged in %s, evaluated and stored again: %zu evaluation%s\n", archive.c_str(), damaged,
               damaged == 1 ? "" : "s");
}

/// The archive is closed afterwards.
FitResult FitInto(const std::filesystem::path& archive, const EvaluationContext& context,
                  const VehicleObjective& objective, const FitOptions& options) {
  EvaluationStore store(archive, context);
  FitResult fit = FitWithProgress(objective, options, store);
  TellRestored(fit.evaluations, archive);
  TellDamaged(store.damaged(), archive);
  return fit;
}

/// Of the histories of a fit; shows how it gets on.
std::optional<std::vector<HistoryCheck>> Check(const LoadedStudy& loaded, const FitResult& fit) {
  ProgressLine line;
  return CheckHistories(loaded, fit.values, [&line](const std::string& work, double t) {
    line.Show("fit: check of linear kinematics, " + work + " at " + Rounded(t, 3) + " s");
    return !Interrupted();
  });
}

/// Goes on with what the full geometry adds to the reduced model of the histories, until that changes no more. What is
/// known of each history; empty where the fit was cut short.
std::vector<HistoryEngine> GoOnWithFullGeometry(const std::filesystem::path& archive, FitOptions options,
                                                LoadedStudy& loaded, FitResult& fit) {
  constexpr int kMostRounds = 4;
  for (int round = 0;; ++round) {
    if (fit.end == FitEnd::kInterrupted) return {};
    const std::optional<std::vector<HistoryCheck>> checks = Check(loaded, fit);
    if (!checks) {
      fit.end = FitEnd::kInterrupted;
      return {};
    }
    std::vector<HistoryEngine> engines;
    for (const HistoryCheck& check : *checks) engines.push_back(check.by);
    if (!IsCorrectionDue(*checks) || round == kMostRounds) return engines;
    Correct(*checks, loaded);
    const VehicleObjective objective = loaded.MakeObjective();
    options.from.emplace(static_cast<Eigen::Index>(loaded.free.size()));
    for (std::size_t i = 0; i < loaded.free.size(); ++i)
      (*options.from)[static_cast<Eigen::Index>(i)] = fit.values[loaded.free[i]];
    FitResult next = FitInto(archive, ContextOf(loaded), objective, options);
    if (next.parameters.empty() || next.end == FitEnd::kInterrupted) {
      fit.end = FitEnd::kInterrupted;
      return {};
    }
    fit = GoneOn(fit, std::move(next));
  }
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
      diagnostics.Error("--profile", 0, "the study frees no parameter '" + name + "'" + DidYouMeanOrAll(name, legal));
    else if (found != legal.begin()) profiled.push_back(found - legal.begin() - 1);
    else
      for (std::size_t i = 1; i < legal.size(); ++i) profiled.push_back(static_cast<Eigen::Index>(i) - 1);
  }
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return profiled;
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

/// Throws FaultyInput with all findings.
void RequirePlausible(const LoadedStudy& loaded, Diagnostics findings) {
  if (!findings.HasErrors()) return;
  findings.Error(loaded.study.file.string(), 0,
                 "a fit to posts that move otherwise than told is worth nothing; --accept-implausible fits all the "
                 "same");
  throw FaultyInput(findings);
}

FitOptions OptionsOf(const Study& study, const VehicleObjective& objective, const FitCommand& command) {
  FitOptions options = FitOptionsOf(study, objective);
  options.seed = command.seed.value_or(options.seed);
  options.threads = command.threads;
  options.accept_unidentified = command.accept_unidentified;
  options.profiled = Profiled(objective, command.profile);
  return options;
}

/// Of a Kalman filter; shows how it gets on.
void EstimateNoise(LoadedStudy& loaded) {
  ProgressLine line;
  loaded.EstimateNoise([&](int runs) {
    line.Show("noise of the Kalman filter: " + std::to_string(runs) + " runs of it" +
              Rate(runs, line.seconds(), "runs"));
  });
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

void TellAndKeep(const Diagnostics& findings, std::vector<std::string>& warnings) {
  Tell(findings);
  for (std::string& text : WarningTexts(findings)) warnings.push_back(std::move(text));
}

/// Of a fit that was not cut short.
void TellMisfits(const LoadedStudy& loaded, const FitResult& fit, std::vector<std::string>& warnings) {
  if (fit.end == FitEnd::kInterrupted) return;
  Diagnostics diagnostics;
  LintMisfits(loaded, fit, diagnostics);
  TellAndKeep(diagnostics, warnings);
}

/// The page that shows what the folder will hold.
std::string Page(const LoadedStudy& loaded, const FitResult& fit, const FitSection& report) {
  Vehicle fitted = loaded.vehicle;
  for (std::size_t i = 0; i < fit.values.size(); ++i) fitted.parameters[i].value = fit.values[i];
  return ReportPage({.files = {report.files.begin(), report.files.end()}, .vehicle = std::move(fitted)});
}

/// What the folder will hold, result.json last, and what is shown.
FitSection Report(const LoadedStudy& loaded, std::uint64_t seed, const FitResult& fit,
                  const std::vector<HistoryEngine>& engines, std::vector<std::string> warnings,
                  const std::filesystem::path& folder) {
  FitSection report = loaded.bench ? BenchSection(loaded, fit) : FourPostSection(loaded, fit);
  FitSection histories = HistorySection(loaded, fit, engines);
  TellAndKeep(report.findings, warnings);
  TellAndKeep(histories.findings, warnings);
  std::vector<LeftOutRecording>& left_out = report.misfits.left_out;
  left_out.insert(left_out.end(), loaded.left_out.begin(), loaded.left_out.end());
  left_out.insert(left_out.end(), histories.misfits.left_out.begin(), histories.misfits.left_out.end());
  report.text += histories.text;
  if (!loaded.bench) report.misfits.validation = std::move(histories.misfits.validation);
  report.misfits.modelled_by = std::move(histories.misfits.modelled_by);
  std::move(histories.misfits.histories.begin(), histories.misfits.histories.end(),
            std::back_inserter(report.misfits.histories));
  std::move(histories.misfits.shares.begin(), histories.misfits.shares.end(),
            std::back_inserter(report.misfits.shares));
  report.verdict = JudgeFit(fit, report.misfits);
  std::move(histories.files.begin(), histories.files.end(), std::back_inserter(report.files));
  // Predictions of other recordings take from it how they are made.
  report.files.emplace_back("parameters.csv", ParametersCsv(loaded.vehicle, fit.parameters));
  report.files.emplace_back("study.yaml", loaded.study.text);
  if (!fit.profiles.empty()) report.files.emplace_back("profile.svg", ProfileSvg(fit));
  report.text = FitText(loaded, fit, report.verdict, report.text);
  report.files.emplace_back("vehicle.urdf", VehicleTextWithValues(WithSources(loaded, seed, fit), fit.values, folder));
  report.files.emplace_back("result.json", ResultJson(loaded, seed, fit, report.misfits, report.verdict, warnings));
  return report;
}

}  // namespace

int Run(const FitCommand& command) {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> loaded = LoadStudy(command.study, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  LintRecordings(*loaded, diagnostics, command.accept_implausible ? Severity::kWarning : Severity::kError);
  RequirePlausible(*loaded, diagnostics);
  std::vector<std::string> warnings;
  TellAndKeep(diagnostics, warnings);
  EstimateNoise(*loaded);
  const VehicleObjective objective = loaded->MakeObjective();
  const FitOptions options = OptionsOf(loaded->study, objective, command);
  RequireInputsElsewhere(InputsOf(*loaded), command.output);
  RequireNoOtherResult(command.output, ResultKind::kFit);
  // What was begun is ended in order; until here nothing is lost.
  CatchInterrupts();
  OutputFolder output(command.output, kArchive);
  const EvaluationContext context = ContextOf(*loaded);
  if (command.resume) RequireSameContext(command, context);
  FitResult fit = FitInto(command.output / kArchive, context, objective, options);
  if (!loaded->TellsDeviations()) fit.DropDeviations();
  if (fit.end == FitEnd::kUnidentified) {
    output.Withdraw();
    RefuseUnidentified(*loaded, *fit.before);
  }
  if (fit.parameters.empty()) {
    std::fprintf(stderr, "fit %s: %s no results are written%s\n", std::string(FitEndName(fit.end)).c_str(),
                 fit.message.c_str(),
                 fit.end == FitEnd::kInterrupted ? "; the same command goes on from its archive" : "");
    return CodeOf(fit.end);
  }
  const std::vector<HistoryEngine> engines = GoOnWithFullGeometry(command.output / kArchive, options, *loaded, fit);
  if (!loaded->TellsDeviations()) fit.DropDeviations();
  TellMisfits(*loaded, fit, warnings);
  const FitSection report = Report(*loaded, options.seed, fit, engines, warnings, command.output);
  for (const auto& [name, text] : report.files) output.Add(name, text);
  output.Add("report.html", Page(*loaded, fit, report));
  output.Commit();
  std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  Print(command.json ? report.files.back().second : report.text);
  return fit.end == FitEnd::kConverged && !report.verdict.explains() ? kNotGood : CodeOf(fit.end);
}

}  // namespace fourpost
