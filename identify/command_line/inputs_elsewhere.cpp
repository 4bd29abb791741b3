#include "identify/command_line/inputs_elsewhere.h"

#include "analysis/output_folder.h"

namespace fourpost {

std::vector<std::filesystem::path> InputsOf(const LoadedStudy& study) {
  std::vector<std::filesystem::path> inputs = {study.study.file, study.vehicle.file};
  for (const StudyRecording& recording : study.study.recordings) inputs.push_back(recording.file);
  for (const StudyHistory& history : study.study.histories) inputs.push_back(history.file);
  if (study.study.bench)
    for (const auto* list : {&study.study.bench->recordings, &study.study.bench->validation})
      for (const BenchStudy::Recording& recording : *list) inputs.push_back(recording.file);
  return inputs;
}

void RequireInputsElsewhere(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& folder) {
  const auto folder_of = [](const std::filesystem::path& file) {
    std::error_code failure;
    const std::filesystem::path whole = std::filesystem::absolute(file);
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(whole, failure);
    // What cannot be followed cannot be written to either, of which OutputFolder says more.
    return (failure ? whole : canonical).parent_path();
  };
  for (const std::filesystem::path& input : inputs)
    if (folder_of(input) == folder_of(folder / "result.json"))
      throw OutputError(folder.string() + " holds the input " + input.filename().string() + "; give another folder");
}

}  // namespace fourpost
