#pragma once

#include <string>

namespace fourpost {

/// ", about 40 s left" of work of which this share took so long, and on which more time has been spent since; empty as
/// long as that says little.
std::string TimeLeft(double share, double seconds, double since_s = 0);

/// ", 1.3 runs per second", `done` of these having taken so long, or per minute where that is slow; empty as long as
/// that says little.
std::string Rate(double done, double seconds, const std::string& what);

}  // namespace fourpost
