#include "identify/suggest/addition_source.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/text/number.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

bool EndsWithAny(const std::string& name, const VehicleEdit& edit) {
  const auto mirrors = edit.Mirrors();
  return std::any_of(mirrors.begin(), mirrors.end(),
                     [&](const auto& mirror) { return name.ends_with(mirror.first) || name.ends_with(mirror.second); });
}

/// y -> -y, to a millimetre; none of the centre plane.
bool AreMirrored(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kNear = 1e-3;
  return std::abs(a.y()) > kNear && (a - Eigen::Vector3d(b.x(), -b.y(), b.z())).norm() < kNear;
}

/// What fp:mirror makes of a name.
std::string MirroredName(const std::string& name, const VehicleEdit& edit) {
  for (const auto& [from, to] : edit.Mirrors()) {
    if (name.ends_with(from)) return name.substr(0, name.size() - from.size()) + to;
    if (name.ends_with(to)) return name.substr(0, name.size() - to.size()) + from;
  }
  return name;
}

std::string MirroredVector(const std::string& text) {
  const std::optional<Eigen::Vector3d> v = ParseVector(text);
  return v ? FormatNumber(v->x()) + ' ' + FormatNumber(-v->y()) + ' ' + FormatNumber(v->z()) : text;
}

}  // namespace

std::string Quoted(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "'" : i + 1 == names.size() ? " and '" : ", '") + names[i] + '\'';
  return text;
}

AdditionSource::AdditionSource(const Vehicle& vehicle, const std::vector<double>& values)
    : vehicle_(vehicle), values_(values) {}

std::string AdditionSource::ParameterName(const std::string& prefix, const std::vector<std::string>& elements) const {
  std::string name = prefix;
  for (const std::string& element : elements) name += '_' + element;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  const auto is_taken = [&](const std::string& one) {
    return std::any_of(vehicle_.parameters.begin(), vehicle_.parameters.end(),
                       [&](const Parameter& parameter) { return parameter.name == one; });
  };
  std::string free = name;
  for (int i = 2; is_taken(free); ++i) free = name + '_' + std::to_string(i);
  return free;
}

std::string AdditionSource::ElementName(const std::string& prefix, const std::string& element, bool is_single) const {
  const std::string stem = prefix + '_' + element;
  const VehicleEdit edit = Edit();
  const bool is_mirrored = EndsWithAny(stem, edit);
  std::string name = is_single && is_mirrored ? stem + "_alone" : stem;
  const std::string first = name;
  for (int i = 2; vehicle_.text.find("name=\"" + name + '"') != std::string::npos; ++i)
    name = prefix + std::to_string(i) + '_' + first.substr(prefix.size() + 1);
  return name;
}

std::vector<AdditionSource::Group> AdditionSource::Groups(const std::vector<ForceLine>& lines,
                                                          const std::vector<char>& takes) const {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle_);
  std::vector<Group> groups;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (takes[i] == 0) continue;
    groups.push_back({i});
    for (std::size_t k = i + 1; k < lines.size(); ++k)
      if (takes[k] != 0 && AreMirrored(PlaceOf(lines[i].parent, poses), PlaceOf(lines[k].parent, poses)) &&
          AreMirrored(PlaceOf(lines[i].child, poses), PlaceOf(lines[k].child, poses)))
        groups.push_back({i, k});
  }
  return groups;
}

std::vector<std::string> AdditionSource::WrittenOf(const char* tag, const std::vector<std::string>& names) const {
  const VehicleEdit edit = Edit();
  const std::set<std::string> group(names.begin(), names.end());
  std::vector<std::string> written;
  for (const std::string& name : names) {
    const auto twin = vehicle_.twins.find(name);
    if (twin != vehicle_.twins.end() && !edit.Find(tag, name)) {
      if (!group.contains(twin->second)) return {};
      continue;
    }
    // Its mirror image would change as well.
    for (const auto& [made, origin] : vehicle_.twins)
      if (origin == name && !edit.Find(tag, made) && !group.contains(made)) return {};
    written.push_back(name);
  }
  return written;
}

std::vector<std::pair<std::string, std::string>> AdditionSource::EndsOf(const char* tag,
                                                                        const std::vector<std::string>& names) const {
  const VehicleEdit edit = Edit();
  std::vector<std::pair<std::string, std::string>> ends;
  for (const std::string& name : names) {
    const tinyxml2::XMLElement* element = edit.Find(tag, name);
    const bool is_image = !element;
    if (is_image && names.size() > 1) continue;  // follows by fp:mirror
    if (is_image)
      if (const auto twin = vehicle_.twins.find(name); twin != vehicle_.twins.end())
        element = edit.Find(tag, twin->second);
    if (!element) continue;
    std::string text;
    for (const char* attribute : {"parent", "child"}) {
      const std::string point = AttributeText(*element, attribute).value_or("");
      text += std::string(attribute) + "=\"" + (is_image ? MirroredName(point, edit) : point) + "\" ";
    }
    if (const auto axis = AttributeText(*element, "axis"))
      text += "axis=\"" + (is_image ? MirroredVector(*axis) : *axis) + "\" ";
    ends.emplace_back(name, text.substr(0, text.size() - 1));
  }
  return ends;
}

std::vector<const Damper*> AdditionSource::FrictionBetween(int one, int other) const {
  std::vector<const Damper*> found;
  for (const Damper& damper : vehicle_.dampers) {
    const std::pair<int, int> links = {damper.line.parent.link, damper.line.child.link};
    if (damper.law.friction && (links == std::pair(one, other) || links == std::pair(other, one)))
      found.push_back(&damper);
  }
  return found;
}

tinyxml2::XMLElement* AdditionSource::ImageOf(const char* tag, const std::string& written,
                                              tinyxml2::XMLDocument& document) const {
  const VehicleEdit edit = Edit();
  const tinyxml2::XMLElement* element = edit.Find(tag, written);
  if (!element) return nullptr;
  tinyxml2::XMLElement* image = element->DeepClone(&document)->ToElement();
  document.InsertEndChild(image);
  for (const char* name : {"name", "parent", "child", "link"})
    if (const auto text = AttributeText(*image, name)) image->SetAttribute(name, MirroredName(*text, edit).c_str());
  for (const char* vector : {"xyz", "axis"})
    if (const auto text = AttributeText(*image, vector)) image->SetAttribute(vector, MirroredVector(*text).c_str());
  return image;
}

}  // namespace fourpost
