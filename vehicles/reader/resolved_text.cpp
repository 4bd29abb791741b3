#include "vehicles/reader/resolved_text.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "vehicles/reader/vehicle_file.h"
#include "vehicles/tags/tag.h"
#include "vehicles/tags/xml_scanner.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Either a preload or a free length says what a spring carries.
bool IsSaidOtherwise(const XMLElement& element, const AttributeRule& attribute) {
  return attribute.name == "preload" && AttributeText(element, "free_length");
}

/// The defaults of an element, each as " name=\"value\"".
std::string Defaults(const XMLElement& element, const TagRule& rule) {
  std::string text;
  for (const AttributeRule& attribute : rule.attributes) {
    const bool is_given = AttributeText(element, attribute.name) || AttributeText(element, attribute.former);
    if (is_given || attribute.fallback.empty() || IsSaidOtherwise(element, attribute)) continue;
    text += " " + std::string(attribute.name) + "=\"" + std::string(attribute.fallback) + "\"";
  }
  return text;
}

/// Copies a text and adds to its tags, which come in the order of the document.
class Filler {
 public:
  explicit Filler(const std::string& text) : text_(text), tags_(ScanTags(text)) {}

  void Walk(const XMLElement& element, const std::string& path) {
    const TagPlaces& places = tags_.at(next_++);
    const TagRule* rule = path.empty() ? nullptr : FormOf(element, path);
    if (rule) {
      const std::size_t end = places.attributes.empty() ? places.name_end : places.attributes.back().end + 1;
      result_ += text_.substr(done_, end - done_) + Defaults(element, *rule);
      done_ = end;
    }
    for (const XMLElement* child : Children(element))
      Walk(*child, path.empty() ? child->Name() : path + "/" + child->Name());
  }

  std::string Result() const { return result_ + text_.substr(done_); }

 private:
  const std::string& text_;
  std::vector<TagPlaces> tags_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
  std::string result_;
};

std::string Note(const XMLElement& robot) {
  const auto has = [&](std::string_view tag) {
    const std::vector<const XMLElement*> children = Children(robot);
    return std::any_of(children.begin(), children.end(),
                       [&](const XMLElement* child) { return std::string_view(child->Name()).starts_with(tag); });
  };
  std::string note = "<!-- fourpost check, resolved: defaults of fp: tags are filled in.";
  if (has("fp:mirror")) note += " The mirror partners that fp:mirror makes are not written out.";
  if (has("drake:") || has("frame")) note += " Tags of Drake stand as they are.";
  return note + " -->";
}

/// Says that a text is UTF-8.
constexpr std::string_view kMark = "\xEF\xBB\xBF";

/// Behind the XML declaration, which must stand first; the parser takes any instruction for one.
std::size_t PlaceOfNote(const std::string& text) {
  const std::size_t begin = text.starts_with(kMark) ? kMark.size() : 0;
  if (text.compare(begin, 2, "<?") != 0) return begin;
  return text.find("?>", begin) + 2;
}

}  // namespace

std::string ResolvedText(const Vehicle& vehicle, const std::filesystem::path& folder) {
  const std::string text = VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder);
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  const XMLElement& robot = *document.RootElement();
  Filler filler(text);
  filler.Walk(robot, "");
  std::string result = filler.Result();
  const std::string note = Note(robot);
  if (result.find(note) != std::string::npos) return result;
  const std::size_t place = PlaceOfNote(result);
  return result.insert(place, place > kMark.size() ? "\n" + note : note + "\n");
}

}  // namespace fourpost
