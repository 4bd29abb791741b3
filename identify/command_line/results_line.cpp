#include "identify/command_line/results_line.h"

#include <cstdio>

namespace fourpost {

void PrintResultsLine(const std::filesystem::path& folder) {
  std::fprintf(stderr, "results: %s; open %s\n", folder.string().c_str(), (folder / kPageName).string().c_str());
}

}  // namespace fourpost
