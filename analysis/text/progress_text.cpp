#include "analysis/text/progress_text.h"

#include <algorithm>
#include <cstdio>

#include "analysis/text/text_table.h"

namespace fourpost {

std::string TimeLeft(double share, double seconds, double since_s) {
  // What begins is not yet what goes on.
  if (!(share > 0.02) || seconds < 1) return "";
  const double left = std::max(0.0, seconds * (1 / share - 1) - since_s);
  char text[48];
  std::snprintf(text, sizeof text, left < 120 ? ", about %.0f s left" : ", about %.0f min left",
                left < 120 ? left : left / 60);
  return text;
}

std::string Rate(double done, double seconds, const std::string& what) {
  if (!(done > 0) || seconds < 0.5) return "";
  const double per_second = done / seconds;
  const bool is_slow = per_second < 0.1;
  return ", " + Rounded(is_slow ? 60 * per_second : per_second, 2) + " " + what +
         (is_slow ? " per minute" : " per second");
}

}  // namespace fourpost
