#include "identify/report/sentences_html.h"

#include <cctype>
#include <sstream>

#include "analysis/report/html.h"

namespace fourpost {

std::string SentencesHtml(const std::string& text) {
  std::istringstream lines(text);
  std::string sentences;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    line[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(line[0])));
    sentences += (sentences.empty() ? "" : " ") + html::Escaped(line) + (line.back() == '.' ? "" : ".");
  }
  return html::Element("p", "note", sentences) + '\n';
}

}  // namespace fourpost
