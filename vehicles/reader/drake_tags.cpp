#include "vehicles/reader/drake_tags.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/line_reader.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Children of Drake's tags: a link or frame, three numbers, one number.
TagRule Name(std::string_view tag) {
  return {.path = tag, .attributes = {{.name = "name", .kind = AttributeKind::kName}}};
}
TagRule Vector(std::string_view tag) {
  return {.path = tag, .attributes = {{.name = "value", .kind = AttributeKind::kVector}}};
}
TagRule Number(std::string_view tag, Sign sign) {
  return {.path = tag, .attributes = {{.name = "value", .kind = AttributeKind::kNumber, .sign = sign}}};
}

/// The children of each tag; each stands once.
const std::map<std::string, std::vector<TagRule>, std::less<>>& Forms() {
  static const std::map<std::string, std::vector<TagRule>, std::less<>> forms = {
      {"drake:linear_spring_damper",
       {Name("drake:linear_spring_damper_body_A"), Vector("drake:linear_spring_damper_p_AP"),
        Name("drake:linear_spring_damper_body_B"), Vector("drake:linear_spring_damper_p_BQ"),
        Number("drake:linear_spring_damper_free_length", Sign::kPositive),
        Number("drake:linear_spring_damper_stiffness", Sign::kNotNegative),
        Number("drake:linear_spring_damper_damping", Sign::kNotNegative)}},
      {"drake:ball_constraint",
       {Name("drake:ball_constraint_body_A"), Vector("drake:ball_constraint_p_AP"),
        Name("drake:ball_constraint_body_B"), Vector("drake:ball_constraint_p_BQ")}},
      {"drake:linear_bushing_rpy",
       {Name("drake:bushing_frameA"), Name("drake:bushing_frameC"), Vector("drake:bushing_torque_stiffness"),
        Vector("drake:bushing_torque_damping"), Vector("drake:bushing_force_stiffness"),
        Vector("drake:bushing_force_damping")}}};
  return forms;
}

/// Axes of a frame in its link; those of the link for a link's name.
Eigen::Matrix3d FrameAxes(const XMLElement& robot, const std::string& name) {
  for (const XMLElement* frame : Children(robot, "fp:frame"))
    if (AttributeText(*frame, "name") == name)
      return TurnOf(ParseVector(AttributeText(*frame, "rpy").value_or("0 0 0")).value_or(Eigen::Vector3d(0, 0, 0)));
  return Eigen::Matrix3d::Identity();
}

class DrakeTags {
 public:
  DrakeTags(XMLElement& robot, FileFaults& faults)
      : robot_(robot), faults_(faults), replaced_(*robot.GetDocument()->NewElement("replaced")) {
    for (const XMLElement* element : Children(std::as_const(robot)))
      names_.insert(AttributeText(*element, "name").value_or(""));
  }

  bool Replace() {
    for (XMLElement* tag : Children(robot_)) {
      last_ = tag;
      const std::string_view name = tag->Name();
      if (name == "frame") PlaceFrame(*tag);
      else if (const auto form = Forms().find(name); form == Forms().end()) continue;
      else if (IsSound(*tag, form->second)) Place(*tag);
      // Out of the robot's tree, but not out of the document: lines are still asked of it.
      replaced_.InsertEndChild(tag);
    }
    return !replaced_.NoChildren();
  }

 private:
  using Attributes = std::vector<std::pair<const char*, std::string>>;

