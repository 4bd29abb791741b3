#include "identify/run/fit_run.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/nearest.h"
#include "identify/fit/fitted_parameters.h"
#include "identify/fit/profile_chart.h"
#include "identify/report/fit_overview.h"
#include "identify/report/report_page.h"
#include "identify/run/findings.h"
#include "identify/run/fit_text.h"
#include "identify/run/fitted_vehicle.h"
#include "identify/run/result_json.h"
#include "identify/run/result_kind.h"
#include "identify/run/study_fit.h"
#include "identify/study/audit_text.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study/findings.h"
#include "identify/study/loaded_study.h"
#include "identify/study/study_audit.h"
#include "identify/study/study_context.h"
#include "identify/suggest/suggestion_json.h"
#include "vehicles/description/moved_points.h"
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

/// Places among the free parameters. Throws FaultyInput.
std::vector<Eigen::Index> Profiled(const VehicleObjective& objective, const std::vector<std::string>& names) {
  std::vector<std::string> legal = {"all"};
  for (const std::size_t index : objective.free()) legal.push_back(objective.vehicle().parameters[index].name);
  Diagnostics diagnostics;
  std::vector<Eigen::Index> profiled;
  for (const std::string& name : names) {
    const auto found = std::find(legal.begin(), legal.end(), name);
    if (found == legal.end())
      diagnostics.Report(kProfileUnknown, Place::Option("--profile"), {name, DidYouMeanOrAll(name, legal)});
    else if (found != legal.begin()) profiled.push_back(found - legal.begin() - 1);
    else
      for (std::size_t i = 1; i < legal.size(); ++i) profiled.push_back(static_cast<Eigen::Index>(i) - 1);
  }
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return profiled;
}

/// Throws FaultyInput with all findings.
void RequirePlausible(const LoadedStudy& loaded, Diagnostics findings) {
  if (!findings.HasErrors()) return;
  findings.Report(kPostsContradictStudy, {loaded.study.file.string()});
  throw FaultyInput(findings);
}

/// Throws FaultyInput.
[[noreturn]] void RefuseUnidentified(const LoadedStudy& loaded, const Identifiability& before) {
  Diagnostics diagnostics;
  const Eigen::MatrixXd& directions = before.covariance.directions;
  for (std::size_t i = 0; i < before.weakest.size(); ++i)
    diagnostics.Report(UnidentifiedAs(directions.col(before.covariance.rank + static_cast<Eigen::Index>(i))),
                       {loaded.study.file.string(), loaded.study.free_line}, {before.weakest[i]});
  throw FaultyInput(diagnostics);
}

/// The page that shows what the folder will hold.
std::string Page(const LoadedStudy& loaded, const FitResult& fit,
                 const std::vector<std::pair<std::string, std::string>>& files) {
  Vehicle fitted = loaded.vehicle;
  for (std::size_t i = 0; i < fit.values.size(); ++i) fitted.parameters[i].value = fit.values[i];
  fitted = WithPointsAt(std::move(fitted), fit.values);
  return ReportPage({.files = {files.begin(), files.end()}, .vehicle = std::move(fitted)}, AllExperimentReports());
}

/// The second fit, which went on from the first: what that one found before, and what both cost.
FitResult GoneOn(const FitResult& first, FitResult second) {
  second.before = first.before;
  second.search = first.search;
  second.search_settings = first.search_settings;
  second.starts = first.starts;
  second.agreeing = first.agreeing;
  std::vector<RefinedStart> refined = first.refined;
  refined.insert(refined.end(), second.refined.begin(), second.refined.end());
  second.refined = std::move(refined);
  second.options = first.options;
  second.evaluations.paid += first.evaluations.paid;
  second.evaluations.reused += first.evaluations.reused;
  second.evaluations.restored += first.evaluations.restored;
  for (const auto& [cause, tally] : first.evaluations.failures) {
    FailureTally& sum = second.evaluations.failures[cause];
    if (sum.count == 0) sum.example = tally.example;
    sum.count += tally.count;
  }
  return second;
}

/// Of the free parameters.
Eigen::VectorXd FreeValues(const LoadedStudy& loaded, const FitResult& fit) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(loaded.free.size()));
  for (std::size_t i = 0; i < loaded.free.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = fit.values[loaded.free[i]];
  return values;
}

/// Of all experiments, under one heading.
std::string UnseenText(const ExperimentResults& results) {
  return results.unseen_text.empty() ? "" : "Not fitted:\n" + results.unseen_text;
}

