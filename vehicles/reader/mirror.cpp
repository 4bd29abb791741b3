#include "vehicles/reader/mirror.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/attribute_check.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Each mirror walks through the whole file; a car has one, or one an axle.
constexpr std::size_t kMostMirrors = 8;

enum class VectorKind { kPolar, kAxial };

bool IsOwn(const XMLElement& element) { return std::string_view(element.Name()).starts_with("fp:"); }

bool CanHaveTwin(const XMLElement& element) {
  const std::string_view tag = element.Name();
  if (tag == "fp:parameter" || tag == "fp:mirror") return false;
  const TagRule* rule = FormOf(element, tag);
  return IsOwn(element) || (rule && !rule->opaque);
}

std::string NameOrLink(const XMLElement& element) {
  if (std::optional<std::string> name = AttributeText(element, "name")) return *std::move(name);
  return IsOwn(element) ? AttributeText(element, "link").value_or("") : "";
}

/// The link of a path such as "link[body]/mass"; empty: none.
std::string LinkOf(const std::string& path) {
  const std::string_view head = "link[";
  const std::size_t end = path.find("]/");
  return path.starts_with(head) && end != std::string::npos ? path.substr(head.size(), end - head.size()) : "";
}

/// "_left" of "wheel_left"; the whole of a name in one piece.
std::string EndOf(const std::string& name) {
  const std::size_t mark = name.find_last_of("_-.");
  return mark == std::string::npos ? name : name.substr(mark);
}

std::string Negated(const std::string& text) {
  const std::optional<double> number = ParseNumber(Trimmed(text));
  if (!number) return text;
  return FormatNumber(*number == 0 ? 0 : -*number);
}

/// Of a length with its unit, or of a parameter: "2 mm", "$dy", "-0.5*$dy".
std::string NegatedShift(const std::string& text) {
  const std::string shift(Trimmed(text));
  if (const auto quantity = ParseQuantity(shift); quantity && quantity->si == 0) return shift;
  if (shift.starts_with('-')) return shift.substr(1);
  const std::string magnitude = shift.starts_with('+') ? shift.substr(1) : shift;
  return magnitude.empty() ? shift : "-" + magnitude;
}

std::string Mirrored(const std::string& text, VectorKind kind) {
  const std::optional<Eigen::Vector3d> vector = ParseVector(text);
  if (!vector) return text;
  const std::string x = FormatNumber(vector->x());
  const std::string y = FormatNumber(vector->y());
  const std::string z = FormatNumber(vector->z());
  return kind == VectorKind::kPolar ? x + " " + Negated(y) + " " + z : Negated(x) + " " + y + " " + Negated(z);
}

/// Whether the element's axis is one of turning.
bool Turns(const XMLElement& element) {
  const std::string type = AttributeText(element, "type").value_or("");
  return type == "revolute" || type == "continuous" || type == "gyro" || std::string_view(element.Name()) == "fp:hinge";
}

/// Whether the partner of a number of the tree, such as "link[body]/com/y", has the other sign.
bool ChangesSign(std::string_view path) {
  return path.ends_with("/com/y") || path.ends_with("/ixy") || path.ends_with("/iyz");
}

/// Writes out the vectors that stand for what is left out, for their mirror image may be another.
void WriteDefaults(XMLElement& element) {
  if (const TagRule* rule = FormOf(element, element.Name()))
    for (const AttributeRule& attribute : rule->attributes)
      if (attribute.kind == AttributeKind::kDirection && !attribute.fallback.empty() &&
          !AttributeText(element, attribute.name))
        element.SetAttribute(std::string(attribute.name).c_str(), std::string(attribute.fallback).c_str());
  if (std::string_view(element.Name()) != "joint" || !Turns(element) || element.FirstChildElement("axis")) return;
  XMLElement& axis = *element.GetDocument()->NewElement("axis");
  axis.SetAttribute("xyz", "1 0 0");
  element.InsertEndChild(&axis);
}

class Mirror {
 public:
  Mirror(XMLElement& robot, FileFaults& faults) : robot_(robot), faults_(faults) {
    for (XMLElement* element : Children(robot)) {
      if (!CanHaveTwin(*element)) continue;
      written_.push_back(element);
      taken_.insert({element->Name(), NameOrLink(*element)});
    }
    for (XMLElement* parameter : Children(robot, "fp:parameter"))
      for (XMLElement* bind : Children(*parameter, "fp:bind")) {
        binds_.push_back(bind);
        bound_.insert(AttributeText(*bind, "to").value_or(""));
      }
  }

  void Add(const Tag& tag) {
    const std::string from = tag.Text("from");
    const std::string to = tag.Text("to");
    if (from.empty() || to.empty()) return;
    if (from == to) return Fault(kMirrorEnds, tag, "to");
    const auto [first, is_new] = mirrors_.try_emplace({from, to}, tag.Line());
    if (!is_new) return Fault(kMirrorTwice, tag, "from", {std::to_string(first->second)});
    FindTwins(from, to);
    if (twins_.empty()) return Fault(kMirrorNothing, tag, "from", {DidYouMean(from, Ends())});
    for (XMLElement* element : written_)
      if (AttributeText(*element, "name")) AddTwin(*element, from);
    for (XMLElement* element : written_)
      if (!AttributeText(*element, "name") && made_links_.contains(TwinOf(NameOrLink(*element))))
        AddTwin(*element, from);
    for (XMLElement* bind : binds_) AddTwinOfBind(*bind);
  }

  const TwinNames& made() const { return made_; }

