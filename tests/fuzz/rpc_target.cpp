#include "analysis/files/rpc/rpc_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/recording_fuzz.h"

namespace fourpost {

void FuzzRpc(const std::string& bytes) { FuzzRecording(bytes, "rpc", &OpenRpc); }

}  // namespace fourpost
