#pragma once

#include <optional>
#include <string>

#include <yaml-cpp/yaml.h>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// The one document of a study's text. Reports text that is no YAML, and what yaml-cpp would pass over or take without
/// end: a second document, tags such as `!!python/object`, more values than any study has, aliases counted as what they
/// stand for. Nothing when there was one.
std::optional<YAML::Node> ReadYaml(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
