#include "vehicles/tags/tag_table.h"

namespace fourpost {
namespace {

std::string ChoicesText(const AttributeRule& rule) {
  std::string text;
  for (std::string_view choice : rule.choices) text += (text.empty() ? "`" : " or `") + std::string(choice) + "`";
  return text;
}

std::string KindText(const AttributeRule& rule) {
  switch (rule.kind) {
    case AttributeKind::kText: return "text";
    case AttributeKind::kName: return "name";
    case AttributeKind::kLink: return "link";
    case AttributeKind::kPoint: return "frame or link";
    case AttributeKind::kTyre: return "tyre";
    case AttributeKind::kTreeNumber: return "path";
    case AttributeKind::kNumber: return "number";
    case AttributeKind::kVector: return "x y z";
    case AttributeKind::kDirection: return "x y z, not zero";
    case AttributeKind::kQuantity: return "number with unit";
    case AttributeKind::kScalar:
      return DimensionName(rule.dimension) + " in " + SiUnit(rule.dimension) + " or the like";
    case AttributeKind::kChoice: return ChoicesText(rule);
  }
  return "";
}

std::string SignText(Sign sign) {
  if (sign == Sign::kAny) return "";
  return sign == Sign::kPositive ? ", > 0" : ", >= 0";
}

std::string UsualText(const AttributeRule& rule) {
  const std::string least(rule.usual_least);
  const std::string greatest(rule.usual_greatest);
  if (greatest.empty()) return "";
  return least.empty() ? "; usually up to " + greatest : "; usually " + least + " to " + greatest;
}

std::string DefaultText(const AttributeRule& rule) {
  if (rule.required) return "required";
  return rule.fallback.empty() ? "none" : "`" + std::string(rule.fallback) + "`";
}

std::string Row(const AttributeRule& rule) {
  return "| `" + std::string(rule.name) + "` | " + KindText(rule) + SignText(rule.sign) + UsualText(rule) + " | " +
         DefaultText(rule) + " | " + std::string(rule.doc) + " |\n";
}

std::string OccursText(const TagRule& tag) {
  if (tag.occurs == Occurs::kAtMostOnce) return "May be left out.";
  if (tag.occurs != Occurs::kOneOfAll) return "";
  std::string names;
  for (const TagRule* sibling : TagsBelow(tag.path.substr(0, tag.path.rfind('/'))))
    if (sibling->occurs == Occurs::kOneOfAll)
      names += (names.empty() ? "`" : ", `") + std::string(sibling->Name()) + "`";
  return "Stands once, as the only one of " + names + ".";
}

std::string Heading(const TagRule& tag) {
  const std::size_t slash = tag.path.rfind('/');
  std::string text = slash == std::string_view::npos ? "### " : "#### ";
  text += "`<" + std::string(tag.Name());
  if (!tag.type.empty()) text += " type=\"" + std::string(tag.type) + "\"";
  text += ">`";
  if (slash != std::string_view::npos) text += " in `<" + std::string(tag.path.substr(0, slash)) + ">`";
  return text;
}

}  // namespace

std::string TagReference() {
  std::string text;
  for (const TagRule& tag : OwnTags()) {
    const std::string occurs = OccursText(tag);
    text += Heading(tag) + "\n" + std::string(tag.doc) + (occurs.empty() ? "" : "\n" + occurs) + "\n\n";
    if (!tag.attributes.empty()) text += "| attribute | value | default | meaning |\n|---|---|---|---|\n";
    for (const AttributeRule& attribute : tag.attributes) text += Row(attribute);
    if (!tag.attributes.empty()) text += "\n";
  }
  return text;
}

}  // namespace fourpost
