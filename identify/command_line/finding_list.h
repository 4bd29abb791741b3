#pragma once

#include <string>

#include "analysis/text/finding.h"

namespace fourpost {

/// docs/findings.md: all that the program can find, by id.
std::string FindingsMarkdown();

/// One of them for the terminal.
std::string FindingText(const Finding& finding);

}  // namespace fourpost
