#include "analysis/files/tdms/tdms_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/recording_fuzz.h"

namespace fourpost {

void FuzzTdms(const std::string& bytes) { FuzzRecording(bytes, "tdms", &OpenTdms); }

}  // namespace fourpost
