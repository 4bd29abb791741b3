#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fourpost/diagnostics.h>

namespace fourpost::api {

struct ChooseOptions {
  /// 0: one per processor. No influence on the result.
  int threads = 0;
  /// Where tables, pictures and the page are written; empty: nowhere.
  std::filesystem::path output = {};
  /// True ends by Error of kSimulation; asked often, from the calling thread.
  std::function<bool()> stop = {};
};

/// The best of many settings of a vehicle.
struct Choice {
  /// As `fourpost choose --json` prints it (docs/reference.md).
  std::string json;
  std::vector<Finding> warnings;
};

/// Chooses settings (studies/README.md) of a fit's folder, whose intervals are the doubt, or of a vehicle file. Throws
/// Error.
Choice Choose(const std::filesystem::path& run, const std::filesystem::path& settings,
              const ChooseOptions& options = {});

}  // namespace fourpost::api
