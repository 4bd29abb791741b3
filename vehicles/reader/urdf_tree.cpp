#include "vehicles/reader/urdf_tree.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/text/nearest.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// The link at an end ("parent", "child") of a joint; empty when it is not given.
std::string End(const XMLElement& joint, const char* end) {
  const XMLElement* found = joint.FirstChildElement(end);
  return found ? AttributeText(*found, "link").value_or("") : "";
}

int CoordinatesOf(const XMLElement& joint) {
  const std::string type = AttributeText(joint, "type").value_or("");
  return type == "floating" ? 6 : type == "planar" ? 3 : type == "fixed" ? 0 : 1;
}

class TreeReader {
 public:
  TreeReader(const XMLElement& robot, FileFaults& faults)
      : faults_(faults),
        lost_names_(LostNames(robot)),
        joints_(Children(robot, "joint")),
        tree_{.links = Children(robot, "link"), .joints = {}, .link_index = {}} {
    for (const XMLElement* element : Children(robot)) sound_ = sound_ && !IsMisspeltJoint(*element);
  }

  UrdfTree Read() {
    tree_.IndexLinks();
    for (const XMLElement* joint : joints_) {
      CheckEnd(*joint, "parent");
      CheckEnd(*joint, "child");
      CheckLimit(*joint);
      AddParent(*joint);
    }
    PutGroundFirst();
    OrderJoints();
    CountCoordinates();
    return tree_;
  }

 private:
  static bool IsMisspeltJoint(const XMLElement& element) {
    return IsUnknownTag(element) && element.FirstChildElement("child") != nullptr;
  }

  void CheckEnd(const XMLElement& joint, const char* end) {
    const std::string link = End(joint, end);
    if (link.empty() || tree_.FindLink(link) >= 0) return;
    sound_ = false;
    if (lost_names_.contains(link)) return;
    faults_.Report(kJointLink, LineOf(*joint.FirstChildElement(end)),
                   {Describe(joint), end, link, tree_.LinkMeant(link, faults_)});
  }

  void CheckLimit(const XMLElement& joint) {
    const std::string type = AttributeText(joint, "type").value_or("");
    if ((type != "revolute" && type != "prismatic") || joint.FirstChildElement("limit")) return;
    faults_.Report(kJointLimit, LineOf(joint),
                   {Describe(joint), type, type == "revolute" ? ", or make it continuous" : ""});
  }

  void AddParent(const XMLElement& joint) {
    const std::string child = End(joint, "child");
    if (child.empty() || End(joint, "parent").empty()) {
      sound_ = false;
      return;
    }
    const auto [first, is_new] = parent_joint_.try_emplace(child, &joint);
    if (is_new) return;
    faults_.Report(kJointTwoParents, LineOf(joint), {child, Describe(*first->second), Describe(joint)});
    sound_ = false;
  }

  void PutGroundFirst() {
    const auto is_root = [&](const XMLElement* link) { return !parent_joint_.contains(NameOf(*link)); };
    const auto ground = std::find_if(tree_.links.begin(), tree_.links.end(), is_root);
    if (ground == tree_.links.end()) {
      const bool is_reported = !sound_ || !lost_names_.empty();
      if (!is_reported) faults_.Report(tree_.links.empty() ? kLinkNone : kGroundNone, 0);
      sound_ = false;
      return;
    }
    std::rotate(tree_.links.begin(), ground, ground + 1);
    tree_.IndexLinks();
    // A joint with a fault of its own may be what is missing here.
    if (!sound_) return;
    CheckGround(*tree_.links.front());
    const std::string name = NameOf(*tree_.links.front());
    for (std::size_t i = 1; i < tree_.links.size(); ++i)
      if (is_root(tree_.links[i]) && NameOf(*tree_.links[i]) != name)
        faults_.Report(kGroundSecond, LineOf(*tree_.links[i]), {Describe(*tree_.links[i]), name});
  }

  void CheckGround(const XMLElement& ground) {
    if (const XMLElement* inertial = ground.FirstChildElement("inertial"))
      faults_.Report(kGroundInertial, LineOf(*inertial), {Describe(ground)});
  }

  /// Goes on from the ground; what it never reaches is a loop.
  void OrderJoints() {
    if (!sound_) return;
    std::multimap<std::string, const XMLElement*> joints_of;
    for (const XMLElement* joint : joints_) joints_of.emplace(End(*joint, "parent"), joint);
    std::vector<std::string> reached;
    std::set<const XMLElement*> ordered;
    for (const XMLElement* link : tree_.links)
      if (!parent_joint_.contains(NameOf(*link))) reached.push_back(NameOf(*link));
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const auto [begin, end] = joints_of.equal_range(reached[i]);
      for (auto joint = begin; joint != end; ++joint) {
        tree_.joints.push_back(joint->second);
        ordered.insert(joint->second);
        reached.push_back(End(*joint->second, "child"));
      }
    }
    for (const XMLElement* joint : joints_)
      if (!ordered.contains(joint)) faults_.Report(kJointLoop, LineOf(*joint), {Describe(*joint)});
  }

  void CountCoordinates() {
    int count = 0;
    for (const XMLElement* joint : joints_) count += CoordinatesOf(*joint);
    if (count <= kMostJointCoordinates) return;
    faults_.Report(kJointCoordinates, 0, {std::to_string(count), std::to_string(kMostJointCoordinates)});
  }

  FileFaults& faults_;
  std::set<std::string, std::less<>> lost_names_;
  std::vector<const XMLElement*> joints_;
  UrdfTree tree_;
  std::map<std::string, const XMLElement*> parent_joint_;
  bool sound_ = true;
};

}  // namespace

std::vector<std::string> UrdfTree::LinkNames() const {
  std::vector<std::string> names;
  for (const XMLElement* link : links) names.push_back(NameOf(*link));
  return names;
}

std::string UrdfTree::LinkMeant(std::string_view name, const FileFaults& faults) const {
  return faults.IsShown() ? DidYouMean(name, LinkNames()) : "";
}

void UrdfTree::IndexLinks() {
  link_index.clear();
  for (std::size_t i = 0; i < links.size(); ++i) link_index.try_emplace(NameOf(*links[i]), static_cast<int>(i));
}

int UrdfTree::FindLink(std::string_view name) const {
  const auto found = link_index.find(name);
  return found == link_index.end() ? -1 : found->second;
}

UrdfTree ReadUrdfTree(const XMLElement& robot, FileFaults& faults) { return TreeReader(robot, faults).Read(); }

}  // namespace fourpost
