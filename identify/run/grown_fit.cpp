#include "identify/run/grown_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/output_folder.h"
#include "analysis/files/sha256.h"
#include "identify/run/result_kind.h"
#include "identify/run/run_suggestions.h"
#include "identify/study/loaded_study.h"
#include "identify/study/study_context.h"
#include "identify/study_file/result_reader.h"
#include "identify/suggest/score_test.h"
#include "identify/suggest/wider_bounds.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrace = "archive.sqlite";

/// Of the channels of validation recordings.
double ValidationPercent(const nlohmann::json& result) {
  double squares = 0;
  int count = 0;
  for (const nlohmann::json& channel : ListAt(result, "validation")) {
    const double percent = NumberAt(channel, "nmse_percent");
    if (!std::isfinite(percent)) continue;
    squares += percent / 100;
    ++count;
  }
  return count > 0 ? 100 * std::sqrt(squares / count) : std::nan("");
}

/// Of all that decides how a fit grows; empty of a request that FitStudy() refuses.
std::string StateOf(const FitRequest& request) {
  Diagnostics refused;
  const std::optional<LoadedStudy> study = LoadStudy(request.study, refused, request.set);
  if (!study) return "";
  const EvaluationContext context = ContextOf(*study);
  Sha256 state;
  for (const std::string& part : {context.vehicle, context.data, context.settings, context.version}) state.Add(part);
  state.Add(study->vehicle.text);
  state.Add(study->study.text);
  for (const std::string& value : request.set) state.Add(value);
  state.Add(request.seed ? std::to_string(*request.seed) : "of the study");
  state.Add(std::string(request.accept_unidentified ? "unidentified" : "") +
            (request.accept_implausible ? " implausible" : ""));
  return state.Hex();
}

/// Of these parameters.
std::vector<std::string> AtBound(const FitResult& fit, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const FittedParameter& one : fit.parameters)
    if (one.at_bound && std::find(names.begin(), names.end(), one.name) != names.end()) found.push_back(one.name);
  return found;
}

void Judge(const GrowthStep& before, GrowthStep& step) {
  constexpr double kWorse = 1.02;  // of its error; less is chance
  if (!(step.criterion < 0)) step.reason = "the criterion does not fall";
  else if (!step.at_bound.empty()) step.reason = "its " + step.at_bound.front() + " ends at a bound";
  else if (step.validation_percent > kWorse * before.validation_percent)
    step.reason = "validation recordings are predicted worse";
  step.is_kept = step.reason.empty();
}

class Grower {
 public:
  Grower(const FitRequest& request, const FitRunHooks& hooks) : request_(request), hooks_(hooks) {}

  GrownFit Run() {
    // Whatever stands in its way is found before any work.
    OutputFolder(request_.output, kTrace);
    RequireNoOtherResult(request_.output, ResultKind::kFit);
    TakeUp();
    if (path_.steps.empty() && !FitAsItStands()) return End();
    while (!path_.is_over && !hooks_.work.IsStopped()) Grow();
    if (!path_.is_over) path_.end = "interrupted";
    grown_.is_interrupted = !path_.is_over;
    WritePath();
    grown_.folder = request_.output;
    if (grown_.is_interrupted) hooks_.work.Note("interrupted: the results are those of the last step that was kept");
    Finish();
    return End();
  }

 private:
  static std::string FolderOf(std::size_t number) { return "steps/" + std::to_string(number); }

  GrownFit End() {
    grown_.path = std::move(path_);
    return std::move(grown_);
  }

  /// What the same request has reached before.
  void TakeUp() {
    const std::string state = StateOf(request_);
    if (!state.empty()) path_ = EarlierGrowth(request_.output, state);
    path_.study = request_.study.filename().string();
    path_.state = state;
    if (path_.steps.empty()) return;
    if (hooks_.begin) hooks_.begin();
    const std::vector<std::string> added = path_.Added();
    const std::string last = added.empty() ? "" : " (" + added.back() + ")";
    hooks_.work.Note(path_.is_over ? "growth had ended: " + path_.end
                                   : "growth goes on after step " + std::to_string(added.size()) + last);
  }

  /// False where it has no result.
  bool FitAsItStands() {
    WritePath();
    hooks_.work.Note("step 0 of at most " + std::to_string(kMostAdditions) + ": the study as it stands");
    GrowthStep first{.folder = FolderOf(0), .is_kept = true};
    grown_.folder = request_.output / first.folder / "fit";
    if (!Fit(request_.study, first)) {
      path_.end = "interrupted";
      grown_.is_interrupted = hooks_.work.IsStopped();
      return false;
    }
    path_.steps.push_back(first);
    WritePath();
    return true;
  }

  fs::path StudyOf(const GrowthStep& step) const {
    return step.added.empty() ? request_.study : request_.output / step.folder / "study.yaml";
  }

