#include "identify/experiments/experiment.h"

#include <iterator>

#include "identify/experiments/findings.h"

namespace fourpost {

void RefuseRelease(const PredictionRequest& request) {
  if (request.release.empty() && !request.start_s) return;
  Refuse(kReleaseOfOtherKind, Place::Option(request.release.empty() ? "--start" : "--release"),
         {request.recording.filename().string()});
}

nlohmann::ordered_json LeftOutJson(const LeftOutRecording& recording) {
  return {{"recording", recording.name}, {"reason", recording.reason}};
}

void AddKeys(const nlohmann::ordered_json& part, nlohmann::ordered_json& whole) {
  for (const auto& [key, value] : part.items()) {
    if (value.is_array() && whole.contains(key)) whole[key].insert(whole[key].end(), value.begin(), value.end());
    else whole[key] = value;
  }
}

void AddResults(ExperimentResults part, ExperimentResults& whole) {
  whole.text += part.text;
  whole.unseen_text += part.unseen_text;
  AddKeys(part.json, whole.json);
  std::move(part.shares.begin(), part.shares.end(), std::back_inserter(whole.shares));
  whole.findings.Add(part.findings);
  whole.is_whole = whole.is_whole && part.is_whole;
  std::move(part.files.begin(), part.files.end(), std::back_inserter(whole.files));
}

}  // namespace fourpost
