#pragma once

#include <string>

namespace fourpost {

/// The end of a page: what made it, on which day (UTC), and of what. `source`: text, as "the files of the run".
std::string PageFooter(const std::string& source);

}  // namespace fourpost
