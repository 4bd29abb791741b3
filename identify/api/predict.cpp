#include <fourpost/run.h>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "identify/api/engine_names.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/run/result_kind.h"
#include "identify/run/run_prediction.h"

namespace fourpost::api {

Prediction Predict(const std::filesystem::path& run, const std::filesystem::path& recording,
                   const PredictOptions& options) {
  const bool is_written = !options.output.empty();
  return Guarded([&] {
    if (is_written) {
      RequireInputsElsewhere({run / "vehicle.urdf", recording}, options.output);
      RequireNoOtherResult(options.output, ResultKind::kPrediction);
    }
    const FittedRun fitted = LoadFittedRun(run);
    const std::optional<ExperimentResults> results = PredictRecording(
        fitted,
        {.recording = recording,
         .engine = OwnEngine(options.engine),
         .mode = options.posts,
         .release = options.release,
         .start_s = options.start_s,
         .has_files = is_written},
        {.stop = options.stop});
    if (!results) throw SimulationError(kCallStopped);
    Prediction prediction{.json = PredictionJson(fitted, recording, nlohmann::ordered_json::object(), *results),
                          .warnings = FindingsOf(results->findings)};
    if (is_written) {
      OutputFolder output(options.output);
      for (const auto& [name, text] : results->files) output.Add(name, text);
      output.Add("result.json", prediction.json);
      output.Commit();
    }
    return prediction;
  });
}

}  // namespace fourpost::api
