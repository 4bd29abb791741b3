#pragma once

#include <array>
#include <string_view>

namespace fourpost {

struct StarterFile {
  std::string_view name;
  std::string_view text;
};

/// The files of studies/starter.
extern const std::array<StarterFile, 3> kStarterFiles;

}  // namespace fourpost
