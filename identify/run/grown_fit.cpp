#include "identify/run/grown_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/text_table.h"
#include "identify/run/run_suggestions.h"
#include "identify/suggest/score_test.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Of the channels of validation recordings.
double ValidationPercent(const nlohmann::json& result) {
  double squares = 0;
  int count = 0;
  for (const nlohmann::json& channel : result.value("validation", nlohmann::json::array())) {
    if (!channel.contains("nmse_percent") || !channel["nmse_percent"].is_number()) continue;
    squares += channel["nmse_percent"].get<double>() / 100;
    ++count;
  }
  return count > 0 ? 100 * std::sqrt(squares / count) : std::nan("");
}

Json StepJson(const GrowthStep& step) {
  return {{"added", step.added},
          {"mechanism", step.mechanism},
          {"elements", step.elements},
          {"folder", step.folder},
          {"cost", step.cost},
          {"misfit", NumberOrNull(step.misfit)},
          {"criterion_change", step.criterion},
          {"validation_percent", NumberOrNull(step.validation_percent)},
          {"kept", step.is_kept},
          {"reason", step.reason}};
}

class Grower {
 public:
  Grower(const FitRequest& request, const FitRunHooks& hooks) : request_(request), hooks_(hooks) {}

  GrownFit Run() {
    constexpr int kMostSteps = 12;
    // Whatever stands in its way is found before any work.
    OutputFolder(request_.output, kTrace);
    WritePath();
    fs::path study = request_.study;
    GrowthStep first{.folder = FolderOf(0), .is_kept = true};
    grown_.folder = request_.output / first.folder / "fit";
    if (!Fit(study, first)) return std::move(grown_);
    grown_.folder = request_.output;
    grown_.steps.push_back(first);
    WritePath();
    grown_.end = "the limit of " + std::to_string(kMostSteps) + " additions was reached";
    for (int round = 0; round < kMostSteps && !hooks_.work.IsStopped(); ++round) {
      const std::optional<fs::path> next = TryToGrow(study);
      if (!next) break;
      study = *next;
    }
    grown_.is_interrupted = hooks_.work.IsStopped();
    if (grown_.is_interrupted) grown_.end = "interrupted";
    WritePath();
    if (grown_.is_interrupted) hooks_.work.Note("interrupted: the results are those of the last step that was kept");
    Finish(study);
    return std::move(grown_);
  }

 private:
  static constexpr const char* kTrace = "archive.sqlite";

  std::string FolderOf(std::size_t number) const { return "steps/" + std::to_string(number); }

  const GrowthStep& LastKept() const {
    const GrowthStep* last = nullptr;
    for (const GrowthStep& step : grown_.steps)
      if (step.is_kept) last = &step;
    return *last;
  }

  /// False where there is no result.
  bool Fit(const fs::path& study, GrowthStep& step) {
    FitRequest request = request_;
    request.study = study;
    request.output = request_.output / step.folder / "fit";
    request.profile.clear();
    request.name_missing = false;
    request.from_file = !step.added.empty();
    grown_.fit = FitStudy(request, hooks_);
    if (!grown_.fit.is_written || grown_.fit.fit.end == FitEnd::kInterrupted) return false;
    step.cost = grown_.fit.fit.cost;
    step.misfit = grown_.fit.fit.Misfit();
    step.validation_percent = ValidationPercent(nlohmann::json::parse(grown_.fit.json));
    return true;
  }

  /// What was reached is not lost by what comes after it.
  std::optional<fs::path> TryToGrow(const fs::path& study) {
    try {
      return Grow(study);
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& failure) {
      grown_.end = "an addition could not be made";
      hooks_.work.Note(grown_.end + ": " + failure.what());
      return std::nullopt;
    }
  }

  /// The study of the next step that is kept; nothing where none is.
  std::optional<fs::path> Grow(const fs::path& study) {
    constexpr std::size_t kMostTries = 3;
    const GrowthStep before = LastKept();
    grown_.end = "the stated errors explain the residuals";
    if (before.misfit <= 1) return std::nullopt;
    grown_.end = "nothing more pays";
    const RunSuggestions run = SuggestForRun(
        {.run = request_.output / before.folder / "fit", .study = study, .threads = request_.threads}, hooks_.work);
    const Suggestions& suggestions = run.suggestions;
    for (std::size_t k = 0; k < std::min(kMostTries, suggestions.Worthwhile()) && !hooks_.work.IsStopped(); ++k) {
      const SuggestedAddition& one = suggestions.list[k];
      GrowthStep step{.added = one.addition.words,
                      .mechanism = one.addition.mechanism,
                      .elements = one.addition.elements,
                      .folder = FolderOf(grown_.steps.size())};
      const fs::path folder = request_.output / step.folder;
      WriteApplied(run, k + 1, folder);
      hooks_.work.Note("step " + std::to_string(grown_.steps.size()) + ": " + step.added);
      if (!Fit(folder / "study.yaml", step)) return std::nullopt;
      step.criterion = CriterionChange(before.cost, step.cost, suggestions.residuals, one.effective, one.addition.count,
                                       suggestions.tried);
      Judge(before, step);
      grown_.steps.push_back(step);
      WritePath();
      if (step.is_kept) return folder / "study.yaml";
    }
    return std::nullopt;
  }

  static void Judge(const GrowthStep& before, GrowthStep& step) {
    constexpr double kWorse = 1.02;  // of its error; less is chance
    if (!(step.criterion < 0)) step.reason = "the criterion does not fall";
    else if (step.validation_percent > kWorse * before.validation_percent)
      step.reason = "validation recordings are predicted worse";
    step.is_kept = step.reason.empty();
  }

  /// The last fit again, from the evaluations that it made.
  void Finish(const fs::path& study) {
    std::error_code failure;
    fs::copy_file(request_.output / LastKept().folder / "fit" / kTrace, request_.output / kTrace,
                  fs::copy_options::overwrite_existing, failure);
    FitRequest request = request_;
    request.study = study;
    request.from_file = !LastKept().added.empty();
    if (!grown_.is_interrupted) grown_.fit = FitStudy(request, hooks_);
    else grown_.fit = FitStudy(AlreadyFitted(request), {.work = {.note = hooks_.work.note, .find = hooks_.work.find}});
  }

  /// What costs no evaluation, so that nothing stops it.
  static FitRequest AlreadyFitted(FitRequest request) {
    request.name_missing = false;
    request.profile.clear();
    return request;
  }

  void WritePath() const {
    Json steps = Json::array();
    for (const GrowthStep& step : grown_.steps) steps.push_back(StepJson(step));
    OutputFolder output(request_.output / "steps", "", "growth.json");
    output.Add("growth.json", JsonText(Json{{"study", request_.study.filename().string()},
                                            {"steps", steps},
                                            {"end", grown_.end.empty() ? Json() : Json(grown_.end)}}));
    output.Commit();
  }

  const FitRequest& request_;
  const FitRunHooks& hooks_;
  GrownFit grown_;
};

}  // namespace

GrownFit GrowFit(const FitRequest& request, const FitRunHooks& hooks) { return Grower(request, hooks).Run(); }

}  // namespace fourpost
