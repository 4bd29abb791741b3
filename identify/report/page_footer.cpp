#include "identify/report/page_footer.h"

#include <array>
#include <ctime>

#include "analysis/report/html.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

/// As 2026-01-31.
std::string Today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  std::array<char, 16> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &date)};
}

}  // namespace

std::string PageFooter(const std::string& source) {
  const auto [program, version] = Versions().front();
  return "<footer>Made by " + html::Escaped(program + ' ' + version) + " on " + Today() + " of " +
         html::Escaped(source) + ".</footer>\n";
}

}  // namespace fourpost
