#include "vehicles/reader/tag_check.h"

#include <map>
#include <set>

#include "analysis/text/nearest.h"
#include "vehicles/reader/drake_tags.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/attribute_check.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// "fp" of "fp:spring"; empty without a prefix.
std::string_view PrefixOf(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

bool IsForeign(std::string_view name) { return !PrefixOf(name).empty() && PrefixOf(name) != "fp"; }

/// Walks through the file for what concerns prefixes.
class PrefixCheck {
 public:
  explicit PrefixCheck(FileFaults& faults) : faults_(faults) {}

  void Walk(const XMLElement& element) {
    if (IsForeign(element.Name())) {
      Warn("<" + std::string(element.Name()) + ">", PrefixOf(element.Name()), LineOf(element));
      return;
    }
    own_used_ = own_used_ || (PrefixOf(element.Name()) == "fp" && !IsMade(element));
    for (const auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next()) {
      const std::string_view prefix = PrefixOf(attribute->Name());
      if (!prefix.empty() && prefix != "xmlns" && prefix != "xml" && prefix != "fp")
        Warn("the attribute " + std::string(attribute->Name()), prefix, LineOf(element, attribute->Name()));
    }
    for (const XMLElement* child : Children(element)) Walk(*child);
  }

  void CheckDeclaration(const XMLElement& robot) {
    const std::string wanted = std::string("xmlns:fp=\"") + kNamespace + "\"";
    const std::optional<std::string> declared = AttributeText(robot, "xmlns:fp");
    if (declared && *declared != kNamespace) faults_.Report(kNamespaceOther, LineOf(robot), {*declared, wanted});
    if (!declared && own_used_) faults_.Report(kNamespaceMissing, LineOf(robot), {wanted});
  }

 private:
  void Warn(const std::string& what, std::string_view prefix, int line) {
    if (!seen_.insert(std::string(prefix)).second) return;
    faults_.Report(kForeignPrefix, line,
                   {what, std::string(prefix), prefix == "drake" ? " except " + DrakeTagNames() : ""});
  }

  FileFaults& faults_;
  std::set<std::string> seen_;
  bool own_used_ = false;
};

std::vector<std::string_view> NamesOf(const std::vector<const TagRule*>& rules) {
  std::vector<std::string_view> names;
  for (const TagRule* rule : rules)
    if (names.empty() || names.back() != rule->Name()) names.push_back(rule->Name());
  return names;
}

/// The legal name that an unknown one probably means.
std::optional<std::string_view> Meant(std::string_view name, const std::vector<std::string_view>& legal) {
  for (std::string_view candidate : legal)
    if (candidate == "fp:" + std::string(name) || "fp:" + std::string(candidate) == name) return candidate;
  return NearestName(name, legal);
}

std::vector<std::string_view> AttributeNames(const TagRule& rule) {
  std::vector<std::string_view> names;
  for (const AttributeRule& attribute : rule.attributes) names.push_back(attribute.name);
  return names;
}

/// Attributes with a prefix of others are not ours to judge.
bool IsForeignAttribute(std::string_view name) { return !PrefixOf(name).empty() && PrefixOf(name) != "fp"; }

}  // namespace

bool IsUnknownTag(const XMLElement& element) { return !IsForeign(element.Name()) && FindTags(element.Name()).empty(); }

bool HasUnknownTag(const XMLElement& element, std::string_view path) {
  for (const XMLElement* child : Children(element))
    if (!IsForeign(child->Name()) && FindTags(std::string(path) + "/" + child->Name()).empty()) return true;
  return false;
}

std::set<std::string, std::less<>> LostNames(const XMLElement& robot) {
  std::set<std::string, std::less<>> names;
  for (const XMLElement* element : Children(robot)) {
    const std::optional<std::string> name = AttributeText(*element, "name");
    if (IsUnknownTag(*element) && name) names.insert(*name);
    const TagRule* rule = FormOf(*element, element->Name());
    if (!rule || rule->opaque || name) continue;
    for (const auto* given = element->FirstAttribute(); given; given = given->Next())
      if (!FindAttribute(*rule, given->Name()) && Meant(given->Name(), AttributeNames(*rule)) == "name")
        names.insert(given->Value());
  }
  return names;
}

std::string SuggestLegal(std::string_view name, const std::vector<std::string_view>& legal) {
  if (const auto meant = Meant(name, legal)) return ", did you mean '" + std::string(*meant) + "'?";
  return legal.empty() ? ": none is legal here" : "; legal: " + Joined(legal);
}

namespace {

void CheckFormer(const XMLElement& element, const AttributeRule& attribute, FileFaults& faults) {
  const bool is_twice = AttributeText(element, attribute.name).has_value();
  faults.Report(is_twice ? kAttributeTwice : kAttributeFormer, LineOf(element, attribute.former),
                {std::string(attribute.former), Describe(element), std::string(attribute.name)});
}

}  // namespace

