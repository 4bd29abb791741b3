#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// A fit on the way of one that grows, complete and judged.
struct GrowthStep {
  /// "dry friction beside damper 'front'"; empty: the study as it stands.
  std::string added;
  std::string mechanism;
  std::vector<std::string> elements;
  /// Below the output: where the step's study and its fit are.
  std::string folder;
  double cost = 0;
  double misfit = 0;
  /// See CriterionChange(), against the last one kept before; 0 of the first, NaN without a fit.
  double criterion = 0;
  /// Root mean square over the channels of all validation recordings of what is left of them, in per cent; NaN without
  /// such recordings.
  double validation_percent = 0;
  /// Parameters of what was added that ended at their bounds.
  std::vector<std::string> at_bound = {};
  bool is_kept = false;
  /// Why it is not.
  std::string reason = {};
};

/// An addition that is to be tried; its study lies in the folder already.
struct GrowthCandidate {
  /// As of GrowthStep.
  std::string added;
  std::string mechanism;
  std::vector<std::string> elements;
  std::string folder;
  /// For CriterionChange().
  double effective = 0;
  int count = 0;
  /// Names of the parameters that it adds or frees.
  std::vector<std::string> parameters = {};
};

/// What is to be tried upon the last step that was kept, one after the other until one is kept in its turn.
struct GrowthRound {
  std::vector<GrowthCandidate> candidates;
  /// For CriterionChange().
  Eigen::Index residuals = 0;
  std::size_t additions = 0;
};

/// How a fit has grown; `steps/growth.json` of its folder.
struct GrowthPath {
  std::string study;
  /// Digest of all that it depends on.
  std::string state;
  std::vector<GrowthStep> steps;
  /// Nothing before it is known what could be added.
  std::optional<GrowthRound> round;
  /// Why it added no more: "nothing more pays"; empty while it goes on.
  std::string end;
  /// The same request has nothing left to try.
  bool is_over = false;

  /// The place of the last one that was kept. There must be one.
  std::size_t LastKept() const;
  /// Which addition a step is, kept or not: 0 of the study as it stands.
  std::size_t NumberOf(std::size_t place) const;
  /// What was added so far, in words.
  std::vector<std::string> Added() const;
  /// How many of the round have been tried.
  std::size_t TriedOfRound() const { return steps.size() - 1 - LastKept(); }
};

/// How many additions a fit makes at most.
inline constexpr std::size_t kMostAdditions = 12;

std::string GrowthJson(const GrowthPath& path);

/// What the output of an earlier fit of the same state holds, as far as the results of its steps are there. Empty
/// otherwise.
GrowthPath EarlierGrowth(const std::filesystem::path& output, const std::string& state);

}  // namespace fourpost
