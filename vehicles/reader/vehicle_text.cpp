#include <map>
#include <sstream>
#include <stdexcept>

#include <tinyxml2.h>

#include "analysis/text/count_check.h"
#include "analysis/text/number.h"
#include "vehicles/reader/file_tags.h"
#include "vehicles/reader/tree_binding.h"
#include "vehicles/reader/tree_reference.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/tags/tag.h"
#include "vehicles/tags/xml_scanner.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Replaces and removes attributes in a text and leaves all else as it is.
class TextEdits {
 public:
  TextEdits(const std::string& text, const XMLElement& root) : text_(text), tags_(ScanTags(text)) { Number(root); }

  void Replace(const XMLElement& element, std::string_view attribute, const std::string& value) {
    for (const AttributePlace& place : tags_.at(index_.at(&element)).attributes)
      if (place.name == attribute) edits_[place.begin] = {place.end, Escaped(value, place.quote)};
  }

  /// Attributes behind those that stand, and content in front of that of the element.
  void Insert(const XMLElement& element, const std::string& attributes, const std::string& content) {
    const TagPlaces& tag = tags_.at(index_.at(&element));
    const std::size_t end = tag.attributes.empty() ? tag.name_end : tag.attributes.back().end + 1;
    const std::size_t close = text_.find('>', end);
    const bool is_closed = text_[close - 1] == '/';
    const std::string name = element.Name();
    edits_[close - (is_closed ? 1 : 0)] = {close + 1,
                                           attributes + ">" + content + (is_closed ? "\n    </" + name + ">" : "")};
  }

  /// With the blanks before it.
  void Remove(const XMLElement& element, std::string_view attribute) {
    for (const AttributePlace& place : tags_.at(index_.at(&element)).attributes) {
      if (place.name != attribute) continue;
      const auto name = static_cast<std::size_t>(place.name.data() - text_.data());
      edits_[text_.find_last_not_of(" \t\r\n", name - 1) + 1] = {place.end + 1, ""};
    }
  }

  std::string Result() const {
    std::string result;
    std::size_t done = 0;
    for (const auto& [begin, edit] : edits_) {
      result += text_.substr(done, begin - done) + edit.value;
      done = edit.end;
    }
    return result + text_.substr(done);
  }

 private:
  struct Edit {
    std::size_t end = 0;
    std::string value;
  };

  void Number(const XMLElement& element) {
    index_.emplace(&element, index_.size());
    for (const XMLElement* child : Children(element)) Number(*child);
  }

  static std::string Escaped(const std::string& value, char quote) {
    std::string escaped;
    for (const char c : value) {
      if (c == '&') escaped += "&amp;";
      else if (c == '<') escaped += "&lt;";
      else if (c == quote) escaped += quote == '"' ? "&quot;" : "&apos;";
      else escaped += c;
    }
    return escaped;
  }

  const std::string& text_;
  std::vector<TagPlaces> tags_;
  std::map<const XMLElement*, std::size_t> index_;
  std::map<std::size_t, Edit> edits_;
};

void ReplaceParameters(const XMLElement& robot, const Vehicle& vehicle, std::span<const double> values,
                       TextEdits& edits) {
  const std::vector<const XMLElement*> elements = Children(robot, "fp:parameter");
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    for (const XMLElement* element : elements) {
      if (NameOf(*element) != vehicle.parameters[i].name) continue;
      const std::optional<Quantity> written = ParseQuantity(Trimmed(AttributeText(*element, "value").value_or("")));
      if (!written || written->si != values[i])
        edits.Replace(*element, "value", FormatQuantity(values[i], vehicle.parameters[i].unit));
      if (AttributeText(*element, "source") != vehicle.parameters[i].source)
        edits.Replace(*element, "source", vehicle.parameters[i].source);
      if (!vehicle.parameters[i].prior_sd) edits.Remove(*element, "prior_sd");
      if (!vehicle.parameters[i].like)
        for (const char* attribute : {"like", "like_sd"}) edits.Remove(*element, attribute);
    }
  }
}

/// Writes a number of the tree that follows a parameter, unless it is right already.
void ReplaceBound(const XMLElement* element, std::string_view attribute, const Scalar& number,
                  std::span<const double> values, TextEdits& edits) {
  if (!element || number.parameter < 0) return;
  const std::string text = AttributeText(*element, attribute).value_or("");
  // A reference follows by itself.
  if (HasReference(text)) return;
  const std::optional<double> written = ParseNumber(Trimmed(text));
  if (!written || !Agrees(*written, number.At(values)))
    edits.Replace(*element, attribute, FormatNumber(number.At(values)));
}

