#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/diagnostics.h>

namespace fourpost::api {

struct DrawOptions {
  int count = 200;
  std::uint64_t seed = 1;
  /// The study that was fitted: draw of the likelihood alone, as `fourpost draws --noise-only`. Empty: of all that the
  /// intervals allow for.
  std::filesystem::path noise_of_study = {};
  /// 0: one per processor. No influence on the result.
  int threads = 0;
  /// True ends by Error of kSimulation; asked often, from the calling thread.
  std::function<bool()> stop = {};
};

/// Values of the fitted parameters that a fit allows.
struct Draws {
  std::vector<std::string> parameters;
  std::vector<std::string> units;
  /// SI; a row for each draw.
  Eigen::MatrixXd values;
  /// Parameters without a standard deviation, which stay at their fitted values.
  std::vector<std::string> held;
  std::vector<Finding> warnings;
};

/// Draws from a fit's folder. Throws Error.
Draws Draw(const std::filesystem::path& run, const DrawOptions& options = {});

}  // namespace fourpost::api
