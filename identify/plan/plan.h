#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/plan/experiment_design.h"
#include "identify/plan/rig_file.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

struct PlanRequest {
  /// The folder of a fit, or a vehicle file, whose parameters are known by their ranges and priors.
  std::filesystem::path run;
  /// What the rig can do; empty: UsualRig().
  std::filesystem::path rig = {};
  /// Takes the place of the file's; nothing: that holds.
  std::optional<double> time_s = {};
  /// 0: one per processor.
  int threads = 0;
};

/// Of a parameter, SI.
struct PlannedParameter {
  std::string name;
  std::string unit;
  double value = 0;
  /// Standard deviations: known before, with the plan, and with the same time shared evenly over all runs.
  double before = 0;
  double after = 0;
  double even = 0;
  /// With as many repeats as may be of everything.
  double best = 0;
  /// What is wanted; 0: nothing.
  double wanted = 0;

  /// Whether even all of them narrow it by less than a tenth.
  bool IsBeyondReach() const { return best > 0.9 * before; }
};

/// One of what could be measured.
struct PlannedRun {
  std::string name;
  double time_s = 0;
  int repeats = 0;
  /// Of `Plan::rig.runs`; a direct measurement has none.
  std::optional<std::size_t> run = {};
};

/// Which recordings to make next, and what is then known.
struct Plan {
  std::string subject;
  bool is_interrupted = false;
  /// Whether what is known before is what the noise of a fit allows.
  bool is_of_fit = false;
  Vehicle vehicle;
  RigFile rig;
  std::vector<PlannedRun> runs;
  std::vector<PlannedParameter> parameters;
  ExperimentDesign design;
  /// Geometric mean, over all parameters, of the standard deviations that evenly shared time gives over those of the
  /// plan.
  double gain_over_even = 1;
  Diagnostics findings;
};

/// Throws FaultyInput for a run, a vehicle or a rig that cannot be used.
Plan MakePlan(const PlanRequest& request, const WorkHooks& hooks);

/// For the terminal.
std::string PlanText(const Plan& plan);

/// See schema/plan.json.
nlohmann::ordered_json PlanJson(const Plan& plan);

/// Names and texts of plan.csv, parameters.csv, and for each run that is chosen the motion of its posts as CSV and as
/// RPC III drive file.
std::vector<std::pair<std::string, std::string>> PlanFiles(const Plan& plan);

}  // namespace fourpost
