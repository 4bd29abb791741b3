#include "identify/run/grown_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/output_folder.h"
#include "analysis/files/sha256.h"
#include "identify/run/addition_round.h"
#include "identify/run/growth_judgement.h"
#include "identify/run/result_kind.h"
#include "identify/run/take_back.h"
#include "identify/run/unfinished_growth.h"
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
constexpr const char* kPath = "steps/growth.json";

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
  // They decide which steps are kept.
  for (const FileDigest& file : study->validation_files) state.Add(file.sha256);
  for (const std::string& value : request.set) state.Add(value);
  state.Add(request.seed ? std::to_string(*request.seed) : "of the study");
  state.Add(std::string(request.accept_unidentified ? "unidentified" : "") +
            (request.accept_implausible ? " implausible" : ""));
  return state.Hex();
}

class Grower {
 public:
  Grower(const FitRequest& request, const FitRunHooks& hooks)
      : request_(request), hooks_(hooks), origin_{request.study, request.set, request.output, request.threads} {}

  GrownFit Run() {
    // Whatever stands in its way is found before any work.
    // One that was killed has left its path alone.
    OutputFolder(request_.output, fs::exists(request_.output / kPath) ? kPath : kTrace);
    RequireNoOtherResult(request_.output, ResultKind::kFit);
    TakeUp();
    if (path_.steps.empty() && !FitAsItStands()) return End();
    while (!path_.is_over && !hooks_.work.IsStopped()) path_.end.empty() ? Grow() : TakeBack();
    WritePath();
    grown_.folder = request_.output;
    CopyArchive();
    if (!path_.is_over) Leave(path_.end.empty() ? "whether more is missing" : "what can be taken back");
    else if (!FitOnceMore()) Leave("the last fit with a search");
    return End();
  }

