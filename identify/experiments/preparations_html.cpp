#include "identify/experiments/preparations_html.h"

#include "analysis/report/html.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {

std::string PreparationsHtml(const std::vector<nlohmann::json>& recordings, const char* name) {
  std::string items;
  for (const nlohmann::json& recording : recordings) {
    std::string text;
    for (const nlohmann::json& one : ListAt(recording, "preparation"))
      if (one.is_string()) text += (text.empty() ? "" : "; ") + one.get<std::string>();
    if (!text.empty()) items += html::Element("li", "", html::Escaped(TextAt(recording, name) + ": " + text));
  }
  return items.empty() ? "" : "<p>Prepared as the study states:</p>" + html::Element("ul", "", items);
}

}  // namespace fourpost
