#pragma once

#include <string>

namespace fourpost {

/// A report as one self-contained HTML file, with style and scripts in it. `title`: text. `body`: HTML. `data_json`:
/// what the scripts draw, see README.md. `program`: WebAssembly that they may run, gzip in base 64; without it the page's
/// policy allows none.
std::string ReportDocument(const std::string& title, const std::string& body, const std::string& data_json,
                           const std::string& program = "");

}  // namespace fourpost