bool IsLarge(const FitResult& fit) { return fit.Misfit() > kLargeMisfit; }

/// Of additions that explain the residuals together.
std::vector<std::string> WordsTogether(const Suggestions& found) {
  std::vector<std::string> words;
  for (const std::size_t place : found.together) words.push_back(found.list[place].addition.words);
  return words;
}

MissingPhysics WhatIsMissing(const Suggestions& found) {
  return {.names = WordsTogether(found),
          .moved = found.moved_together,
          .residuals = found.left_together,
          .jacobian = found.jacobian};
}

/// By what additions together would move the parameters, in per cent as of SuggestionJson().
nlohmann::ordered_json TogetherJson(const Suggestions& found) {
  nlohmann::ordered_json words = nlohmann::ordered_json::array();
  for (const std::string& one : WordsTogether(found)) words.push_back(one);
  nlohmann::ordered_json moves = nlohmann::ordered_json::array();
  for (const MovedParameter& one : found.moves_together)
    moves.push_back({{"name", one.name}, {"percent", 100 * one.share}});
  return {{"additions", words}, {"moves", moves}};
}

/// What is worth adding, at most three and where the misfit is large; null where that was not looked for.
nlohmann::ordered_json MissingJson(const std::optional<Suggestions>& found, const LoadedStudy& loaded,
                                   const FitResult& fit) {
  constexpr std::size_t kMost = 3;
  if (!found) return nullptr;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; IsLarge(fit) && i < std::min(kMost, found->Worthwhile()); ++i)
    list.push_back(SuggestionJson(found->list[i], i + 1, loaded));
  // The best by BIC, whose numbers `suggest` gives; read by the figure that stands beside them.
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a["fall_percent"].template get<double>() > b["fall_percent"].template get<double>();
  });
  return {{"tried", found->tried}, {"suggestions", list}, {"together", TogetherJson(*found)}};
}

/// One fit from its study to its folder.
class Fitter {
 public:
  Fitter(const FitRequest& request, const FitRunHooks& hooks) : request_(request), hooks_(hooks) {}

  FitRun Run() {
    LoadedStudy loaded = Load();
    loaded.Prepare(hooks_.work);
    const VehicleObjective objective = loaded.MakeObjective();
    FitOptions options = FitOptionsOf(loaded.study, objective);
    options.seed = request_.seed.value_or(options.seed);
    options.threads = request_.threads;
    options.accept_unidentified = request_.accept_unidentified;
    options.profiled = Profiled(objective, request_.profile);
    if (request_.from_file) options.from = objective.FileValues();
    RequireInputsElsewhere(loaded.InputFiles(), request_.output);
    RequireNoOtherResult(request_.output, ResultKind::kFit);
    // What was begun is ended in order; until here nothing is lost.
    if (hooks_.begin) hooks_.begin();
    OutputFolder output(request_.output, kArchive);
    const EvaluationContext context = ContextOf(loaded);
    if (request_.resume) RequireSameContext(context);
    else NoteOtherContext(context);
    FitRun run{.fit = FitInto(context, objective, options)};
    if (run.fit.end == FitEnd::kUnidentified) {
      output.Withdraw();
      RefuseUnidentified(loaded, *run.fit.before);
    }
    Keep(held_);
    if (run.fit.parameters.empty()) return run;
    GoOnWithFullGeometry(options, loaded, run.fit);
    if (!loaded.HasDeviations()) run.fit.DropDeviations();
    CallStarts(request_.starts, run.fit);
    Write(loaded, options.seed, output, run);
    return run;
  }

 private:
  LoadedStudy Load() {
    Diagnostics diagnostics;
    std::optional<LoadedStudy> loaded = LoadStudy(request_.study, diagnostics, request_.set);
    if (!loaded) throw FaultyInput(diagnostics);
    audit_ = CheckRecordings(*loaded, Severity::kError, diagnostics);
    if (request_.accept_implausible) diagnostics = Accepted(diagnostics);
    RequirePlausible(*loaded, diagnostics);
    Diagnostics others;
    for (const Diagnostic& item : diagnostics.items()) (IsAboutScale(item) ? held_ : others).Add(item);
    Keep(others);
    return *std::move(loaded);
  }

  /// Errors as warnings, which the verdict names.
  Diagnostics Accepted(const Diagnostics& found) {
    Diagnostics all;
    for (Diagnostic item : found.items()) {
      if (item.severity == Severity::kError) {
        item.severity = Severity::kWarning;
        accepted_.Add(item);
      }
      all.Add(std::move(item));
    }
    return all;
  }

