#pragma once

#include <string>

namespace fourpost {

/// "3.7.0", the version of the loaded library.
std::string SimbodyVersion();

}  // namespace fourpost
