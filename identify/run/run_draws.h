#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/uncertainty/posterior_draws.h"

namespace fourpost {

struct DrawRequest {
  /// The folder of a fit.
  std::filesystem::path run;
  /// The study that it fitted, for costs; empty: none are evaluated.
  std::filesystem::path study = {};
  std::size_t count = 200;
  std::uint64_t seed = 1;
  /// The likelihood alone, in place of all that the intervals allow for.
  bool noise_only = false;
  std::int64_t max_evaluations = 20000;
  /// 0: one per processor.
  int threads = 0;
};

/// An optimum about which draws lie.
struct DrawnOptimum {
  double cost = 0;
  /// Of the evidence.
  double share = 1;
  /// SI.
  Eigen::VectorXd values;
};

/// Draws of the free parameters of a run.
struct RunDraws {
  std::vector<std::string> names;
  /// SI.
  std::vector<std::string> units;
  Eigen::VectorXd fitted;
  /// Of the intervals of the fit.
  std::string confidence;
  /// One row per draw, SI.
  Eigen::MatrixXd values;
  DrawMethod method = DrawMethod::kNormal;
  /// See PosteriorDraws.
  double effective = 0;
  int generations = 0;
  double accepted = 0;
  double remembered = 0;
  std::vector<DrawnOptimum> optima;
  /// Parameters without a standard deviation, which stay at their fitted values.
  std::vector<std::string> held;
  std::int64_t evaluations = 0;
  Diagnostics findings;
};

/// Nothing where it was interrupted. Throws FaultyInput for a run or a study that cannot be used.
std::optional<RunDraws> DrawFromRun(const DrawRequest& request, const WorkHooks& hooks);

}  // namespace fourpost
