#include "analysis/files/lvm/lvm_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/recording_fuzz.h"

namespace fourpost {

void FuzzLvm(const std::string& bytes) { FuzzRecording(bytes, "lvm", &OpenLvm); }

}  // namespace fourpost
