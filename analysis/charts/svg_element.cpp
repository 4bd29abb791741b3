#include "analysis/charts/svg_element.h"

#include <cmath>

#include "analysis/text/number.h"
#include "analysis/text/utf8.h"

namespace fourpost::svg {

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : ValidUtf8(text)) {
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '"') escaped += "&quot;";
    else
      // Most control characters have no place in XML.
      escaped += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return escaped;
}

std::string Px(double length) {
  // No "-0".
  return FormatNumber(std::round(length * 10) / 10 + 0.0);
}

std::string Attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + Escaped(value) + '"';
}

std::string Box(double x, double y, double width, double height) {
  return Attribute("x", Px(x)) + Attribute("y", Px(y)) + Attribute("width", Px(width)) +
         Attribute("height", Px(height));
}

std::string Rectangle(double x, double y, double width, double height, const char* fill) {
  return "<rect" + Box(x, y, width, height) + Attribute("fill", fill) + "/>\n";
}

std::string Path(const std::string& steps, const std::string& color, double width) {
  return "<path" + Attribute("d", steps) + Attribute("fill", "none") + Attribute("stroke", color) +
         Attribute("stroke-width", Px(width)) + Attribute("stroke-linecap", "round") +
         Attribute("stroke-linejoin", "round") + "/>\n";
}

std::string Text(double x, double y, const char* anchor, const std::string& color, const std::string& text) {
  return "<text" + Attribute("x", Px(x)) + Attribute("y", Px(y)) + Attribute("text-anchor", anchor) +
         Attribute("fill", color) + ">" + Escaped(text) + "</text>\n";
}

std::string Heading(double x, double y, const std::string& title, const std::string& note) {
  return "<text" + Attribute("x", Px(x)) + Attribute("y", Px(y)) + Attribute("fill", kText) +
         "><tspan font-weight=\"bold\">" + Escaped(title) + "</tspan><tspan dx=\"12\"" + Attribute("fill", kMuted) +
         ">" + Escaped(note) + "</tspan></text>\n";
}

std::string Document(double width, double height, const std::string& title, const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + Box(0, 0, width, height) +
         Attribute("viewBox", "0 0 " + Px(width) + " " + Px(height)) +
         Attribute("font-family", "Helvetica, Arial, sans-serif") + Attribute("font-size", "12") + ">\n" + "<title>" +
         Escaped(title) + "</title>\n" + Rectangle(0, 0, width, height, "#fff") + body + "</svg>\n";
}

}  // namespace fourpost::svg
