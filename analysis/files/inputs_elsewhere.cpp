#include "analysis/files/inputs_elsewhere.h"

#include "analysis/files/findings.h"
#include "analysis/files/output_folder.h"

namespace fourpost {

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
      throw OutputError(kFolderHoldsInput, {folder.string()}, {input.filename().string()});
}

}  // namespace fourpost
