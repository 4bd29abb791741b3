#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "identify/fit/fit_options.h"
#include "identify/fit/fit_result.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/search/archive.h"

namespace fourpost {

/// State of a running fit.
struct FitProgress {
  std::string_view stage;
  /// Lowest of all evaluations so far, by the refinement's loss; infinite before the first.
  double best_cost = 0;
  /// Where that is, SI, one per axis of the lattice; both are valid during the call only, and empty before the first.
  const Lattice* lattice = nullptr;
  const Eigen::VectorXd* best = nullptr;
  /// New evaluations; those of a batch that runs count as new until it ends.
  std::int64_t paid = 0;
  /// New evaluations of this stage.
  std::int64_t in_stage = 0;
  /// Evaluations of coarse residuals, which lead refinements; not among the others.
  std::int64_t coarse = 0;
  /// Of parameters to profile, those whose profiles are done.
  std::size_t profiled = 0;
  std::int64_t reused = 0;
  std::int64_t failed = 0;
  /// Of the new ones, those that were read from the archive's file.
  std::int64_t restored = 0;
};

struct FitHooks {
  /// Called by one thread at a time, but not always by the same.
  std::function<void(const FitProgress&)> progress;
  /// True asks the fit to end with what it has.
  std::function<bool()> stop;
};

/// A search over the lattice of the free parameters, then Levenberg-Marquardt from its distinct best points. `store`:
/// where evaluations of this objective are kept, but not those of its coarse one, which a fit that goes on makes again;
/// what it holds shortens the fit and does not change it. Throws OutputError when it cannot be written.
FitResult Fit(const VehicleObjective& objective, const FitOptions& options, const FitHooks& hooks = {},
              EvaluationStore* store = nullptr);

}  // namespace fourpost
