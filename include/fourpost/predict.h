#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fourpost/diagnostics.h>
#include <fourpost/response.h>

namespace fourpost::api {

struct PredictOptions {
  Engine engine = Engine::kAuto;
  /// How the posts moved, as in SteppedSine; empty: to be found in the recording.
  std::string posts = {};
  /// Where the curves are written; empty: nowhere.
  std::filesystem::path output = {};
  /// True ends by Error of kSimulation; asked often, from the calling thread.
  std::function<bool()> stop = {};
};

/// How well a fitted vehicle predicts a recording.
struct Prediction {
  /// As `fourpost predict --json` prints it (docs/reference.md).
  std::string json;
  std::vector<Finding> warnings;
};

/// Predicts a recording of a kind and with channels that the study of the run has. Throws Error.
Prediction Predict(const std::filesystem::path& run, const std::filesystem::path& recording,
                   const PredictOptions& options = {});

}  // namespace fourpost::api
