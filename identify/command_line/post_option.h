#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "analysis/measured_response/posts_by_name.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Adds `--post CHANNEL=FL`, once for each post; what is malformed is added to `faults`. `without`: what holds for
/// channels that are not named so. Returns the option.
CLI::Option* AddPostOption(CLI::App& app, std::vector<PostChannel>& posts, Diagnostics& faults,
                           const std::string& without);

}  // namespace fourpost
