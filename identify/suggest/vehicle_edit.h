#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "analysis/text/units.h"
#include "vehicles/tags/xml_scanner.h"

namespace fourpost {

/// A parameter to be added to a vehicle file; SI.
struct NewParameter {
  std::string name;
  Dimension dimension;
  double lower = 0;
  double upper = 0;
  std::string source;
  /// "link[NAME]/mass"; empty: it is referred to by "$name".
  std::string bound_to = {};
};

/// Changes of the text of a vehicle file, which keep all else byte for byte. Elements are those of this object.
class VehicleEdit {
 public:
  /// `text`: of a file that was read without a fault; must outlive this object.
  explicit VehicleEdit(const std::string& text);

  /// Directly below <robot>; null where the file has none of that name, as of one that fp:mirror makes.
  const tinyxml2::XMLElement* Find(const char* tag, std::string_view name) const;
  /// Mirrors of the file, as (from, to).
  std::vector<std::pair<std::string, std::string>> Mirrors() const;

  /// Adds the attribute or replaces its value.
  void Set(const tinyxml2::XMLElement& element, const std::string& attribute, const std::string& value);
  /// Replaces an attribute that it has by another one.
  void Exchange(const tinyxml2::XMLElement& element, std::string_view old, const std::string& attribute,
                const std::string& value);
  /// Takes out an element with all that it has, in which nothing else is changed.
  void Remove(const tinyxml2::XMLElement& element);
  /// Gives another name to an element, which has no children.
  void Rename(const tinyxml2::XMLElement& element, const std::string& tag);
  /// Puts this before what the element has.
  void AddChild(const tinyxml2::XMLElement& element, const std::string& xml);
  /// Puts this at the end of the file.
  void Add(const std::string& xml);
  /// Puts a parameter at the end of the file, in SI units.
  void Add(const NewParameter& parameter, double value);

  std::string Text() const;

 private:
  struct Change {
    std::size_t end = 0;
    std::string text;
  };

  void Number(const tinyxml2::XMLElement& element);
  void Insert(std::size_t at, const std::string& text);
  const TagPlaces& PlacesOf(const tinyxml2::XMLElement& element) const;
  /// Of the '>' of its start tag.
  std::size_t TagEnd(const tinyxml2::XMLElement& element) const;
  /// Behind its end tag.
  std::size_t End(const tinyxml2::XMLElement& element) const;

  const std::string& text_;
  tinyxml2::XMLDocument document_;
  std::vector<TagPlaces> tags_;
  std::map<const tinyxml2::XMLElement*, std::size_t> index_;
  std::map<std::size_t, Change> changes_;
};

}  // namespace fourpost
