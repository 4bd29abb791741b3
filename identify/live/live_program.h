#pragma once

#include <string_view>

namespace fourpost {

/// live_calls.h in WebAssembly, gzip in base 64: bundle/live.base64, which build.py makes.
extern const std::string_view kLiveProgram;

}  // namespace fourpost
