#include "vehicles/reader/tree_reference.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/parameter_uses.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

std::vector<std::string> SplitAtBlanks(const std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string::npos;) {
    const std::size_t end = text.find_first_of(kBlanks, at);
    words.push_back(text.substr(at, end == std::string::npos ? end : end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

class TreeReferences {
 public:
  TreeReferences(XMLElement& robot, FileFaults* faults) : robot_(robot), faults_(faults) {
    for (XMLElement* parameter : Children(robot, "fp:parameter"))
      parameters_.try_emplace(NameOf(*parameter), parameter);
  }

  bool Replace() {
    for (XMLElement* link : Children(robot_, "link"))
      for (XMLElement* inertial : Children(*link, "inertial")) {
        const std::string path = "link[" + NameOf(*link) + "]/";
        for (XMLElement* mass : Children(*inertial, "mass")) ReplaceOne(*mass, "value", path + "mass");
        for (XMLElement* inertia : Children(*inertial, "inertia"))
          for (const char* moment : {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"})
            ReplaceOne(*inertia, moment, path + "inertia/" + moment);
        for (XMLElement* origin : Children(*inertial, "origin")) ReplaceCom(*origin, path + "com/");
      }
    return has_any_;
  }

 private:
  void ReplaceOne(XMLElement& element, const char* attribute, const std::string& path) {
    const std::string text = AttributeText(element, attribute).value_or("");
    if (!HasReference(text)) return;
    element.SetAttribute(attribute, Resolved(element, attribute, text, path).c_str());
  }

  void ReplaceCom(XMLElement& origin, const std::string& path) {
    const std::string text = AttributeText(origin, "xyz").value_or("");
    if (!HasReference(text)) return;
    const std::vector<std::string> words = SplitAtBlanks(text);
    constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
    std::string numbers;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool is_reference = i < kAxes.size() && HasReference(words[i]);
      numbers += (i == 0 ? "" : " ") + (is_reference ? Resolved(origin, "xyz", words[i], path + kAxes[i]) : words[i]);
    }
    origin.SetAttribute("xyz", numbers.c_str());
  }

  /// The number that a reference stands for; that of a faulty one is 1, so that it causes no further fault.
  std::string Resolved(XMLElement& element, const char* attribute, const std::string& text, const std::string& path) {
    has_any_ = true;
    const int line = LineOf(element, attribute);
    const std::optional<ParameterReference> reference = ParseReference(text);
    if (!reference) {
      if (faults_) faults_->Report(kTreeReferenceUnreadable, line, {text, Describe(element)});
      return "1";
    }
    const auto found = parameters_.find(reference->name);
    if (found == parameters_.end()) {
      std::vector<std::string> names;
      for (const auto& [name, parameter] : parameters_) names.push_back(name);
      if (faults_)
        faults_->Report(kParameterUnknown, line,
                        {"\"" + text + "\" in " + Describe(element), std::string(reference->name),
                         faults_->IsShown() ? DidYouMeanOrAll(reference->name, names) : ""});
      return "1";
    }
    AddBind(*found->second, element, path, reference->factor);
    // A value without a number is a fault of the parameter.
    const std::optional<Quantity> value = ParseQuantity(Trimmed(AttributeText(*found->second, "value").value_or("")));
    return value ? FormatNumber(reference->factor * value->si) : "1";
  }

  static void AddBind(XMLElement& parameter, XMLElement& element, const std::string& path, double factor) {
    XMLElement& bind = *parameter.GetDocument()->NewElement("fp:bind");
    bind.SetAttribute("to", path.c_str());
    bind.SetAttribute("factor", FormatNumber(factor).c_str());
    SetOrigin(bind, element);
    parameter.InsertEndChild(&bind);
  }

  XMLElement& robot_;
  FileFaults* faults_;
  std::map<std::string, XMLElement*, std::less<>> parameters_;
  bool has_any_ = false;
};

}  // namespace

bool ReplaceTreeReferences(XMLElement& robot, FileFaults* faults) { return TreeReferences(robot, faults).Replace(); }

bool HasReference(std::string_view text) { return std::count(text.begin(), text.end(), '$') > 0; }

bool IsTreeReference(const XMLElement& bind) {
  const auto* origin = static_cast<const XMLElement*>(bind.GetUserData());
  return origin && std::string_view(origin->Name()) != "fp:bind";
}

std::string TreeReferenceText(const XMLElement& bind) {
  const std::string factor = AttributeText(bind, "factor").value_or("1");
  const std::string name = NameOf(*bind.Parent()->ToElement());
  return "\"" + (factor == "1" ? "" : factor + "*") + "$" + name + "\" in " + Describe(Written(bind));
}

}  // namespace fourpost
