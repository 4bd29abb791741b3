#include "vehicles/reader/parameter_uses.h"

#include <algorithm>
#include <cctype>

#include "analysis/text/number.h"
#include "vehicles/reader/tree_binding.h"
#include "vehicles/reader/tree_reference.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

bool IsOfParameterName(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view NameAtBegin(std::string_view text) {
  return text.substr(
      0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), IsOfParameterName) - text.begin()));
}

/// The factor before a '$': "" is 1, "-" is -1, "0.5*" is 0.5.
std::optional<double> ParseFactor(std::string_view text) {
  if (text.empty()) return 1;
  if (text == "-") return -1;
  if (text.back() != '*') return std::nullopt;
  return ParseNumber(Trimmed(text.substr(0, text.size() - 1)));
}

class UseFinder {
 public:
  void Walk(const XMLElement& element, const std::string& path) {
    const TagRule* rule = FormOf(element, path);
    if (rule && rule->opaque) return;
    if (!IsMade(element))
      for (const auto* given = element.FirstAttribute(); given; given = given->Next())
        FindIn(given->Value(), rule ? FindAttribute(*rule, given->Name()) : nullptr, given->GetLineNum(),
               std::string(given->Name()) + " of " + Describe(element));
    for (const XMLElement* child : Children(element)) Walk(*child, path + "/" + child->Name());
  }

  void AddBind(const XMLElement& parameter, const XMLElement& bind) {
    if (IsMade(bind) && !IsTreeReference(bind)) return;
    const std::string path = AttributeText(bind, "to").value_or("");
    uses_.push_back({.parameter = AttributeText(parameter, "name").value_or(""),
                     .dimension = DimensionOfPath(path),
                     .sign = SignOfPath(path),
                     .factor = ParseNumber(Trimmed(AttributeText(bind, "factor").value_or("1"))).value_or(1),
                     .line = LineOf(bind),
                     .what = path});
  }

  std::vector<ParameterUse> uses() const { return uses_; }

 private:
  void FindIn(std::string_view text, const AttributeRule* rule, int line, const std::string& what) {
    if (rule && rule->kind != AttributeKind::kScalar) return;
    if (const auto reference = ParseReference(text)) {
      uses_.push_back({.parameter = std::string(reference->name),
                       .dimension = rule ? std::optional(rule->dimension) : std::nullopt,
                       .sign = rule ? rule->sign : Sign::kAny,
                       .factor = reference->factor,
                       .line = line,
                       .what = what});
      return;
    }
    if (const auto forgotten = ReferenceWithoutDollar(text)) AddUnread(forgotten->name, line, what);
    for (std::size_t at = text.find('$'); at != std::string_view::npos; at = text.find('$', at + 1))
      AddUnread(NameAtBegin(text.substr(at + 1)), line, what);
  }

  void AddUnread(std::string_view parameter, int line, const std::string& what) {
    uses_.push_back({.parameter = std::string(parameter), .dimension = std::nullopt, .line = line, .what = what});
  }

  std::vector<ParameterUse> uses_;
};

}  // namespace

std::optional<ParameterReference> ParseReference(std::string_view text) {
  text = Trimmed(text);
  const std::size_t dollar = text.find('$');
  if (dollar == std::string_view::npos) return std::nullopt;
  const std::optional<double> factor = ParseFactor(Trimmed(text.substr(0, dollar)));
  const std::string_view name = text.substr(dollar + 1);
  if (!factor || name.empty() || NameAtBegin(name) != name) return std::nullopt;
  return ParameterReference{*factor, name};
}

std::optional<ParameterReference> ReferenceWithoutDollar(std::string_view text) {
  text = Trimmed(text);
  const auto begin = std::find_if_not(text.rbegin(), text.rend(), IsOfParameterName).base() - text.begin();
  const std::string_view name = text.substr(static_cast<std::size_t>(begin));
  const std::optional<double> factor = ParseFactor(Trimmed(text.substr(0, text.size() - name.size())));
  if (!factor || name.empty() || std::isdigit(static_cast<unsigned char>(name.front()))) return std::nullopt;
  return ParameterReference{*factor, name};
}

std::vector<ParameterUse> FindParameterUses(const XMLElement& robot) {
  UseFinder finder;
  for (const XMLElement* element : Children(robot)) {
    if (std::string_view(element->Name()) != "fp:parameter") finder.Walk(*element, element->Name());
    else
      for (const XMLElement* bind : Children(*element, "fp:bind")) finder.AddBind(*element, *bind);
  }
  return finder.uses();
}

std::vector<ParameterUse> FindParameterUses(const std::string& text) {
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  XMLElement* const robot = document.RootElement();
  if (robot) ReplaceTreeReferences(*robot, nullptr);
  return robot ? FindParameterUses(*robot) : std::vector<ParameterUse>();
}

}  // namespace fourpost
