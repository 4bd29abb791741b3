#pragma once

#include <string>

namespace fourpost {

/// A report as one self-contained HTML file, with style and scripts in it. `title`: text. `body`: HTML. `data_json`:
/// what the scripts draw, see README.md.
std::string ReportDocument(const std::string& title, const std::string& body, const std::string& data_json);

}  // namespace fourpost
