#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace fourpost {

/// Something that was added or is to be, such that it can be made again.
struct GrowthAddition {
  /// "dry friction beside damper 'front'"; empty: nothing.
  std::string words;
  std::string mechanism;
  std::vector<std::string> elements;
  /// See Addition.
  int variant = 0;
  double amount = 0;
  int count = 0;
  int choices = 1;
  /// Names of the parameters that it adds or frees.
  std::vector<std::string> parameters = {};
};

/// A fit on the way of one that grows, complete and judged.
struct GrowthStep {
  /// Nothing: the study as it stands.
  GrowthAddition addition;
  /// Folder of the first step that made the addition, where this one takes it back, as often as it was made; empty
  /// where it makes it.
  std::string takes_back = {};
  /// Below the output: where the step's study and its fit are.
  std::string folder;
  double cost = 0;
  double misfit = 0;
  /// See CriterionChange(), against the last one kept before; 0 of the first, NaN without a fit.
  double criterion = 0;
  /// Root mean square over the channels of all validation recordings of what is left of them, in per cent; NaN without
  /// such recordings.
  double validation_percent = 0;
  /// What `criterion` was found with, see CriterionChange().
  double effective = 0;
  Eigen::Index residuals = 0;
  std::size_t tried = 0;
  /// Parameters of what was added that ended at their bounds.
  std::vector<std::string> at_bound = {};
  bool is_kept = false;
  /// Why it is not.
  std::string reason = {};

  bool IsOfStudy() const { return addition.words.empty(); }
};

/// A step that is to be tried; its study lies in the folder already.
struct GrowthCandidate {
  GrowthAddition addition;
  /// As of GrowthStep.
  std::string takes_back = {};
  std::string folder;
  /// For CriterionChange().
  double effective = 0;
};

/// What is to be tried upon the last step that was kept, one after the other until one is kept in its turn.
struct GrowthRound {
  std::vector<GrowthCandidate> candidates;
  /// For CriterionChange().
  Eigen::Index residuals = 0;
  std::size_t tried = 0;
  /// How many steps there were before it.
  std::size_t first = 0;
};

/// How a fit has grown; `steps/growth.json` of its folder.
struct GrowthPath {
  std::string study;
  /// Digest of all that it depends on.
  std::string state;
  std::vector<GrowthStep> steps;
  /// Nothing before it is known what could be added or taken back.
  std::optional<GrowthRound> round;
  /// Why it adds no more: "nothing more pays"; empty while it does.
  std::string end;
  /// Nor is there anything to take back: the same request has nothing left to try.
  bool is_over = false;

  /// The place of the last one that was kept. There must be one.
  std::size_t LastKept() const;
  /// Which step it is, kept or not: 0 of the study as it stands.
  std::size_t NumberOf(std::size_t place) const;
  /// Places of the steps whose additions stand, in order.
  std::vector<std::size_t> Standing() const;
  /// What stands, and what was taken back, in words.
  std::vector<std::string> Added() const;
  std::vector<std::string> TakenBack() const;
  /// The number of the step that takes back what this one added; nothing where it stands or was not kept.
  std::optional<std::size_t> TakenBackBy(std::size_t place) const;
  /// How many of the round have been tried.
  std::size_t TriedOfRound() const { return steps.size() - round->first; }
};

/// What a growth begins with, and where its steps are.
struct GrowthOrigin {
  std::filesystem::path study;
  /// Values of parameters, see FitRequest.
  std::vector<std::string> set;
  std::filesystem::path output;
  /// 0: one per processor.
  int threads = 0;

  std::filesystem::path StudyOf(const GrowthStep& step) const {
    return step.IsOfStudy() ? study : output / step.folder / "study.yaml";
  }
  /// A step's file of the vehicle has the values that were set.
  std::vector<std::string> SetOf(const GrowthStep& step) const {
    return step.IsOfStudy() ? set : std::vector<std::string>();
  }
  std::filesystem::path RunOf(const GrowthStep& step) const { return output / step.folder / "fit"; }
};

/// By name, SI: where the parameters of the study as it stands started. Empty where its result is lost.
std::map<std::string, double> StartsOf(const GrowthOrigin& origin, const GrowthPath& path);

/// Of a step, below the output.
inline std::string GrowthFolder(std::size_t number) { return "steps/" + std::to_string(number); }

/// How many additions a fit makes at most.
inline constexpr std::size_t kMostAdditions = 12;

std::string GrowthJson(const GrowthPath& path);
/// Its steps as results show them.
nlohmann::ordered_json GrowthStepsJson(const GrowthPath& path);

/// What the output of an earlier fit of the same state holds, as far as the results of its steps are there. Empty
/// otherwise.
GrowthPath EarlierGrowth(const std::filesystem::path& output, const std::string& state);

}  // namespace fourpost