  /// A fit that ends because nothing sets the scale says so in an error.
  static bool IsAboutScale(const Diagnostic& item) { return item.id == kScaleNotMeasured.id(); }

  void Keep(const Diagnostics& findings) {
    if (hooks_.find) hooks_.find(findings);
    warnings_.Add(findings);
  }

  std::filesystem::path Archive() const { return request_.output / kArchive; }

  /// Throws FaultyInput when the archive is one of something else.
  void RequireSameContext(const EvaluationContext& context) const {
    if (std::error_code failure; !std::filesystem::exists(Archive(), failure))
      hooks_.work.Note("there is no " + Archive().string() + " to resume from: starting from the beginning");
    std::string changed;
    for (const std::string& part : ChangedParts(Archive(), context))
      changed += (changed.empty() ? "" : "; ") + InWords(part);
    if (changed.empty()) return;
    Refuse(kArchiveOfOtherState, {request_.study.string()}, {Archive().string(), changed});
  }

  /// Why nothing of an archive that is there is used.
  void NoteOtherContext(const EvaluationContext& context) const {
    std::string changed;
    for (const std::string& part : ChangedParts(Archive(), context))
      changed += (changed.empty() ? "" : "; ") + InWords(part);
    if (!changed.empty())
      hooks_.work.Note(Archive().string() + " is of another state (" + changed +
                       "): what it holds is not used, and the fit starts from the beginning");
  }

  void NoteSize() const {
    constexpr std::uintmax_t kLarge = 100'000'000;
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(Archive(), failure);
    if (!failure && size > kLarge)
      hooks_.work.Note(Archive().string() + " takes " + std::to_string(size / 1'000'000) +
                       " MB; delete it when the fit need not be resumed");
  }

  /// The archive is closed afterwards.
  FitResult FitInto(const EvaluationContext& context, const VehicleObjective& objective,
                    const FitOptions& options) const {
    EvaluationStore store(Archive(), context);
    FitResult fit = Fit(objective, options, hooks_.fit ? hooks_.fit(options) : FitHooks(), &store);
    const EvaluationCounts& counts = fit.evaluations;
    if (counts.restored > 0)
      hooks_.work.Note(std::to_string(counts.restored) + " of " + std::to_string(counts.paid) +
                       " evaluations come from " + Archive().string());
    NoteSize();
    if (store.damaged() > 0)
      hooks_.work.Note("damaged in " + Archive().string() + ", evaluated and stored again: " +
                       std::to_string(store.damaged()) + " evaluation" + (store.damaged() == 1 ? "" : "s"));
    return fit;
  }

  /// Whether the full geometry asks for another round of any experiment; ends the fit where that was interrupted.
  bool IsCorrectionDue(LoadedStudy& loaded, FitResult& fit) const {
    const Subject subject = loaded.MakeSubject();
    bool is_due = false;
    for (Experiment& experiment : loaded.study.experiments) {
      const Experiment::Geometry geometry = experiment.CheckGeometry(subject, fit.values, hooks_.work);
      if (geometry == Experiment::Geometry::kInterrupted) fit.end = FitEnd::kInterrupted;
      is_due = is_due || geometry == Experiment::Geometry::kCorrectionDue;
    }
    return is_due && fit.end != FitEnd::kInterrupted;
  }

  /// Goes on with what the full geometry adds to the model that was fitted, until that changes no more.
  void GoOnWithFullGeometry(FitOptions options, LoadedStudy& loaded, FitResult& fit) const {
    constexpr int kMostRounds = 4;
    if (fit.end == FitEnd::kInterrupted) return;
    for (int round = 0; fit.end != FitEnd::kInterrupted && IsCorrectionDue(loaded, fit) && round < kMostRounds;
         ++round) {
      for (Experiment& experiment : loaded.study.experiments) experiment.Correct();
      const VehicleObjective objective = loaded.MakeObjective();
      options.from = FreeValues(loaded, fit);
      FitResult next = FitInto(ContextOf(loaded), objective, options);
      if (next.parameters.empty() || next.end == FitEnd::kInterrupted) fit.end = FitEnd::kInterrupted;
      else if (std::isfinite(next.cost)) fit = GoneOn(fit, std::move(next));
      else return EndUncorrected(next.message, fit);
    }
    // Its deviations would be those of linear kinematics.
    if (fit.end == FitEnd::kInterrupted) fit.DropDeviations();
  }

  /// Where the model with what the full geometry adds cannot be evaluated.
  static void EndUncorrected(const std::string& why, FitResult& fit) {
    fit.end = FitEnd::kNotConverged;
    fit.message = why;
    fit.DropDeviations();
  }

