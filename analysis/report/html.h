#pragma once

#include <string>
#include <vector>

/// Pieces of a page as HTML text. What is called text is escaped, what is called html is taken as it is.
namespace fourpost::html {

/// Text as it may stand between tags and in attributes.
std::string Escaped(const std::string& text);

/// JSON as it may stand in a script element: no text in it can end the element.
std::string ScriptJson(const std::string& json);

/// <tag class="name">html</tag>; without class when that is empty.
std::string Element(const std::string& tag, const std::string& name, const std::string& html);

/// A cell: html, and its class ("n": a number, set flush right).
struct Cell {
  std::string html;
  std::string name;
};

Cell TextCell(const std::string& text);
Cell NumberCell(const std::string& text);

/// A table with a head, in a frame that scrolls where it is too wide. Every row has a cell per column; a column's head
/// is set as its first cell is.
std::string Table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows);

/// An SVG document as a picture within the page; scripts in it do not run. `text`: what it shows, for who cannot see
/// it.
std::string Picture(const std::string& svg, const std::string& text);

/// <section> with a heading.
std::string Section(const std::string& id, const std::string& title, const std::string& html);

/// What is seen on demand; empty where there is nothing. `title`: text.
std::string Folded(const std::string& title, const std::string& html);

/// A name in the type of code.
std::string Code(const std::string& name);

/// A place that the scripts fill, and the note that stands there without them.
std::string Drawn(const std::string& id, const std::string& without = "");

}  // namespace fourpost::html
