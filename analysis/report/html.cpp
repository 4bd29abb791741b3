#include "analysis/report/html.h"

#include <cctype>
#include <string_view>

#include "analysis/text/utf8.h"

namespace fourpost::html {

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : ValidUtf8(text)) {
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '"') escaped += "&quot;";
    else if (c == '\'') escaped += "&#39;";
    else
      // Control characters have no place in a page.
      escaped += static_cast<unsigned char>(c) < ' ' && c != '\n' ? ' ' : c;
  }
  return escaped;
}

std::string ScriptJson(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    // In JSON they stand in strings only.
    if (c == '<') safe += "\\u003c";
    else if (c == '>') safe += "\\u003e";
    else if (c == '&') safe += "\\u0026";
    else safe += c;
  }
  return safe;
}

std::string Element(const std::string& tag, const std::string& name, const std::string& html) {
  return '<' + tag + (name.empty() ? "" : " class=\"" + Escaped(name) + '"') + '>' + html + "</" + tag + '>';
}

Cell TextCell(const std::string& text) { return {Escaped(text), ""}; }
Cell NumberCell(const std::string& text) { return {Escaped(text), "n"}; }

namespace {

/// A quantity with its unit: a narrow column may break elsewhere.
std::string HeadHtml(const std::string& text) {
  std::string html = Escaped(text);
  for (std::size_t at = html.find(", "); at != std::string::npos; at = html.find(", ", at))
    html.replace(at, 2, ",&nbsp;");
  return html;
}

/// Without words it heads nothing.
std::string HeadCell(const std::string& name, const std::string& html) {
  if (html.empty()) return Element("td", name, "");
  return "<th scope=\"col\"" + (name.empty() ? "" : " class=\"" + Escaped(name) + '"') + '>' + html + "</th>";
}

}  // namespace

std::string Table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows) {
  std::string html = "<div class=\"table\"><table><thead><tr>";
  for (std::size_t i = 0; i < head.size(); ++i)
    html += HeadCell(rows.empty() ? "" : rows.front()[i].name, HeadHtml(head[i]));
  html += "</tr></thead><tbody>\n";
  for (const std::vector<Cell>& row : rows) {
    html += "<tr>";
    for (const Cell& cell : row) html += Element("td", cell.name, cell.html);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string Picture(const std::string& svg, const std::string& text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : svg) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || std::string_view(" -_.,:;=/()").find(c) != std::string_view::npos;
    if (is_plain) encoded += c;
    else (encoded += '%') += {kHex[byte >> 4], kHex[byte & 15]};
  }
  return "<img class=\"still\" alt=\"" + Escaped(text) + "\" src=\"data:image/svg+xml," + encoded + "\">\n";
}

std::string Section(const std::string& id, const std::string& title, const std::string& html) {
  return "<section id=\"" + Escaped(id) + "\">\n<h2>" + Escaped(title) + "</h2>\n" + html + "</section>\n";
}

std::string Folded(const std::string& title, const std::string& html) {
  return html.empty() ? ""
                      : "<details class=\"folded\"><summary>" + Escaped(title) + "</summary>" + html + "</details>\n";
}

std::string Code(const std::string& name) { return Element("code", "", Escaped(name)); }

std::string Drawn(const std::string& id, const std::string& without) {
  return "<div class=\"drawn\" data-draw=\"" + id + "\">" +
         (without.empty() ? "" : "<noscript><p class=\"note\">" + without + "</p></noscript>") + "</div>\n";
}

}  // namespace fourpost::html
