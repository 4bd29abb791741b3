#include "vehicles/reader/tree_binding.h"

#include <optional>
#include <set>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/reader/tree_reference.h"
#include "vehicles/tags/attribute_check.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// "link[body]/mass" in its parts.
struct TreePath {
  std::string link;
  std::string number;
};

std::optional<TreePath> ParsePath(std::string_view text) {
  constexpr std::string_view kHead = "link[";
  const std::size_t end = text.find("]/");
  if (!text.starts_with(kHead) || end == std::string_view::npos) return std::nullopt;
  return TreePath{std::string(text.substr(kHead.size(), end - kHead.size())), std::string(text.substr(end + 2))};
}

const std::vector<std::string>& NumberNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> made = {"mass"};
    for (const char* name : kInertiaNames) made.push_back(std::string("inertia/") + name);
    for (const char* name : {"x", "y", "z"}) made.push_back(std::string("com/") + name);
    return made;
  }();
  return names;
}

int FindNumber(std::string_view name) {
  const std::vector<std::string>& names = NumberNames();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<int>(i);
  return -1;
}

constexpr int kFirstCom = 7;

Dimension DimensionOf(int number) { return number == 0 ? kMass : number < kFirstCom ? kInertia : kLength; }

/// Whether the number's place in the link has a fault of its own, which is reported: a misspelt tag, or a required one
/// that is missing or holds no number.
bool IsFaulty(const XMLElement& link, int number) {
  const XMLElement* inertial = link.FirstChildElement("inertial");
  const XMLElement* origin = inertial ? inertial->FirstChildElement("origin") : nullptr;
  if (!inertial) return HasUnknownTag(link, "link");
  if (number < kFirstCom) return true;
  return origin ? AttributeText(*origin, "xyz").has_value() : HasUnknownTag(*inertial, "link/inertial");
}

/// The number as the link gives it; nothing when it gives none.
std::optional<double> Literal(const XMLElement& link, int number) {
  const XMLElement* inertial = link.FirstChildElement("inertial");
  if (number >= kFirstCom) {
    const XMLElement* origin = inertial ? inertial->FirstChildElement("origin") : nullptr;
    if (!origin) return std::nullopt;
    const std::optional<Eigen::Vector3d> xyz = ParseVector(AttributeText(*origin, "xyz").value_or(""));
    return xyz ? std::optional<double>((*xyz)[number - kFirstCom]) : std::nullopt;
  }
  const XMLElement* element = inertial ? inertial->FirstChildElement(number == 0 ? "mass" : "inertia") : nullptr;
  const char* attribute = number == 0 ? "value" : kInertiaNames[number - 1];
  if (!element) return std::nullopt;
  return ParseNumber(Trimmed(AttributeText(*element, attribute).value_or("")));
}

bool HasTurnedInertia(const XMLElement& link) {
  const XMLElement* inertial = link.FirstChildElement("inertial");
  const XMLElement* origin = inertial ? inertial->FirstChildElement("origin") : nullptr;
  if (!origin) return false;
  const std::optional<Eigen::Vector3d> rpy = ParseVector(AttributeText(*origin, "rpy").value_or("0 0 0"));
  return rpy && !rpy->isZero(0);
}

class BindingReader {
 public:
  BindingReader(const XMLElement& robot, const UrdfTree& tree, const ParameterReader& parameters, FileFaults& faults)
      : tree_(tree), parameters_(parameters), faults_(faults), lost_names_(LostNames(robot)) {}

  void Read(const Tag& bind) {
    TreeBinding binding;
    if (!Resolve(bind, binding)) return;
    const XMLElement& link = *tree_.links[static_cast<std::size_t>(binding.link)];
    const std::optional<double> literal = Literal(link, binding.number);
    if (!literal && IsFaulty(link, binding.number)) return faults_.Follow();
    if (!literal) return Fault(kBindNumberMissing, bind, {Describe(link)});
    if (binding.number > 0 && binding.number < kFirstCom && HasTurnedInertia(link)) return Fault(kBindTurned, bind);
    if (!seen_.insert({binding.link, binding.number}).second) return Fault(kBindTwice, bind);
    const std::optional<Scalar> scalar = parameters_.Bind(bind, *literal, DimensionOf(binding.number));
    if (!scalar) return;
    binding.scalar = *scalar;
    bindings_.push_back(binding);
  }

  const std::vector<TreeBinding>& bindings() const { return bindings_; }

 private:
  /// `words` follow the attribute.
  void Fault(const Finding& kind, const Tag& bind, std::vector<std::string> words = {}) {
    const bool is_reference = IsTreeReference(*bind.element);
    if (IsMade(*bind.element) && !is_reference) return faults_.Follow();
    words.insert(words.begin(), is_reference ? TreeReferenceText(*bind.element) : Quoted("to", bind));
    faults_.Report(kind, bind.Line("to"), words);
  }

  bool Resolve(const Tag& bind, TreeBinding& binding) {
    const std::string text = bind.Text("to");
    if (text.empty()) return false;
    const std::optional<TreePath> path = ParsePath(text);
    if (!path) {
      Fault(kBindUnreadable, bind);
      return false;
    }
    binding.link = tree_.FindLink(path->link);
    binding.number = FindNumber(path->number);
    if (binding.link < 0 && lost_names_.contains(path->link)) faults_.Follow();
    else if (binding.link < 0) Fault(kBindLinkUnknown, bind, {path->link, tree_.LinkMeant(path->link, faults_)});
    if (binding.number < 0) Fault(kBindNumberUnknown, bind, {path->number, DidYouMean(path->number, NumberNames())});
    return binding.link >= 0 && binding.number >= 0;
  }

  const UrdfTree& tree_;
  const ParameterReader& parameters_;
  FileFaults& faults_;
  std::set<std::string, std::less<>> lost_names_;
  std::set<std::pair<int, int>> seen_;
  std::vector<TreeBinding> bindings_;
};

}  // namespace

std::optional<Dimension> DimensionOfPath(std::string_view path) {
  const std::optional<TreePath> parts = ParsePath(path);
  const int number = parts ? FindNumber(parts->number) : -1;
  return number < 0 ? std::nullopt : std::optional(DimensionOf(number));
}

Sign SignOfPath(std::string_view path) {
  constexpr int kLastMoment = 3;
  const std::optional<TreePath> parts = ParsePath(path);
  const int number = parts ? FindNumber(parts->number) : -1;
  return number >= 0 && number <= kLastMoment ? Sign::kNotNegative : Sign::kAny;
}

std::vector<TreeBinding> ReadTreeBindings(const XMLElement& robot, const UrdfTree& tree,
                                          const ParameterReader& parameters, FileFaults& faults) {
  BindingReader reader(robot, tree, parameters, faults);
  for (const Tag& parameter : TagsOf(robot, "fp:parameter"))
    for (const Tag& bind : TagsOf(*parameter.element, "fp:parameter/fp:bind")) reader.Read(bind);
  return reader.bindings();
}

void Apply(const std::vector<TreeBinding>& bindings, Vehicle& vehicle) {
  for (const TreeBinding& binding : bindings) {
    Link& link = vehicle.links[static_cast<std::size_t>(binding.link)];
    const auto number = static_cast<std::size_t>(binding.number);
    if (binding.number == 0) link.mass = binding.scalar;
    else if (binding.number < kFirstCom) link.inertia[number - 1] = binding.scalar;
    else link.com[number - kFirstCom] = binding.scalar;
  }
}

}  // namespace fourpost
