// Changes of vehicle files that leave them XML: bytes alone seldom get beyond the XML parser. The legal tags,
// attributes and kinds of values are those of the reader's own table.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <tinyxml2.h>

#include "analysis/text/units.h"
#include "vehicles/tags/tag.h"
#include "vehicles/tags/tag_table.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

class Mutator {
 public:
  Mutator(XMLElement& robot, unsigned seed) : robot_(robot), random_(seed) { Collect(robot, ""); }

  void Mutate() {
    switch (Below(6)) {
      case 0: return AddTag();
      case 1: return Remove();
      case 2: return Duplicate();
      case 3: return RemoveAttribute();
      default: return SetValue();
    }
  }

 private:
  struct Place {
    XMLElement* element = nullptr;
    /// As in the table of tags: empty for `<robot>`.
    std::string path;
  };

  void Collect(XMLElement& element, const std::string& path) {
    places_.push_back({&element, path});
    for (XMLElement* child : Children(element))
      Collect(*child, path.empty() ? child->Name() : path + "/" + child->Name());
  }

  std::size_t Below(std::size_t count) { return count < 2 ? 0 : random_() % count; }

  template <typename Items>
  const auto& OneOf(const Items& items) {
    return items[Below(items.size())];
  }

  std::string Number() {
    static const std::vector<std::string> numbers = {"0",    "1",    "-1",    "0.5",   "2",      "0.1",
                                                     "-0.3", "1e-3", "100",   "1e4",   "1e6",    "1e-9",
                                                     "1e12", "1e80", "1e-80", "1e300", "1e-320", "-1e155"};
    // Numbers of everyday size more often.
    return OneOf(numbers).substr(0, Below(3) == 0 ? std::string::npos : 3);
  }

  /// The name of one of these tags in the file.
  std::string NameOf(const std::vector<std::string_view>& tags) {
    std::vector<std::string> names;
    for (const Place& place : places_)
      for (const std::string_view tag : tags)
        if (place.path == tag) names.push_back(AttributeText(*place.element, "name").value_or(""));
    return names.empty() ? "x" : OneOf(names);
  }

  std::string TreeNumber() {
    static const std::vector<std::string> numbers = {"mass",        "com/x",       "com/y",       "com/z",
                                                     "inertia/ixx", "inertia/iyy", "inertia/izz", "inertia/ixy",
                                                     "inertia/ixz", "inertia/iyz"};
    return "link[" + NameOf({"link"}) + "]/" + OneOf(numbers);
  }

  std::string Quantity(const Dimension& dimension) { return Number() + " " + SiUnit(dimension); }

  std::string Scalar(const AttributeRule& rule) {
    static const std::vector<std::string> factors = {"", "-", "0.5*", "1e200*"};
    if (!rule.word.empty() && Below(3) == 0) return std::string(rule.word);
    if (Below(4) == 0) return OneOf(factors) + "$" + NameOf({"fp:parameter"});
    return Quantity(rule.dimension);
  }

  std::string Value(const AttributeRule& rule) {
    static const std::vector<Dimension> dimensions = {kMass,  kLength,  kStiffness, kDamping,
                                                      kForce, kInertia, kVelocity,  kDensity};
    switch (rule.kind) {
      case AttributeKind::kText: return "text";
      case AttributeKind::kName: return "n" + std::to_string(Below(30)) + (Below(2) == 0 ? "_left" : "");
      case AttributeKind::kLink: return NameOf({"link"});
      case AttributeKind::kPoint: return NameOf({"link", "fp:frame", "frame"});
      case AttributeKind::kTyre: return NameOf({"fp:tyre"});
      case AttributeKind::kTreeNumber: return TreeNumber();
      case AttributeKind::kNumber: return Number();
      case AttributeKind::kVector:
      case AttributeKind::kDirection: return Number() + " " + Number() + " " + Number();
      case AttributeKind::kQuantity: return Quantity(OneOf(dimensions));
      case AttributeKind::kScalar: return Scalar(rule);
      case AttributeKind::kChoice: return std::string(OneOf(rule.choices));
    }
    return "";
  }

  void AddTag() {
    const Place& place = OneOf(places_);
    const std::vector<const TagRule*> rules = TagsBelow(place.path);
    if (rules.empty()) return;
    const TagRule& rule = *OneOf(rules);
    XMLElement& made = *robot_.GetDocument()->NewElement(std::string(rule.Name()).c_str());
    for (const AttributeRule& attribute : rule.attributes)
      if (attribute.required || Below(3) == 0)
        made.SetAttribute(std::string(attribute.name).c_str(), Value(attribute).c_str());
    place.element->InsertEndChild(&made);
  }

  void Remove() {
    const Place& place = OneOf(places_);
    if (place.element != &robot_) place.element->Parent()->DeleteChild(place.element);
  }

  void Duplicate() {
    const Place& place = OneOf(places_);
    if (place.element == &robot_) return;
    XMLElement& copy = *place.element->DeepClone(robot_.GetDocument())->ToElement();
    if (AttributeText(copy, "name")) copy.SetAttribute("name", ("n" + std::to_string(Below(1000))).c_str());
    place.element->Parent()->InsertAfterChild(place.element, &copy);
  }

  void RemoveAttribute() {
    XMLElement& element = *OneOf(places_).element;
    std::vector<std::string> names;
    for (const auto* given = element.FirstAttribute(); given; given = given->Next()) names.emplace_back(given->Name());
    if (!names.empty()) element.DeleteAttribute(OneOf(names).c_str());
  }

  void SetValue() {
    const Place& place = OneOf(places_);
    const TagRule* rule = FormOf(*place.element, place.path);
    if (!rule || rule->attributes.empty()) return;
    const AttributeRule& attribute = OneOf(rule->attributes);
    place.element->SetAttribute(std::string(attribute.name).c_str(), Value(attribute).c_str());
  }

  XMLElement& robot_;
  std::mt19937 random_;
  std::vector<Place> places_;
};

/// The text after a few changes; empty when it is no XML.
std::string Mutated(const std::string& text, unsigned seed) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS || !document.RootElement()) return "";
  for (unsigned i = 0; i <= seed % 3; ++i) Mutator(*document.RootElement(), seed + i).Mutate();
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace
}  // namespace fourpost

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const std::string text = seed % 4 == 0 ? "" : fourpost::Mutated({reinterpret_cast<const char*>(data), size}, seed);
  if (text.empty() || text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