  bool IsSound(const XMLElement& tag, const std::vector<TagRule>& rules) {
    const int errors = faults_.errors();
    CheckAttributes(tag, {}, faults_);
    std::map<std::string_view, int> count;
    std::vector<std::string_view> legal;
    for (const TagRule& rule : rules) legal.push_back(rule.path);
    std::set<std::string_view> misspelt;
    for (const XMLElement* child : Children(tag)) {
      const std::string_view name = child->Name();
      const auto rule = std::find_if(rules.begin(), rules.end(), [&](const TagRule& r) { return r.path == name; });
      if (rule == rules.end()) {
        faults_.Report(kTagUnknown, LineOf(*child),
                       {std::string(name), " in " + Describe(tag), SuggestLegal(name, legal)});
        misspelt.insert(NearestName(name, legal).value_or(name));
      } else if (++count[name] > 1) faults_.Report(kTagTwice, LineOf(*child), {Describe(tag), std::string(name)});
      else CheckAttributes(*child, *rule, faults_);
    }
    for (const std::string_view name : legal)
      if (count[name] == 0 && !misspelt.contains(name))
        faults_.Report(kTagMissing, LineOf(tag), {Describe(tag), std::string(name)});
    return faults_.errors() == errors;
  }

  void Place(XMLElement& tag) {
    const std::string_view name = tag.Name();
    if (name == "drake:linear_spring_damper") PlaceSpringDamper(tag);
    else if (name == "drake:ball_constraint") PlaceBall(tag);
    else PlaceBushing(tag);
  }

  void PlaceFrame(XMLElement& tag) {
    XMLElement& frame = CopyOf(tag);
    frame.SetName("fp:frame");
    if (!AttributeText(frame, "xyz")) frame.SetAttribute("xyz", "0 0 0");
    Append(frame);
  }

  void PlaceSpringDamper(XMLElement& tag) {
    XMLElement& stiffness = Child(tag, "_stiffness");
    XMLElement& damping = Child(tag, "_damping");
    const std::string a = PlacePoint(tag, "_body_A", "_p_AP");
    const std::string b = PlacePoint(tag, "_body_B", "_p_BQ");
    XMLElement& spring = Make(tag, "fp:spring", {{"name", NewName("drake_spring_")}, {"parent", a}, {"child", b}});
    spring.InsertEndChild(&Make(
        stiffness, "linear",
        {{"stiffness", ValueOf(stiffness) + " N/m"}, {"free_length", ValueOf(Child(tag, "_free_length")) + " m"}}));
    Append(spring);
    XMLElement& damper = Make(tag, "fp:damper", {{"name", NewName("drake_damper_")}, {"parent", a}, {"child", b}});
    damper.InsertEndChild(&Make(damping, "linear", {{"rate", ValueOf(damping) + " N*s/m"}}));
    Append(damper);
  }

  void PlaceBall(XMLElement& tag) {
    const std::string a = PlacePoint(tag, "_body_A", "_p_AP");
    const std::string b = PlacePoint(tag, "_body_B", "_p_BQ");
    Append(Make(tag, "fp:ball", {{"name", NewName("drake_ball_")}, {"parent", a}, {"child", b}}));
  }

  void PlaceBushing(XMLElement& tag) {
    const auto frame = [&](const char* child) { return *AttributeText(*tag.FirstChildElement(child), "name"); };
    XMLElement& bushing = Make(tag, "fp:bushing",
                               {{"name", NewName("drake_bushing_")},
                                {"parent", frame("drake:bushing_frameA")},
                                {"child", frame("drake:bushing_frameC")}});
    const auto add = [&](const char* law, const char* child, const std::string& unit) {
      XMLElement& origin = *tag.FirstChildElement(child);
      const Eigen::Vector3d value = *ParseVector(*AttributeText(origin, "value"));
      const auto text = [&](int i) { return FormatNumber(value[i]) + " " + unit; };
      bushing.InsertEndChild(&Make(origin, law, {{"x", text(0)}, {"y", text(1)}, {"z", text(2)}}));
    };
    add("translation", "drake:bushing_force_stiffness", "N/m");
    add("rotation", "drake:bushing_torque_stiffness", "N*m/rad");
    add("translation_damping", "drake:bushing_force_damping", "N*s/m");
    add("rotation_damping", "drake:bushing_torque_damping", "N*m*s/rad");
    Append(bushing);
  }

