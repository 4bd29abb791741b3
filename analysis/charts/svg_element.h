#pragma once

#include <string>

/// Elements of a picture as SVG text, lengths in pixels.
namespace fourpost::svg {

inline constexpr const char* kText = "#222";
inline constexpr const char* kMuted = "#666";
inline constexpr const char* kGrid = "#d4d4d4";

/// Text as it may stand in XML.
std::string Escaped(const std::string& text);

/// A length to a tenth of a pixel.
std::string Px(double length);

/// " name=\"value\""
std::string Attribute(const char* name, const std::string& value);

/// The attributes x, y, width and height.
std::string Box(double x, double y, double width, double height);

std::string Rectangle(double x, double y, double width, double height, const char* fill);

/// A line along `steps` ("M0 0L3 4"), with round ends.
std::string Path(const std::string& steps, const std::string& color, double width);

/// `anchor`: start, middle or end of the text is at x; y is its base line.
std::string Text(double x, double y, const char* anchor, const std::string& color, const std::string& text);

/// A bold title and, after it, a note.
std::string Heading(double x, double y, const std::string& title, const std::string& note);

/// The whole document of this size on a white ground, in the letters of all pictures, 12 px.
std::string Document(double width, double height, const std::string& title, const std::string& body);

}  // namespace fourpost::svg
