#pragma once

#include <string>

namespace fourpost::api {

/// The version of this library: "0.2.0".
std::string Version();

}  // namespace fourpost::api
