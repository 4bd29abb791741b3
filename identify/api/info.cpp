#include <fourpost/info.h>

#include "analysis/files/json_text.h"
#include "identify/api/errors.h"
#include "identify/inspection/described_file.h"

namespace fourpost::api {

Info Describe(const std::filesystem::path& file) {
  return Guarded([&] {
    Diagnostics faults;
    const std::optional<DescribedFile> described = DescribeFile(file, faults);
    if (!described || faults.HasErrors()) throw FaultyInput(faults);
    faults.Add(described->findings);
    return Info{.json = JsonText(described->json), .text = described->text, .warnings = FindingsOf(faults)};
  });
}

}  // namespace fourpost::api
