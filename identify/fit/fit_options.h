#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/refine/search_method_list.h"

namespace fourpost {

struct FitOptions {
  /// How it explores before it refines.
  MethodOptions search = PlainEvolution();
  std::uint64_t seed = 1;
  StopRules stop;
  CandidateRules candidates;
  RefineOptions refine = {.nearness = 0.1};
  /// Distinct good points of the search that are refined, beside the vehicle's own values.
  int starts = 4;
  /// Evaluations at once; 0: one per processor. No influence on the result.
  int threads = 1;
  /// Look first at what the data determine, and end there where they leave something open that is not accepted.
  bool identify_first = false;
  bool accept_unidentified = false;
  /// Free parameters to profile at the end, as their places among the free ones.
  std::vector<Eigen::Index> profiled = {};
  /// Of the free parameters: refine from here alone, without a look before or a search.
  std::optional<Eigen::VectorXd> from = {};
  /// What an evaluation may take [s]; see Problem.
  double deadline_s = std::numeric_limits<double>::infinity();
};

}  // namespace fourpost
