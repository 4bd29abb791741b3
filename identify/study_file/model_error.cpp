#include "identify/study_file/model_error.h"

#include "identify/study_file/findings.h"
#include "identify/study_file/study_yaml.h"

namespace fourpost {

ModelError ReadModelError(const StrictMap& study) {
  ModelError error;
  if (!study.Has("model_error")) return error;
  const StrictMap map = study.Map("model_error", {"gain_dB", "phase", "mean", "second_harmonic", "floor", "history"});
  error.gain_dB = map.Number("gain_dB", 0, 100).value_or(error.gain_dB);
  error.phase_rad = map.Quantity("phase", kDimensionless, 0).value_or(error.phase_rad);
  error.floor = map.Number("floor", 0, 1).value_or(error.floor);
  error.mean_m = map.Quantity("mean", kLength, 0).value_or(error.mean_m);
  error.second_harmonic_m = map.Quantity("second_harmonic", kLength, 0).value_or(error.second_harmonic_m);
  error.history = map.Quantity("history", kDimensionless, 0).value_or(error.history);
  if (error.mean_m == 0) map.FaultOf("mean", kKeyNotPositive);
  return error;
}

ModelError ModelErrorOf(const std::string& study_text) {
  Diagnostics ignored;
  const std::optional<YAML::Node> root = ReadYaml(study_text, "", ignored);
  if (!root || !root->IsMap()) return {};
  return ReadModelError(StrictMap(*root, "study", {"model_error"}, "", ignored));
}

}  // namespace fourpost