  /// Its file of the vehicle has the values that were set.
  std::vector<std::string> SetOf(const GrowthStep& step) const {
    return step.added.empty() ? request_.set : std::vector<std::string>();
  }

  FitRequest RequestOf(const GrowthStep& step) const {
    FitRequest request = request_;
    request.study = StudyOf(step);
    request.set = SetOf(step);
    request.resume = request_.resume && step.added.empty();
    request.from_file = !step.added.empty();
    return request;
  }

  /// False where there is no result.
  bool Fit(const fs::path& study, GrowthStep& step) {
    FitRequest request = RequestOf(step);
    request.study = study;
    request.output = request_.output / step.folder / "fit";
    request.profile.clear();
    request.name_missing = false;
    grown_.fit = FitStudy(request, hooks_);
    if (!grown_.fit.is_written || grown_.fit.fit.end == FitEnd::kInterrupted) return false;
    step.cost = grown_.fit.fit.cost;
    step.misfit = grown_.fit.fit.Misfit();
    step.validation_percent = ValidationPercent(nlohmann::json::parse(grown_.fit.json));
    return true;
  }

  void EndWith(const std::string& why) {
    path_.end = why;
    path_.is_over = true;
  }

  /// "step 3 of at most 12"
  std::string StepWords() const {
    return "step " + std::to_string(path_.Added().size() + 1) + " of at most " + std::to_string(kMostAdditions);
  }

  /// Tries one addition, or finds out which there are.
  void Grow() {
    const GrowthStep& before = path_.steps[path_.LastKept()];
    if (before.misfit <= 1) return EndWith("the stated errors explain the residuals");
    if (path_.Added().size() >= kMostAdditions)
      return EndWith("the limit of " + std::to_string(kMostAdditions) + " additions was reached");
    if (!path_.round) return LookForMore();
    if (path_.TriedOfRound() < path_.round->candidates.size()) return Try();
    if (KeepOneAtItsBound()) return;
    EndWith(path_.round->candidates.empty() ? "nothing more pays" : "no suggested addition improved the fit");
  }

  /// An addition that the data push to the end of what it may be is not what they show, and stands back behind others;
  /// where there are none it is better than nothing.
  bool KeepOneAtItsBound() {
    const auto first = path_.steps.begin() + static_cast<std::ptrdiff_t>(path_.LastKept() + 1);
    GrowthStep* best = nullptr;
    for (auto step = first; step != path_.steps.end(); ++step) {
      GrowthStep judged = *step;
      judged.at_bound.clear();
      judged.reason.clear();
      if (step->at_bound.empty()) continue;
      Judge(path_.steps[path_.LastKept()], judged);
      if (judged.is_kept && (!best || step->criterion < best->criterion)) best = &*step;
    }
    if (!best) return false;
    best->is_kept = true;
    best->reason.clear();
    // Those that were refused come before.
    std::rotate(path_.steps.begin() + (best - path_.steps.data()),
                path_.steps.begin() + (best - path_.steps.data()) + 1, path_.steps.end());
    path_.round.reset();
    WritePath();
    return true;
  }

  /// What was reached is not lost by what comes after it.
  void LookForMore() {
    try {
      path_.round = NextRound();
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& failure) {
      EndWith("what could be added cannot be looked for");
      hooks_.work.Note(path_.end + ": " + failure.what());
      // Not for good: the same command looks again.
      return;
    }
    WritePath();
  }

  /// Nothing where the user stops it.
  std::optional<GrowthRound> NextRound() const {
    constexpr std::size_t kMostTries = 3;
    const GrowthStep& before = path_.steps[path_.LastKept()];
    WorkHooks hooks = hooks_.work;
    hooks.show = [this](const std::string& text) { hooks_.work.Show(StepWords() + ", " + text); };
    const RunSuggestions run = SuggestForRun({.run = request_.output / before.folder / "fit",
                                              .study = StudyOf(before),
                                              .set = SetOf(before),
                                              .threads = request_.threads},
                                             hooks);
    const Suggestions& suggestions = run.suggestions;
    if (suggestions.is_interrupted) return std::nullopt;
    GrowthRound round{.residuals = suggestions.residuals, .additions = suggestions.tried};
    for (std::size_t k = 0; k < std::min(kMostTries, suggestions.Worthwhile()); ++k) {
      const SuggestedAddition& one = suggestions.list[k];
      round.candidates.push_back({.added = one.addition.words,
                                  .mechanism = one.addition.mechanism,
                                  .elements = one.addition.elements,
                                  .folder = FolderOf(path_.steps.size() + k),
                                  .effective = one.effective,
                                  .count = one.addition.count,
                                  .parameters = one.addition.parameters});
      WriteApplied(run, k + 1, request_.output / round.candidates.back().folder);
    }
    return round;
  }

