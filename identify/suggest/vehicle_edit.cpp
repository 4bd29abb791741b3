#include "identify/suggest/vehicle_edit.h"

#include <stdexcept>

#include "analysis/text/short_number.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

std::string Shown(double si, const std::string& unit) { return FormatQuantity(AtDigits(si, 6), unit); }

}  // namespace

VehicleEdit::VehicleEdit(const std::string& text) : text_(text), tags_(ScanTags(text)) {
  if (document_.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS || !document_.RootElement())
    throw std::invalid_argument("VehicleEdit: not the text of a vehicle file");
  Number(*document_.RootElement());
}

void VehicleEdit::Number(const XMLElement& element) {
  index_.emplace(&element, index_.size());
  for (const XMLElement* child : Children(element)) Number(*child);
}

const XMLElement* VehicleEdit::Find(const char* tag, std::string_view name) const {
  for (const XMLElement* element : Children(*document_.RootElement(), tag))
    if (NameOf(*element) == name) return element;
  return nullptr;
}

std::vector<std::pair<std::string, std::string>> VehicleEdit::Mirrors() const {
  std::vector<std::pair<std::string, std::string>> mirrors;
  for (const XMLElement* element : Children(*document_.RootElement(), "fp:mirror"))
    mirrors.emplace_back(AttributeText(*element, "from").value_or(""), AttributeText(*element, "to").value_or(""));
  return mirrors;
}

const TagPlaces& VehicleEdit::PlacesOf(const XMLElement& element) const { return tags_.at(index_.at(&element)); }

std::size_t VehicleEdit::TagEnd(const XMLElement& element) const {
  const TagPlaces& places = PlacesOf(element);
  const std::size_t from = places.attributes.empty() ? places.name_end : places.attributes.back().end + 1;
  return text_.find('>', from);
}

void VehicleEdit::Insert(std::size_t at, const std::string& text) {
  Change& change = changes_.try_emplace(at, Change{at, ""}).first->second;
  change.text += text;
}

void VehicleEdit::Set(const XMLElement& element, const std::string& attribute, const std::string& value) {
  const TagPlaces& places = PlacesOf(element);
  for (const AttributePlace& place : places.attributes)
    if (place.name == attribute) {
      changes_[place.begin] = {place.end, value};
      return;
    }
  Insert(places.attributes.empty() ? places.name_end : places.attributes.back().end + 1,
         ' ' + attribute + "=\"" + value + '"');
}

void VehicleEdit::Exchange(const XMLElement& element, std::string_view old, const std::string& attribute,
                           const std::string& value) {
  for (const AttributePlace& place : PlacesOf(element).attributes) {
    if (place.name != old) continue;
    const auto name = static_cast<std::size_t>(place.name.data() - text_.data());
    changes_[name] = {place.end + 1, attribute + "=\"" + value + '"'};
  }
}

std::size_t VehicleEdit::End(const XMLElement& element) const {
  std::size_t end = TagEnd(element);
  if (text_[end - 1] == '/') return end + 1;
  for (const XMLElement* child : Children(element)) end = End(*child);
  // A comment may hold a tag.
  while (true) {
    const std::size_t comment = text_.find("<!--", end);
    const std::size_t closing = text_.find("</", end);
    if (closing < comment) return text_.find('>', closing) + 1;
    end = text_.find("-->", comment);
  }
}

void VehicleEdit::Remove(const XMLElement& element) {
  const std::size_t begin = PlacesOf(element).name_end - std::string_view(element.Name()).size() - 1;
  // What was put before it stays.
  changes_.try_emplace(begin, Change{begin, ""}).first->second.end = End(element);
}

void VehicleEdit::Rename(const XMLElement& element, const std::string& tag) {
  const std::string old = element.Name();
  const std::size_t end = PlacesOf(element).name_end;
  changes_[end - old.size()] = {end, tag};
  const std::size_t tag_end = TagEnd(element);
  if (text_[tag_end - 1] == '/') return;
  const std::size_t closing = text_.find("</", tag_end) + 2;
  changes_[closing] = {closing + old.size(), tag};
}

void VehicleEdit::AddChild(const XMLElement& element, const std::string& xml) {
  const std::size_t end = TagEnd(element);
  if (text_[end - 1] != '/') return Insert(end + 1, "\n    " + xml);
  Change& change = changes_.try_emplace(end - 1, Change{end + 1, ""}).first->second;
  change.text = ">\n    " + xml + "\n  </" + element.Name() + '>';
}

void VehicleEdit::Add(const std::string& xml) { Insert(text_.rfind("</robot>"), "  " + xml + '\n'); }

void VehicleEdit::Add(const NewParameter& parameter, double value) {
  const std::string unit = SiUnit(parameter.dimension);
  const std::string shown = unit == "1" ? "" : unit;
  std::string xml = "<fp:parameter name=\"" + parameter.name + "\" value=\"" + Shown(value, shown) + "\" lower=\"" +
                    Shown(parameter.lower, shown) + "\" upper=\"" + Shown(parameter.upper, shown) + "\" precision=\"" +
                    Shown((parameter.upper - parameter.lower) / 1e5, shown) + "\"\n                source=\"" +
                    parameter.source + '"';
  xml += parameter.bound_to.empty() ? "/>" : ">\n    <fp:bind to=\"" + parameter.bound_to + "\"/>\n  </fp:parameter>";
  Add(xml);
}

std::string VehicleEdit::Text() const {
  std::string result;
  std::size_t done = 0;
  for (const auto& [begin, change] : changes_) {
    result += text_.substr(done, begin - done) + change.text;
    done = change.end;
  }
  return result + text_.substr(done);
}

}  // namespace fourpost