  /// Name of a new frame at one end.
  std::string PlacePoint(XMLElement& tag, const char* body, const char* point) {
    XMLElement& link = Child(tag, body);
    std::string name = NewName("drake_point_");
    Append(Make(
        link, "fp:frame",
        {{"name", name}, {"link", *AttributeText(link, "name")}, {"xyz", *AttributeText(Child(tag, point), "value")}}));
    return name;
  }

  static XMLElement& Child(XMLElement& tag, const char* suffix) {
    return *tag.FirstChildElement((tag.Name() + std::string(suffix)).c_str());
  }

  static std::string ValueOf(const XMLElement& element) {
    return FormatNumber(*ParseNumber(Trimmed(*AttributeText(element, "value"))));
  }

  static XMLElement& Make(XMLElement& origin, const char* name, const Attributes& attributes) {
    XMLElement& made = *origin.GetDocument()->NewElement(name);
    SetOrigin(made, origin);
    for (const auto& [attribute, text] : attributes) made.SetAttribute(attribute, text.c_str());
    return made;
  }

  /// Places a made tag behind the one it replaces and those placed before.
  void Append(XMLElement& made) { last_ = robot_.InsertAfterChild(last_, &made); }

  std::string NewName(const std::string& stem) {
    std::string name;
    do name = stem + std::to_string(++count_[stem]);
    while (names_.contains(name));
    return name;
  }

  XMLElement& robot_;
  FileFaults& faults_;
  XMLElement& replaced_;
  tinyxml2::XMLNode* last_ = nullptr;
  std::set<std::string> names_;
  std::map<std::string, int> count_;
};

}  // namespace

std::string DrakeTagNames() {
  std::string text;
  std::size_t left = Forms().size();
  for (const auto& [name, form] : Forms()) {
    --left;
    text += name.substr(name.find(':') + 1) + (left > 1 ? ", " : left == 1 ? " and " : "");
  }
  return text;
}

void CheckDrakeBushings(const XMLElement& robot, const Vehicle& vehicle, FileFaults& faults) {
  // Of a place typed in m with four digits after the point, of an angle with three.
  constexpr double kCoincide_m = 1e-4;
  constexpr double kParallel_rad = 1e-3;
  constexpr double kDegree = std::numbers::pi / 180;
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  for (const XMLElement* element : Children(robot, "fp:bushing")) {
    if (std::string_view(Written(*element).Name()) != "drake:linear_bushing_rpy") continue;
    const auto bushing = std::find_if(vehicle.bushings.begin(), vehicle.bushings.end(), [&](const Bushing& candidate) {
      return candidate.name == AttributeText(*element, "name");
    });
    if (bushing == vehicle.bushings.end() || bushing->parent.link < 0 || bushing->child.link < 0) continue;
    const double gap = (PlaceOf(bushing->parent, poses) - PlaceOf(bushing->child, poses)).norm();
    const auto axes = [&](const Point& end, const Eigen::Matrix3d& in_link) {
      return Eigen::Matrix3d(poses[static_cast<std::size_t>(end.link)].linear() * in_link);
    };
    const Eigen::Matrix3d child_axes = FrameAxes(robot, *AttributeText(*element, "child"));
    const double angle =
        Eigen::AngleAxisd(axes(bushing->parent, bushing->axes).transpose() * axes(bushing->child, child_axes)).angle();
    if (gap <= kCoincide_m && angle <= kParallel_rad) continue;
    const auto rounded = [](double value) { return FormatNumber(std::round(10 * value) / 10); };
    faults.Report(kDrakeFramesApart, LineOf(*element),
                  {Describe(*element), rounded(gap * 1e3) + " mm", rounded(angle / kDegree) + " deg"});
  }
}

bool ReplaceDrakeTags(XMLElement& robot, FileFaults& faults) { return DrakeTags(robot, faults).Replace(); }

}  // namespace fourpost
