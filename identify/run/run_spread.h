#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/uncertainty/other_optima.h"
#include "identify/uncertainty/parameter_spread.h"

namespace fourpost {

/// What result.json of a fit says of its parameters.
struct RunSpread {
  ParameterSpread parameters;
  /// SI units.
  std::vector<std::string> units;
  double cost = 0;
  /// At least 1.
  double inflation = 1;
  /// Whether noise of recorded posts had moved the optimum and was taken back.
  bool is_corrected = false;
  /// "95 %" or "80 to 90 %", of the intervals.
  std::string confidence;
  /// Refinements that converged elsewhere.
  std::vector<EndedStart> others;

  /// Names of parameters without a standard deviation.
  std::vector<std::string> Held() const;
  /// "k, c"
  std::string HeldText() const;
};

/// Throws FaultyInput for a run that has no covariance, or none that can be read.
RunSpread ReadRunSpread(const std::filesystem::path& run);

/// Whether ReadRunSpread() would give one.
bool HasRunSpread(const std::filesystem::path& run);

}  // namespace fourpost