  /// The next of the round.
  void Try() {
    const GrowthStep before = path_.steps[path_.LastKept()];
    const std::size_t place = path_.TriedOfRound();
    const GrowthCandidate& one = path_.round->candidates[place];
    GrowthStep step{.added = one.added, .mechanism = one.mechanism, .elements = one.elements, .folder = one.folder};
    hooks_.work.Note(StepWords() + ", addition " + std::to_string(place + 1) + " of " +
                     std::to_string(path_.round->candidates.size()) + ": " + step.added);
    if (!FitOrRefuse(step)) return;
    constexpr int kMostWider = 2;
    for (int round = 0; round < kMostWider && step.reason.empty() && Widen(step); ++round)
      if (!FitOrRefuse(step)) return;
    if (step.reason.empty()) {
      step.at_bound = AtBound(grown_.fit.fit, one.parameters);
      step.criterion = CriterionChange(before.cost, step.cost, path_.round->residuals, one.effective, one.count,
                                       path_.round->additions);
      Judge(before, step);
    }
    path_.steps.push_back(step);
    if (step.is_kept) path_.round.reset();
    WritePath();
  }

  /// Bounds of what was added are guesses, and no more than guesses hold a parameter at them. False where none does.
  bool Widen(const GrowthStep& step) const {
    std::vector<BoundReached> reached;
    for (const FittedParameter& one : grown_.fit.fit.parameters)
      if (one.at_bound) reached.push_back({one.name, std::string(one.BoundName())});
    if (reached.empty()) return false;
    const LoadedStudy study = LoadSoundStudy(StudyOf(step));
    // From where it came to, so that it ends no higher.
    const std::string fitted =
        VehicleTextWithValues(study.vehicle, grown_.fit.fit.values, request_.output / step.folder);
    const std::optional<std::string> vehicle = WithWiderBounds(fitted, reached);
    if (!vehicle) return false;
    OutputFolder output(request_.output / step.folder, "", "study.yaml");
    output.Add("vehicle.urdf", *vehicle);
    output.Add("study.yaml", study.study.text);
    output.Commit();
    return true;
  }

  /// False where the user stops it.
  bool FitOrRefuse(GrowthStep& step) {
    try {
      if (Fit(StudyOf(step), step)) return true;
      if (hooks_.work.IsStopped()) return false;
      step.reason = "it cannot be fitted";
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& failure) {
      step.reason = "it cannot be fitted";
      hooks_.work.Note(step.reason + ": " + failure.what());
    }
    step.cost = step.misfit = step.criterion = step.validation_percent = std::nan("");
    return true;
  }

  /// The last fit again, from the evaluations that it made, with a search: the steps went on from one point.
  void Finish() {
    const GrowthStep& last = path_.steps[path_.LastKept()];
    // One that is there has this search, as far as it came, or another's evaluations.
    std::error_code failure;
    if (!fs::exists(request_.output / kTrace))
      fs::copy_file(request_.output / last.folder / "fit" / kTrace, request_.output / kTrace, failure);
    FitRequest request = RequestOf(last);
    request.growth = GrowthSummary{
        .added = path_.Added(), .end = path_.end, .is_interrupted = grown_.is_interrupted, .state = path_.state};
    if (!grown_.is_interrupted) {
      request.only_whole = true;
      hooks_.work.Note("the last step that was kept is fitted once more, with a search");
      FitRequest searched = request;
      searched.from_file = false;
      // Its steps were not asked either.
      searched.accept_unidentified = true;
      grown_.fit = FitStudy(searched, hooks_);
      if (grown_.fit.is_written || (hooks_.work.IsStopped() && HasThisResult())) return;
    }
    // Stopped before: what is written says so, and is no whole result.
    grown_.is_interrupted = request.growth->is_interrupted = hooks_.work.IsStopped() || grown_.is_interrupted;
    grown_.fit = FitStudy(AlreadyFitted(request), {.work = {.note = hooks_.work.note, .find = hooks_.work.find}});
  }

  /// Whether the output holds the result of the same growth, ended.
  bool HasThisResult() const {
    const nlohmann::json result = ReadResultFile(request_.output / "result.json");
    if (!result.is_object() || !result.contains("growth")) return false;
    const nlohmann::json& growth = result["growth"];
    return growth.is_object() && TextAt(growth, "state") == path_.state && !growth.value("interrupted", true);
  }

  /// What costs no evaluation, so that nothing stops it.
  static FitRequest AlreadyFitted(FitRequest request) {
    request.name_missing = false;
    request.only_whole = false;
    request.profile.clear();
    return request;
  }

  void WritePath() const {
    OutputFolder output(request_.output / "steps", "", "growth.json");
    output.Add("growth.json", GrowthJson(path_));
    output.Commit();
  }

  const FitRequest& request_;
  const FitRunHooks& hooks_;
  GrowthPath path_;
  GrownFit grown_;
};

}  // namespace

GrownFit GrowFit(const FitRequest& request, const FitRunHooks& hooks) { return Grower(request, hooks).Run(); }

}  // namespace fourpost
