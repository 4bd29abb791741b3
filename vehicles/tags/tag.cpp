#include "vehicles/tags/tag.h"

#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

const tinyxml2::XMLAttribute* Find(const tinyxml2::XMLElement& element, std::string_view name) {
  const tinyxml2::XMLAttribute* attribute = element.FirstAttribute();
  while (attribute && attribute->Name() != name) attribute = attribute->Next();
  return attribute;
}

}  // namespace

const tinyxml2::XMLElement& Written(const tinyxml2::XMLElement& element) {
  const auto* written = &element;
  while (IsMade(*written)) written = static_cast<const tinyxml2::XMLElement*>(written->GetUserData());
  return *written;
}

int LineOf(const tinyxml2::XMLElement& element) { return Written(element).GetLineNum(); }

int LineOf(const tinyxml2::XMLElement& element, std::string_view attribute) {
  const tinyxml2::XMLAttribute* found = Find(Written(element), attribute);
  return found ? found->GetLineNum() : LineOf(element);
}

bool IsMade(const tinyxml2::XMLElement& element) { return element.GetUserData() != nullptr; }

void SetOrigin(tinyxml2::XMLElement& made, tinyxml2::XMLElement& origin) { made.SetUserData(&origin); }

tinyxml2::XMLElement& CopyOf(tinyxml2::XMLElement& element) {
  tinyxml2::XMLElement& copy = *element.ShallowClone(element.GetDocument())->ToElement();
  SetOrigin(copy, element);
  for (tinyxml2::XMLNode* child = element.FirstChild(); child; child = child->NextSibling()) {
    tinyxml2::XMLElement* below = child->ToElement();
    copy.InsertEndChild(below ? &CopyOf(*below) : child->ShallowClone(element.GetDocument()));
  }
  return copy;
}

std::string_view Tag::Spelling(std::string_view attribute) const {
  const AttributeRule* known = FindAttribute(*rule, attribute);
  const bool is_former =
      known && !known->former.empty() && !Find(*element, known->name) && Find(*element, known->former);
  return is_former ? known->former : attribute;
}

std::string Tag::Text(std::string_view attribute) const {
  if (std::optional<std::string> text = AttributeText(*element, Spelling(attribute))) return *std::move(text);
  const AttributeRule* known = FindAttribute(*rule, attribute);
  return known ? std::string(known->fallback) : std::string();
}

std::optional<std::string> AttributeText(const tinyxml2::XMLElement& element, std::string_view attribute) {
  const tinyxml2::XMLAttribute* found = Find(element, attribute);
  if (!found) return std::nullopt;
  return found->Value();
}

const TagRule* FormOf(const tinyxml2::XMLElement& element, std::string_view path) {
  const std::string type = AttributeText(element, "type").value_or("");
  for (const TagRule* rule : FindTags(path))
    if (rule->type.empty() || rule->type == type) return rule;
  return nullptr;
}

std::vector<const tinyxml2::XMLElement*> Children(const tinyxml2::XMLElement& parent, const char* name) {
  std::vector<const tinyxml2::XMLElement*> children;
  for (const auto* child = parent.FirstChildElement(name); child; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

std::vector<tinyxml2::XMLElement*> Children(tinyxml2::XMLElement& parent, const char* name) {
  std::vector<tinyxml2::XMLElement*> children;
  for (auto* child = parent.FirstChildElement(name); child; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

std::vector<Tag> TagsOf(const tinyxml2::XMLElement& parent, std::string_view path) {
  const std::string name(path.substr(path.rfind('/') + 1));
  std::vector<Tag> tags;
  for (const tinyxml2::XMLElement* child : Children(parent, name.c_str()))
    if (const TagRule* rule = FormOf(*child, path)) tags.push_back({child, rule});
  return tags;
}

std::string Describe(const tinyxml2::XMLElement& element) {
  const std::string tag = element.Name();
  if (const std::optional<std::string> name = AttributeText(element, "name")) return tag + " '" + *name + "'";
  const tinyxml2::XMLNode* parent = element.Parent();
  const tinyxml2::XMLElement* above = parent ? parent->ToElement() : nullptr;
  const bool is_top = !above || std::string_view(above->Name()) == "robot";
  return "<" + tag + ">" + (is_top ? "" : " of " + Describe(*above));
}

std::optional<Eigen::Vector3d> ParseVector(std::string_view text) {
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
    const std::optional<double> number = ParseNumber(text.substr(0, end));
    if (!number) return std::nullopt;
    vector[i] = *number;
    text.remove_prefix(end);
  }
  if (!Trimmed(text).empty()) return std::nullopt;
  return vector;
}

std::string_view Trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace fourpost
