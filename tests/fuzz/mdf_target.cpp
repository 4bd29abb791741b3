#include "analysis/files/mdf/mdf_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/recording_fuzz.h"

namespace fourpost {

void FuzzMdf(const std::string& bytes) { FuzzRecording(bytes, "mdf", &OpenMdf); }

}  // namespace fourpost
