#include "analysis/files/universal/universal_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/recording_fuzz.h"

namespace fourpost {
namespace {

std::unique_ptr<RecordingFile> OpenUniversal(const std::filesystem::path& file) {
  return std::make_unique<UniversalFile>(file);
}

}  // namespace

void FuzzUniversal(const std::string& bytes) { FuzzRecording(bytes, "universal", &OpenUniversal); }

}  // namespace fourpost