/// The centre of mass stands as three numbers in one attribute; those that are references follow by themselves.
void ReplaceCom(const XMLElement* origin, const Link& link, std::span<const double> values, TextEdits& edits) {
  if (!origin) return;
  std::istringstream words(AttributeText(*origin, "xyz").value_or(""));
  const Eigen::Vector3d com = link.ComAt(values);
  std::string text;
  bool has_changed = false;
  std::size_t i = 0;
  for (std::string word; i < link.com.size() && words >> word; ++i) {
    const std::optional<double> written = ParseNumber(word);
    const double now = com[static_cast<Eigen::Index>(i)];
    const bool is_right = !written || link.com[i].parameter < 0 || Agrees(*written, now);
    has_changed = has_changed || !is_right;
    text += (i == 0 ? "" : " ") + (is_right ? word : FormatNumber(now));
  }
  if (has_changed && i == link.com.size()) edits.Replace(*origin, "xyz", text);
}

void ReplaceInertia(const XMLElement& inertial, const Link& link, std::span<const double> values, TextEdits& edits) {
  ReplaceCom(inertial.FirstChildElement("origin"), link, values, edits);
  ReplaceBound(inertial.FirstChildElement("mass"), "value", link.mass, values, edits);
  for (std::size_t i = 0; i < link.inertia.size(); ++i)
    ReplaceBound(inertial.FirstChildElement("inertia"), kInertiaNames[i], link.inertia[i], values, edits);
}

void ReplaceTree(const XMLElement& robot, const Vehicle& vehicle, std::span<const double> values, TextEdits& edits) {
  for (const XMLElement* element : Children(robot, "link")) {
    const XMLElement* inertial = element->FirstChildElement("inertial");
    for (const Link& link : vehicle.links)
      if (inertial && link.name == NameOf(*element)) ReplaceInertia(*inertial, link, values, edits);
  }
}

/// Of a path that need not exist yet.
std::filesystem::path CanonicalPath(const std::filesystem::path& path) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
}

/// Mesh files stand relative to the vehicle file.
void ReplaceMeshes(const XMLElement& element, const std::filesystem::path& from, const std::filesystem::path& to,
                   TextEdits& edits) {
  const std::optional<std::string> file = AttributeText(element, "filename");
  if (file && std::string_view(element.Name()) == "mesh")
    edits.Replace(element, "filename", (from / *file).lexically_normal().lexically_relative(to).generic_string());
  for (const XMLElement* child : Children(element)) ReplaceMeshes(*child, from, to, edits);
}

/// Files of curves are written out, so that the text is whole wherever it goes.
void WriteOutFiles(const XMLElement& robot, const Vehicle& vehicle, TextEdits& edits) {
  for (const XMLElement* element : Children(robot)) {
    const FileContent* content = ContentOf(vehicle, *element);
    if (!content) continue;
    const XMLElement* place = content->tag == "fp:bushing" ? element : element->FirstChildElement("table");
    if (!place) continue;
    edits.Remove(*place, "file");
    edits.Insert(*place, content->at ? " at=\"" + FormatNumber(*content->at) + " m\"" : "", content->xml);
  }
}

}  // namespace

std::string VehicleTextWithValues(const Vehicle& vehicle, std::span<const double> parameters,
                                  const std::filesystem::path& folder) {
  RequireCount("VehicleTextWithValues", "parameters", vehicle.parameters.size(), parameters.size());
  tinyxml2::XMLDocument document;
  if (document.Parse(vehicle.text.data(), vehicle.text.size()) != tinyxml2::XML_SUCCESS)
    throw std::invalid_argument("VehicleTextWithValues: vehicle '" + vehicle.name + "' has no text of a file");
  const XMLElement& robot = *document.RootElement();
  TextEdits edits(vehicle.text, robot);
  ReplaceParameters(robot, vehicle, parameters, edits);
  ReplaceTree(robot, vehicle, parameters, edits);
  const std::filesystem::path from = CanonicalPath(vehicle.file).parent_path();
  const std::filesystem::path to = CanonicalPath(folder);
  if (from != to) {
    ReplaceMeshes(robot, from, to, edits);
    WriteOutFiles(robot, vehicle, edits);
  }
  return edits.Result();
}

}  // namespace fourpost
