#pragma once

#include <string>

namespace fourpost::api {

/// Of this library: "0.2.0".
std::string Version();

}  // namespace fourpost::api