void CheckAttributes(const XMLElement& element, const TagRule& rule, FileFaults& faults) {
  const std::vector<std::string_view> legal = AttributeNames(rule);
  // Those given, rightly spelt or not.
  std::set<std::string_view> seen;
  for (const auto* given = element.FirstAttribute(); given; given = given->Next()) {
    const std::string_view name = given->Name();
    if (IsForeignAttribute(name)) continue;
    const AttributeRule* attribute = FindAttribute(rule, name);
    seen.insert(attribute ? attribute->name : Meant(name, legal).value_or(name));
    if (attribute) {
      if (name == attribute->former) CheckFormer(element, *attribute, faults);
      CheckAttribute(element, *attribute, given->Value(), LineOf(element, given->Name()), faults);
      continue;
    }
    faults.Report(kAttributeUnknown, LineOf(element, given->Name()),
                  {std::string(name), Describe(element), SuggestLegal(name, legal)});
  }
  for (const AttributeRule& attribute : rule.attributes)
    if (attribute.required && !seen.contains(attribute.name))
      faults.Report(kAttributeMissing, LineOf(element),
                    {Describe(element), std::string(attribute.name), Expectation(attribute)});
}

namespace {

/// The legal tags that the unknown children, which are reported, were probably meant to be.
std::set<std::string_view> MisspeltChildren(const XMLElement& element, std::string_view path) {
  const std::vector<std::string_view> legal = NamesOf(TagsBelow(path));
  std::set<std::string_view> meant;
  for (const XMLElement* child : Children(element))
    if (!IsForeign(child->Name()) && FindTags(std::string(path) + "/" + child->Name()).empty())
      if (const auto name = Meant(child->Name(), legal)) meant.insert(*name);
  return meant;
}

/// Children that stand too often or are missing.
void CheckOccurrences(const XMLElement& element, std::string_view path, FileFaults& faults) {
  const std::set<std::string_view> misspelt = MisspeltChildren(element, path);
  std::vector<std::string_view> choices;
  std::size_t chosen = 0;
  bool has_misspelt_choice = false;
  for (const TagRule* rule : TagsBelow(path)) {
    const std::string name(rule->Name());
    const std::vector<const XMLElement*> found = Children(element, name.c_str());
    if (rule->occurs == Occurs::kOneOfAll) {
      choices.push_back(rule->Name());
      chosen += found.size();
      has_misspelt_choice = has_misspelt_choice || misspelt.contains(name);
    }
    if (rule->occurs == Occurs::kOnce && found.empty() && !misspelt.contains(name))
      faults.Report(kTagMissing, LineOf(element), {Describe(element), name});
    if (rule->occurs != Occurs::kAny && rule->occurs != Occurs::kOneOfAll && found.size() > 1)
      faults.Report(kTagTwice, LineOf(*found[1]), {Describe(element), name});
  }
  if (!choices.empty() && chosen != 1 && !has_misspelt_choice)
    faults.Report(kNotOneLaw, LineOf(element), {Describe(element), Joined(choices)});
}

void ReportForm(const XMLElement& element, std::string_view path, FileFaults& faults) {
  std::vector<std::string_view> types;
  for (const TagRule* rule : FindTags(path)) types.push_back(rule->type);
  const std::optional<std::string> type = AttributeText(element, "type");
  if (!type) faults.Report(kTypeMissing, LineOf(element), {Describe(element), Joined(types)});
  else faults.Report(kTypeUnknown, LineOf(element), {*type, Describe(element), SuggestLegal(*type, types)});
}

void CheckElement(const XMLElement& element, const std::string& above, FileFaults& faults) {
  if (IsForeign(element.Name())) return;
  const std::string path = above.empty() ? element.Name() : above + "/" + element.Name();
  if (FindTags(path).empty()) {
    const std::string place = above.empty() ? "" : " in " + Describe(*element.Parent()->ToElement());
    faults.Report(kTagUnknown, LineOf(element),
                  {element.Name(), place, SuggestLegal(element.Name(), NamesOf(TagsBelow(above)))});
    return;
  }
  const TagRule* rule = FormOf(element, path);
  if (!rule) return ReportForm(element, path, faults);
  if (rule->opaque) return;
  CheckAttributes(element, *rule, faults);
  for (const XMLElement* child : Children(element)) CheckElement(*child, path, faults);
  CheckOccurrences(element, path, faults);
}

void CheckNames(const XMLElement& robot, FileFaults& faults) {
  std::map<std::pair<std::string, std::string>, int> lines;
  for (const XMLElement* element : Children(robot)) {
    const TagRule* rule = FormOf(*element, element->Name());
    const std::optional<std::string> name = AttributeText(*element, "name");
    if (!rule || rule->opaque || !name) continue;
    const auto [first, is_new] = lines.try_emplace({element->Name(), *name}, LineOf(*element));
    if (is_new) continue;
    faults.Report(kNameTaken, LineOf(*element), {Describe(*element), std::to_string(first->second)});
  }
}

}  // namespace

void CheckTags(const XMLElement& robot, FileFaults& faults) {
  PrefixCheck prefixes(faults);
  prefixes.Walk(robot);
  prefixes.CheckDeclaration(robot);
  if (AttributeText(robot, "name").value_or("").empty())
    faults.Report(kAttributeMissing, LineOf(robot), {"<robot>", "name", ""});
  for (const XMLElement* child : Children(robot)) CheckElement(*child, "", faults);
  CheckNames(robot, faults);
}

}  // namespace fourpost