 private:
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
    const GrowthStep& last = path_.steps[path_.LastKept()];
    const std::string what = last.IsOfStudy() ? "" : " (" + WordsOf(last.takes_back, last.addition) + ")";
    hooks_.work.Note(path_.is_over
                         ? "growth had ended: " + path_.end
                         : "growth goes on after step " + std::to_string(path_.NumberOf(path_.LastKept())) + what);
  }

  /// False where it has no result.
  bool FitAsItStands() {
    WritePath();
    hooks_.work.Note("step 0 of at most " + std::to_string(kMostAdditions) + ": the study as it stands");
    GrowthStep first{.folder = GrowthFolder(0), .is_kept = true};
    grown_.folder = request_.output / first.folder / "fit";
    if (!Fit(first)) {
      grown_.is_interrupted = hooks_.work.IsStopped();
      return false;
    }
    Keep(first);
    WritePath();
    return true;
  }

  void Keep(const GrowthStep& step) {
    path_.steps.push_back(step);
    if (step.is_kept) kept_ = grown_.fit;
  }

  /// "taking back dry friction beside damper 'front'"
  static std::string WordsOf(const std::string& takes_back, const GrowthAddition& addition) {
    return (takes_back.empty() ? "" : "taking back ") + addition.words;
  }

  FitRequest RequestOf(const GrowthStep& step) const {
    FitRequest request = request_;
    request.study = origin_.StudyOf(step);
    request.set = origin_.SetOf(step);
    request.resume = request_.resume && step.IsOfStudy();
    request.from_file = !step.IsOfStudy();
    return request;
  }

  /// False where there is no result.
  bool Fit(GrowthStep& step) {
    FitRequest request = RequestOf(step);
    request.output = request_.output / step.folder / "fit";
    request.profile.clear();
    request.name_missing = false;
    // Of a step that is stopped nothing is kept: the user waits for what was reached.
    request.only_whole = !step.IsOfStudy();
    grown_.fit = FitStudy(request, hooks_);
    if (!grown_.fit.is_written || grown_.fit.fit.end == FitEnd::kInterrupted) return false;
    step.cost = grown_.fit.fit.cost;
    step.misfit = grown_.fit.fit.Misfit();
    step.validation_percent = ValidationPercent(nlohmann::json::parse(grown_.fit.json));
    return true;
  }

  /// What was added may still be taken back.
  void EndWith(const std::string& why) {
    path_.end = why;
    path_.round.reset();
    GoBack();
  }

  /// "step 3 of at most 12"; of which some are taken back there may be more.
  std::string StepWords() const {
    const bool is_open = !path_.end.empty() || !path_.TakenBack().empty();
    return "step " + std::to_string(path_.NumberOf(path_.LastKept()) + 1) +
           (is_open ? "" : " of at most " + std::to_string(kMostAdditions));
  }

  /// Tries one addition, or finds out which there are.
  void Grow() {
    const GrowthStep& before = path_.steps[path_.LastKept()];
    if (before.misfit <= 1 && !HasValidation(before)) return EndWith("the stated errors explain the residuals");
    if (path_.Added().size() >= kMostAdditions) return EndWith(LimitWords());
    if (!path_.round) return LookForMore();
    if (path_.TriedOfRound() < path_.round->candidates.size()) return Try();
    if (KeepOneThatStoodBack()) return;
    EndWith(path_.round->candidates.empty() ? "nothing more pays" : "no suggested addition improved the fit");
    WritePath();
  }

  /// What was taken early may have become worthless by what came after it.
  void TakeBack() {
    if (!path_.round) {
      path_.round = FindTakeBacks(origin_, path_, hooks_.work);
      if (path_.round) WritePath();
    } else if (path_.TriedOfRound() < path_.round->candidates.size()) {
      Try();
      // There is room for others again.
      if (!path_.round && path_.end == LimitWords()) path_.end.clear();
    } else {
      path_.is_over = true;
    }
  }

  static std::string LimitWords() {
    return "the limit of " + std::to_string(kMostAdditions) + " additions was reached";
  }

  /// Better than nothing, where no addition of the round holds.
  bool KeepOneThatStoodBack() {
    const std::optional<std::size_t> best = BestThatStoodBack(path_);
    if (!best) return false;
    path_.steps[*best].is_kept = true;
    path_.steps[*best].reason.clear();
    kept_ = {};
    // Those that were refused come before.
    const auto kept = path_.steps.begin() + static_cast<std::ptrdiff_t>(*best);
    std::rotate(kept, kept + 1, path_.steps.end());
    path_.round.reset();
    WritePath();
    return true;
  }

  /// Where a detour did not lead to better predictions, to where it began.
  void GoBack() {
    const std::size_t best = BestPredicted(path_);
    if (best == path_.LastKept()) return;
    for (std::size_t i = best + 1; i < path_.steps.size(); ++i) {
      if (!path_.steps[i].is_kept) continue;
      path_.steps[i].is_kept = false;
      path_.steps[i].reason = "validation recordings are predicted better without it";
    }
    kept_ = {};
  }

  /// What was reached is not lost by what comes after it.
  void LookForMore() {
    WorkHooks hooks = hooks_.work;
    hooks.show = [this](const std::string& text) { hooks_.work.Show(StepWords() + ", " + text); };
    try {
      path_.round = FindAdditions(origin_, path_, hooks);
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& failure) {
      EndWith("what could be added cannot be looked for");
      is_end_written_ = false;
      hooks_.work.Note(path_.end + ": " + failure.what());
    }
    WritePath();
  }

  /// The next of the round.
  void Try() {
    const GrowthStep before = path_.steps[path_.LastKept()];
    const std::size_t place = path_.TriedOfRound();
    const GrowthCandidate one = path_.round->candidates[place];
    GrowthStep step{.addition = one.addition,
                    .takes_back = one.takes_back,
                    .folder = one.folder,
                    .effective = one.effective,
                    .residuals = path_.round->residuals,
                    .tried = path_.round->tried};
    hooks_.work.Note(StepWords() + (one.takes_back.empty() ? ", addition " : ", ") + std::to_string(place + 1) +
                     " of " + std::to_string(path_.round->candidates.size()) + ": " +
                     WordsOf(one.takes_back, one.addition));
    if (!FitOrRefuse(step)) return;
    if (step.reason.empty() && !one.takes_back.empty()) {
      step.criterion = TakeBackChange(before, step.cost, one.addition);
      Judge(before, step);
    } else if (step.reason.empty()) {
      if (!FitWider(step)) return;
      step.at_bound = AtBound(grown_.fit.fit, one.addition.parameters);
      step.criterion = CriterionChange(before.cost, step.cost, step.residuals, step.effective, one.addition.count,
                                       step.tried, one.addition.choices);
      Judge(before, step);
    }
    Keep(step);
    if (step.is_kept) path_.round.reset();
    WritePath();
  }

  /// Bounds of what was added are guesses, and no more than guesses hold a parameter at them. The step stays as it is
  /// where wider ones bring nothing. False where the user stops it.
  bool FitWider(GrowthStep& step) {
    constexpr int kMostWider = 2;
    const std::string folder = step.folder;
    for (int round = 1; round <= kMostWider; ++round) {
      GrowthStep wider = step;
      wider.folder = folder + "_wider" + std::to_string(round);
      FitRun narrow = grown_.fit;
      try {
        if (!Widen(step, wider.folder)) return true;
        if (!Fit(wider) && hooks_.work.IsStopped()) return false;
        if (wider.cost < step.cost && grown_.fit.is_written) {
          step = wider;
          continue;
        }
      } catch (const OutputError&) {
        throw;
      } catch (const std::exception& failure) {
        hooks_.work.Note(std::string("it cannot be fitted within wider bounds: ") + failure.what());
      }
      grown_.fit = std::move(narrow);
      return true;
    }
    return true;
  }

  /// Writes its study with wider bounds. False where no bound that holds a parameter is a guess.
  bool Widen(const GrowthStep& step, const std::string& folder) const {
    std::vector<BoundReached> reached;
    for (const FittedParameter& one : grown_.fit.fit.parameters)
      if (one.at_bound) reached.push_back({one.name, std::string(one.BoundName())});
    if (reached.empty()) return false;
    const LoadedStudy study = LoadSoundStudy(origin_.StudyOf(step));
    // From where it came to, so that it ends no higher; priors stay where they are.
    std::vector<double> values = grown_.fit.fit.values;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (study.vehicle.HasPrior(i)) values[i] = study.vehicle.parameters[i].value;
    const std::string fitted = VehicleTextWithValues(study.vehicle, values, request_.output / folder);
    const std::optional<std::string> vehicle = WithWiderBounds(fitted, reached);
    if (!vehicle) return false;
    OutputFolder output(request_.output / folder, "", "study.yaml");
    output.Add("vehicle.urdf", *vehicle);
    // Beside the other, so that it names the same files.
    output.Add("study.yaml", study.study.text);
    output.Commit();
    return true;
  }

  /// False where the user stops it.
  bool FitOrRefuse(GrowthStep& step) {
    try {
      if (Fit(step)) return true;
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

  /// One that is there has the last search, as far as it came, or another's evaluations.
  void CopyArchive() const {
    const GrowthStep& last = path_.steps[path_.LastKept()];
    std::error_code failure;
    if (!fs::exists(request_.output / kTrace))
      fs::copy_file(request_.output / last.folder / "fit" / kTrace, request_.output / kTrace, failure);
  }

  /// The last fit again, from the evaluations that it made, with a search: the steps went on from one point. False
  /// where the user stops it.
  bool FitOnceMore() {
    FitRequest request = RequestOf(path_.steps[path_.LastKept()]);
    request.growth = SummaryOf(path_, "");
    request.only_whole = true;
    request.from_file = false;
    // The user's own: each step starts where the one before ended.
    request.starts = StartsOf(origin_, path_);
    // Its steps were not asked either.
    request.accept_unidentified = true;
    hooks_.work.Note("the last step that was kept is fitted once more, with a search");
    grown_.fit = FitStudy(request, hooks_);
    return grown_.fit.is_written;
  }

  /// Writes what was reached before the user's stop, at once.
  void Leave(const std::string& not_done) {
    grown_.is_interrupted = true;
    // Better than that is what the same growth wrote when it had ended.
    if (path_.is_over && HasThisResult()) return;
    hooks_.work.Note("interrupted: the results are those of the last step that was kept; not done: " + not_done);
    const GrowthStep& last = path_.steps[path_.LastKept()];
    grown_.fit = WriteUnfinishedGrowth(request_.output / last.folder / "fit", request_.output,
                                       SummaryOf(path_, not_done), std::move(kept_));
  }

  /// Whether the output holds the result of the same growth, ended.
  bool HasThisResult() const {
    const nlohmann::json result = ReadResultFile(request_.output / "result.json");
    if (!result.is_object() || !result.contains("growth")) return false;
    const nlohmann::json& growth = result["growth"];
    return growth.is_object() && TextAt(growth, "state") == path_.state && !growth.value("interrupted", true);
  }

  void WritePath() const {
    OutputFolder output(request_.output / "steps", "", "growth.json");
    GrowthPath path = path_;
    // The same command tries again.
    if (!is_end_written_) {
      path.end.clear();
      path.round.reset();
      path.is_over = false;
    }
    output.Add("growth.json", GrowthJson(path));
    output.Commit();
  }

  const FitRequest& request_;
  const FitRunHooks& hooks_;
  GrowthOrigin origin_;
  GrowthPath path_;
  bool is_end_written_ = true;
  GrownFit grown_;
  /// Of the last step that was kept; empty where an earlier run fitted it.
  FitRun kept_;
};

}  // namespace

GrownFit GrowFit(const FitRequest& request, const FitRunHooks& hooks) { return Grower(request, hooks).Run(); }

}  // namespace fourpost
