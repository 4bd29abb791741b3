#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/report/judged_channel.h"

namespace fourpost {

/// Misfit of a whole fit against the limits of misfit_limits.h: not known, below kSmallMisfit, up to kExplainedMisfit,
/// up to kLargeMisfit, above it.
enum class Explained { kUnknown, kOverstated, kYes, kNearly, kNo };

/// What a fit says of itself, in one table from which the tiles, the summary and the pictures of its page and the text
/// of `fourpost fit` take all their figures (docs/reference.md, "Figures of a fit").
struct FitOverview {
  /// "open": interrupted. Else "poor": it did not converge, or it does not explain its data. Else "fair": the misfit is
  /// above kLargeMisfit; a channel is poor, fitted or kept for validation; parts of the data disagree beyond the stated
  /// model error; implausible values were accepted; or no second refinement agrees. Else "good".
  std::string verdict = "open";
  /// Residuals of the data over their degrees of freedom, as a multiple of noise and stated model error, root mean
  /// square; calibrated where the study states calibrations. NaN: unknown.
  double misfit = 0;
  /// What the sum of squares of the data's residuals is by noise and stated model error alone: their degrees of
  /// freedom, and what noise of recorded inputs adds. The misfit is the root of that sum over it. NaN: unknown.
  double expected_squares = 0;
  Explained explained = Explained::kUnknown;
  bool is_calibrated = false;
  /// Most of what is counted as noise is that of the recorded posts.
  bool is_mostly_post_noise = false;
  /// Best first. The worst channel is the last one of `channels`; its misfit is that over all recordings and the whole
  /// band, its worst place that in which it is largest.
  std::vector<JudgedChannel> channels;
  /// Those of recordings that were not fitted.
  std::vector<JudgedChannel> unseen;
  /// Partitions of the data whose parts ask for different parameters, beyond noise: "octaves"; empty where none does.
  std::vector<std::string> disagree;
  /// Root of the pulls of the parts over what noise lets them be, of each of `disagree`; NaN: unknown.
  std::vector<double> disagreement;
  /// By how much intervals are wider than by noise alone; NaN: unknown.
  double wider_than_by_noise = 0;

  const JudgedChannel* Worst() const { return channels.empty() ? nullptr : &channels.back(); }
  /// Whether noise and the stated model error explain the residuals as a whole: then parts of the data disagree by no
  /// more than that error allows.
  bool IsExplained() const { return explained == Explained::kYes || explained == Explained::kOverstated; }
};

/// The figures of a result.json.
FitOverview OverviewOf(const nlohmann::json& result);

// Sentences, with names between backticks; empty where nothing is known or nothing is to say.

/// "good", "fair", "poor" or "not finished".
std::string VerdictWord(const FitOverview& overview);
/// "Residuals are 2.2 times what noise and the stated model error explain; about 1 is expected."
std::string ResidualSentence(const FitOverview& overview);
/// "Worst channel: `s_strut`, 5.9 times noise and stated model error; largest in `pitch` from 0.5 to 1 Hz (11
/// times there)."
std::string WorstSentence(const FitOverview& overview);
/// "Parts of the data (sensor groups, octaves) ask for different parameters, beyond noise; the intervals allow for
/// that."
std::string DisagreementSentence(const FitOverview& overview);
/// What to do about it; empty where the stated model error allows for it.
std::string AdviceOnDisagreement(const FitOverview& overview);

/// For the scripts of a page: `verdict`, `misfit`, `expected_squares`, `is_calibrated`, and of the `worst` channel
/// `name`, `misfit`, and its `place`, null where there is none.
nlohmann::ordered_json OverviewJson(const FitOverview& overview);

}  // namespace fourpost