 private:
  /// `words` follow the attribute.
  void Fault(const Finding& kind, const Tag& tag, std::string_view attribute, std::vector<std::string> words = {}) {
    words.insert(words.begin(), Quoted(attribute, tag));
    faults_.Report(kind, tag.Line(attribute), words);
  }

  std::vector<std::string> Ends() const {
    std::set<std::string> ends;
    for (const XMLElement* element : written_) ends.insert(EndOf(NameOrLink(*element)));
    return {ends.begin(), ends.end()};
  }

  void FindTwins(const std::string& from, const std::string& to) {
    twins_.clear();
    made_links_.clear();
    for (const XMLElement* element : written_) {
      const std::string name = NameOrLink(*element);
      if (!name.ends_with(from)) continue;
      const std::string twin = name.substr(0, name.size() - from.size()) + to;
      twins_[name] = twin;
      twins_[twin] = name;
    }
  }

  /// The other name of the two; the name itself when it has no partner.
  std::string TwinOf(const std::string& name) const {
    const auto found = twins_.find(name);
    return found == twins_.end() ? name : found->second;
  }

  void AddTwin(XMLElement& element, const std::string& from) {
    const std::string name = NameOrLink(element);
    const std::string twin_name = TwinOf(name);
    if (!name.ends_with(from) || !taken_.insert({element.Name(), twin_name}).second) return;
    if (IsItsOwnTwin(element)) {
      faults_.Report(kMirrorOfItself, LineOf(element, "name"), {Describe(element), from});
      return;
    }
    XMLElement& twin = CopyOf(element);
    WriteDefaults(twin);
    Reflect(twin, Turns(twin));
    if (AttributeText(twin, "name")) twin.SetAttribute("name", twin_name.c_str());
    made_.try_emplace(twin_name, name);
    robot_.InsertAfterChild(&element, &twin);
    if (std::string_view(element.Name()) == "link") made_links_.insert(twin_name);
  }

  /// Whether it is an anti-roll bar whose left line the mirror turns into its right one.
  bool IsItsOwnTwin(const XMLElement& element) const {
    if (std::string_view(element.Name()) != "fp:antiroll") return false;
    const XMLElement* left = element.FirstChildElement("left");
    const XMLElement* right = element.FirstChildElement("right");
    const auto is_twin = [&](const char* end) {
      return TwinOf(AttributeText(*left, end).value_or("")) == AttributeText(*right, end).value_or("");
    };
    return left && right && is_twin("parent") && is_twin("child");
  }

  void Reflect(XMLElement& element, bool turns) const {
    for (const auto* given = element.FirstAttribute(); given; given = given->Next())
      element.SetAttribute(given->Name(), Reflected(element, given->Name(), given->Value(), turns).c_str());
    for (XMLElement* child : Children(element)) Reflect(*child, turns);
  }

  std::string Reflected(const XMLElement& element, std::string_view attribute, const std::string& text,
                        bool turns) const {
    const std::string_view tag = element.Name();
    const VectorKind axis = turns ? VectorKind::kAxial : VectorKind::kPolar;
    if (attribute == "xyz") return Mirrored(text, tag == "axis" ? axis : VectorKind::kPolar);
    if (attribute == "axis") return Mirrored(text, axis);
    if (attribute == "rpy") return Mirrored(text, VectorKind::kAxial);
    if (tag == "mesh" && attribute == "scale") return Mirrored(text, VectorKind::kPolar);
    if (tag == "inertia" && (attribute == "ixy" || attribute == "iyz")) return Negated(text);
    if (tag == "fp:frame" && attribute == "dy") return NegatedShift(text);
    return attribute == "name" || attribute == "filename" ? text : TwinOf(text);
  }

  void AddTwinOfBind(XMLElement& bind) {
    const std::string path = AttributeText(bind, "to").value_or("");
    const std::string link = LinkOf(path);
    const std::string twin = TwinOf(link);
    if (made_links_.contains(link)) {
      faults_.Report(kBindMirrored, LineOf(bind, "to"), {"to=\"" + path + "\" of " + Describe(bind), twin, link});
      return;
    }
    const std::string twin_path = "link[" + twin + path.substr(std::min(path.size(), path.find("]/")));
    if (!made_links_.contains(twin) || bound_.contains(twin_path)) return;
    XMLElement& made = CopyOf(bind);
    made.SetAttribute("to", twin_path.c_str());
    if (ChangesSign(path)) made.SetAttribute("factor", Negated(AttributeText(bind, "factor").value_or("1")).c_str());
    bind.Parent()->InsertAfterChild(&bind, &made);
  }

  XMLElement& robot_;
  FileFaults& faults_;
  /// What may have a partner, without those made.
  std::vector<XMLElement*> written_;
  std::vector<XMLElement*> binds_;
  /// Tags and names that stand already.
  std::set<std::pair<std::string, std::string>> taken_;
  std::set<std::string> bound_;
  /// Of the mirror at work: names and their partners, both ways, and links made by it.
  std::map<std::string, std::string> twins_;
  std::set<std::string> made_links_;
  /// Ends of the mirrors so far, and their lines.
  std::map<std::pair<std::string, std::string>, int> mirrors_;
  TwinNames made_;
};

}  // namespace

TwinNames AddTwins(XMLElement& robot, FileFaults& faults) {
  const std::vector<Tag> tags = TagsOf(robot, "fp:mirror");
  if (tags.size() > kMostMirrors) {
    faults.Report(kMirrorCount, tags[kMostMirrors].Line(), {std::to_string(kMostMirrors)});
    return {};
  }
  Mirror mirror(robot, faults);
  for (const Tag& tag : tags) mirror.Add(tag);
  return mirror.made();
}

}  // namespace fourpost
