#include "identify/report/sentences_html.h"

#include <cctype>
#include <cstddef>
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

std::string CodeHtml(const std::string& text) {
  std::string html;
  std::size_t from = 0;
  for (std::size_t open = text.find('`'); open != std::string::npos; open = text.find('`', from)) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string::npos) break;
    html += html::Escaped(text.substr(from, open - from)) + html::Code(text.substr(open + 1, close - open - 1));
    from = close + 1;
  }
  return html + html::Escaped(text.substr(from));
}

}  // namespace fourpost
