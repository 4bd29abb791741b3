#pragma once

#include <string>
#include <vector>

#include "identify/report/judged_channel.h"
#include "identify/report/run_result.h"

namespace fourpost {

/// What the first look at a fit should find.
struct ReportTiles {
  /// "good", "fair", "poor" or "open".
  std::string verdict;
  /// Residuals over noise and stated model error; NaN: unknown.
  double misfit = 0;
  /// Best first.
  std::vector<JudgedChannel> channels;
  /// Of recordings that were not fitted.
  std::vector<JudgedChannel> unseen;
  std::vector<ReportedParameter> parameters;
};

/// A word and four figures, HTML: the misfit against 1, the worst channel with a link to it, channels that the model
/// predicts, and parameters that are known to a tenth.
std::string TilesHtml(const ReportTiles& tiles);

}  // namespace fourpost
