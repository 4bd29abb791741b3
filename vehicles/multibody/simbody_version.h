#pragma once

#include <string>

namespace fourpost {

/// "3.7.0", of the library that runs.
std::string SimbodyVersion();

}  // namespace fourpost