  /// What could be added to the vehicle, where there is reason to look.
  std::optional<Suggestions> Missing(const LoadedStudy& loaded, const FitResult& fit) const {
    if (!request_.name_missing || fit.end != FitEnd::kConverged || !loaded.HasDeviations()) return std::nullopt;
    const bool is_contradicted = fit.certainty && fit.certainty->model_error.is_significant;
    if (!IsLarge(fit) && !is_contradicted) return std::nullopt;
    // Additions would imitate that noise.
    if (fit.IsMostlyInputNoise()) return std::nullopt;
    // A fit is not lost by what comes after it.
    try {
      Suggestions found = SuggestFor(loaded, FreeValues(loaded, fit), request_.threads, hooks_.work);
      if (!found.is_interrupted) return found;
      hooks_.work.Note("interrupted while looking for what the vehicle lacks; `fourpost suggest` looks again");
    } catch (const std::exception& failure) {
      hooks_.work.Note(std::string("what the vehicle lacks could not be looked for: ") + failure.what());
    }
    return std::nullopt;
  }

  /// result.json goes last into the folder.
  void Write(const LoadedStudy& loaded, std::uint64_t seed, OutputFolder& output, FitRun& run) {
    std::optional<Suggestions> missing = Missing(loaded, run.fit);
    if (missing) AllowForMissing(loaded.MakeObjective(), WhatIsMissing(*missing), run.fit);
    if (missing && run.fit.certainty && run.fit.certainty->missing.empty()) missing->LeaveOutTogether();
    if (request_.only_whole && hooks_.work.IsStopped()) {
      run.fit.end = FitEnd::kInterrupted;
      run.fit.message = "the earlier results are unchanged;";
      return;
    }
    const FitResult& fit = run.fit;
    const Subject subject = loaded.MakeSubject();
    if (fit.end != FitEnd::kInterrupted) {
      Diagnostics findings;
      for (const Experiment& experiment : loaded.study.experiments) experiment.CheckFit(subject, fit, findings);
      Keep(findings);
    }
    hooks_.work.Show("fit: predictions and the report");
    ExperimentResults results;
    for (const Experiment& experiment : loaded.study.experiments) AddResults(experiment.Results(subject, fit), results);
    Keep(results.findings);
    if (audit_) results.json["audit"] = AuditJson(*audit_);
    run.verdict = JudgeFit(fit, results.shares, accepted_);
    // What channels say against each other no parameters explain, whatever the misfit.
    if (audit_ && fit.end != FitEnd::kInterrupted && !request_.accept_implausible)
      ReportAudit(loaded, *audit_, Severity::kWarning, run.verdict.reasons);
    Diagnostics conclusions = ConclusionsOf(fit, run.verdict, loaded.HasDeviations());
    results.json["missing"] = MissingJson(missing, loaded, fit);
    if (request_.growth) results.json["growth"] = GrownJson(*request_.growth);
    run.json = ResultJson(loaded, seed, fit, results.json, {run.verdict, conclusions, warnings_});
    run.text = FitText(fit, OverviewOf(nlohmann::json::parse(run.json)), run.verdict, conclusions,
                       results.text + UnseenText(results), results.json["missing"]);
    std::vector<std::pair<std::string, std::string>>& files = results.files;
    files.emplace_back("parameters.csv",
                       ParametersCsv(loaded.vehicle, fit.parameters, fit.certainty ? fit.certainty->Confidence() : ""));
    // Predictions of other recordings take from it how they are made.
    files.emplace_back("study.yaml", loaded.study.text);
    if (!fit.profiles.empty()) files.emplace_back("profile.svg", ProfileSvg(fit));
    files.emplace_back("vehicle.urdf",
                       VehicleTextWithValues(WithSources(loaded, seed, fit), fit.values, request_.output));
    files.emplace_back("result.json", run.json);
    for (const auto& [name, text] : files) output.Add(name, text);
    output.Add("report.html", Page(loaded, fit, files));
    output.Commit();
    run.is_written = true;
  }

  const FitRequest& request_;
  const FitRunHooks& hooks_;
  Diagnostics warnings_;
  std::optional<Audit> audit_;
  Diagnostics accepted_;
  /// For the time when the data are known to determine the parameters.
  Diagnostics held_;
};

}  // namespace

FitRun FitStudy(const FitRequest& request, const FitRunHooks& hooks) { return Fitter(request, hooks).Run(); }

}  // namespace fourpost
