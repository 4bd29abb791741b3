#pragma once

#include <string>

#include <fourpost/fit.h>

namespace fourpost::api {

/// Of the text of a result.json that a fit wrote.
Result ResultOf(const std::string& json, const std::filesystem::path& folder);

}  // namespace fourpost::api
