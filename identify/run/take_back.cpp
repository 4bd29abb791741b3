#include "identify/run/take_back.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/output_folder.h"
#include "identify/refine/refine.h"
#include "identify/run/remade_study.h"
#include "identify/run/study_fit.h"
#include "identify/study/loaded_study.h"
#include "identify/study_file/result_reader.h"
#include "identify/suggest/score_test.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

/// Those that the run fitted.
std::map<std::string, double> FittedValues(const fs::path& run) {
  std::map<std::string, double> values;
  for (const nlohmann::json& one : ListAt(ReadResultFile(run / "result.json"), "parameters"))
    if (const double value = NumberAt(one, "value"); std::isfinite(value)) values[TextAt(one, "name")] = value;
  return values;
}

class TakeBackSearch {
 public:
  TakeBackSearch(const GrowthOrigin& origin, const GrowthPath& path, const WorkHooks& hooks)
      : origin_(origin),
        path_(path),
        hooks_(hooks),
        last_(path.steps[path.LastKept()]),
        standing_(path.Standing()),
        values_(FittedValues(origin.RunOf(last_))) {}

  std::optional<GrowthRound> Run() {
    for (const std::size_t place : standing_) {
      // The newest was judged against the fit before it; a scale that was added again is one with the first.
      const std::vector<std::size_t> alike = Alike(place);
      if (place != alike.front() || alike == std::vector{path_.LastKept()}) continue;
      hooks_.Show("what can be taken back: " + path_.steps[place].addition.words);
      Look(place);
      if (hooks_.IsStopped()) return std::nullopt;
    }
    return Best();
  }

 private:
  struct Found {
    GrowthCandidate candidate;
    double criterion = 0;
  };

  void Look(std::size_t place) {
    const GrowthStep& step = path_.steps[place];
    Found found{.candidate = {.addition = step.addition,
                              .takes_back = step.folder,
                              .folder = FolderOf(place),
                              .effective = last_.effective}};
    found.candidate.addition.count *= static_cast<int>(Alike(place).size());
    // What was reached is not lost where something cannot be taken back.
    try {
      const fs::path folder = origin_.output / found.candidate.folder;
      if (!RemakeStudy({origin_.study, origin_.set, Others(place), values_}, folder)) return;
      const std::optional<double> cost = CostOf(folder / "study.yaml");
      if (!cost) return;
      found.criterion = TakeBackChange(last_, *cost, found.candidate.addition);
      found_.push_back(std::move(found));
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& failure) {
      hooks_.Note("'" + step.addition.words + "' cannot be taken back: " + failure.what());
    }
  }

  /// Of its own: which of them become steps is not known yet.
  std::string FolderOf(std::size_t place) const {
    return GrowthFolder(path_.steps.size()) + "_without_" + std::to_string(place);
  }

  const std::string& WordsOf(std::size_t place) const { return path_.steps[place].addition.words; }

  /// Places where the same was added.
  std::vector<std::size_t> Alike(std::size_t place) const {
    std::vector<std::size_t> alike;
    for (const std::size_t other : standing_)
      if (WordsOf(other) == WordsOf(place)) alike.push_back(other);
    return alike;
  }

  std::vector<GrowthAddition> Others(std::size_t place) const {
    std::vector<GrowthAddition> others;
    for (const std::size_t other : standing_)
      if (WordsOf(other) != WordsOf(place)) others.push_back(path_.steps[other].addition);
    return others;
  }

  /// Evaluated truly, so that it is never below the least.
  std::optional<double> CostOf(const fs::path& file) const {
    constexpr int kIterations = 4;
    LoadedStudy study = LoadSoundStudy(file);
    study.Prepare(hooks_);
    if (!study.CorrectAt(study.MakeObjective().FileValues(), hooks_)) return std::nullopt;
    const VehicleObjective objective = study.MakeObjective();
    Archive archive(objective.MakeProblem(), origin_.threads);
    RefineOptions options = FitOptionsOf(study.study, objective).refine;
    options.max_iterations = kIterations;
    const RefineResult refined = Refine(archive, objective.FileValues(), options, hooks_.stop);
    if (!refined.has_cost() || hooks_.IsStopped()) return std::nullopt;
    return refined.cost;
  }

  GrowthRound Best() {
    // The few steps may end somewhat above the least cost.
    constexpr double kNearly = 10;
    constexpr std::size_t kMost = 3;
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Found& a, const Found& b) { return a.criterion < b.criterion; });
    GrowthRound round{.residuals = last_.residuals, .tried = last_.tried, .first = path_.steps.size()};
    for (const Found& one : found_) {
      if (one.criterion < kNearly && round.candidates.size() < kMost) round.candidates.push_back(one.candidate);
      else {
        std::error_code ignored;
        fs::remove_all(origin_.output / one.candidate.folder, ignored);
      }
    }
    return round;
  }

  const GrowthOrigin& origin_;
  const GrowthPath& path_;
  const WorkHooks& hooks_;
  const GrowthStep& last_;
  std::vector<std::size_t> standing_;
  std::map<std::string, double> values_;
  std::vector<Found> found_;
};

}  // namespace

double TakeBackChange(const GrowthStep& with, double cost_without, const GrowthAddition& addition) {
  return -CriterionChange(cost_without, with.cost, with.residuals, with.effective, addition.count, with.tried,
                          addition.choices);
}

std::optional<GrowthRound> FindTakeBacks(const GrowthOrigin& origin, const GrowthPath& path, const WorkHooks& hooks) {
  return TakeBackSearch(origin, path, hooks).Run();
}

}  // namespace fourpost
