#pragma once

#include <string>
#include <string_view>

namespace fourpost {

/// What a page has beside its text.
struct ReportPrograms {
  /// WebAssembly that the scripts may run, gzip in base 64; empty: none, and the page's policy allows none.
  std::string_view live;
  /// Whether a vehicle is drawn.
  bool draws_vehicle = false;
};

/// A report as one self-contained HTML file, with style and scripts in it. `title`: text. `body`: HTML. `data_json`:
/// what the scripts draw, see README.md.
std::string ReportDocument(const std::string& title, const std::string& body, const std::string& data_json,
                           const ReportPrograms& programs = {});

}  // namespace fourpost
