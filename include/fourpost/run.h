#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/diagnostics.h>
#include <fourpost/response.h>

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

struct PredictOptions {
  Engine engine = Engine::kAuto;
  /// How the posts moved, as in SteppedSine; empty: to be found in the recording.
  std::string posts = {};
  /// From where the vehicle is let go, as `--release` of `fourpost predict`, and when [s]; empty: as the study states.
  std::string release = {};
  std::optional<double> start_s = {};
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
