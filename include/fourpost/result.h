#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <fourpost/diagnostics.h>

namespace fourpost::api {

/// A fitted parameter; SI. NaN where there is no standard deviation, see `state`.
struct FittedParameter {
  std::string name;
  std::string unit;
  double start = 0;
  double value = 0;
  double sd = 0;
  /// Ends of the interval, whatever its confidence: 95 %, or 80 to 90 % where the run says so.
  double lower_95 = 0;
  double upper_95 = 0;
  /// "determined", "undetermined", "at_bound", ..., as in result.json (docs/reference.md).
  std::string state;
  bool is_at_bound = false;
};

/// What a fit has found.
struct Result {
  /// "converged", "not_converged", "interrupted".
  std::string termination;
  bool is_converged() const { return termination == "converged"; }
  /// False where the model is no explanation of the data.
  bool explains_data = false;
  /// Sum of squared residuals over their deviations, and their number.
  double cost = 0;
  int residuals = 0;
  std::vector<FittedParameter> parameters;
  std::vector<Finding> warnings;
  /// With report.html, the fitted vehicle.urdf, result.json and curves.
  std::filesystem::path folder;

  /// Throws Error (code `name-unknown`).
  const FittedParameter& At(const std::string& parameter) const;
};

/// Reads the folder of a fit. Throws Error.
Result ReadResult(const std::filesystem::path& folder);

}  // namespace fourpost::api
