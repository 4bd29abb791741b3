#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/choice/knob.h"

namespace fourpost {

/// What the fit of a bench leaves open of the laws that knobs take from it.
struct BenchDoubt {
  /// Of the folder; as the file states it where another bench has the same.
  std::string name;
  /// "80 to 90 %", of the intervals of that fit.
  std::string confidence;
  std::vector<std::string> knobs;
  /// Of the fit, those that the knobs follow, and one row per possible car, SI.
  std::vector<std::string> parameters;
  Eigen::MatrixXd draws;
};

struct BenchDraws {
  std::vector<BenchDoubt> benches;
  Diagnostics findings;
  bool is_interrupted = false;
};

struct BenchDrawRequest {
  /// Folder of the fitted car. Knobs that follow a fit of the car itself follow its draws; empty: a car without a fit.
  std::filesystem::path car;
  std::size_t count = 100;
  std::uint64_t seed = 1;
  int threads = 0;
};

/// Draws the laws of knobs with `bench` from the intervals of their fits (noise, held parameters and model error), and
/// writes them into Knob::Position::drawn. Knobs of one fit share its draws; fits are independent of each other and of
/// the car. Knobs of the car's own fit follow the car's draws and add no doubt to those. Laws of a fit without a
/// covariance stay as they are, which is a finding at `file`.
BenchDraws DrawBenches(std::vector<Knob>& knobs, const std::filesystem::path& file, const BenchDrawRequest& request,
                       const WorkHooks& hooks);

}  // namespace fourpost
