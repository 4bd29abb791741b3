#include "vehicles/reader/line_reader.h"

#include <tuple>

#include <Eigen/Geometry>

#include "analysis/text/nearest.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/tag_check.h"

namespace fourpost {

Eigen::Matrix3d TurnOf(const Eigen::Vector3d& rpy) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return (AngleAxisd(rpy.z(), Vector3d::UnitZ()) * AngleAxisd(rpy.y(), Vector3d::UnitY()) *
          AngleAxisd(rpy.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}
LineReader::LineReader(const tinyxml2::XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters,
                       FileFaults& faults)
    : tree_(tree), faults_(faults), lost_names_(LostNames(robot)) {
  for (const Tag& tag : TagsOf(robot, "fp:frame")) ReadFrame(tag, parameters);
}

void LineReader::Unknown(const Tag& tag, std::string_view attribute, const std::string& kind,
                         const std::vector<std::string>& legal) const {
  const std::string name = tag.Text(attribute);
  if (lost_names_.contains(name)) return faults_.Follow();
  faults_.Report(kReferenceUnknown, tag.Line(attribute), {Describe(*tag.element), kind, name, DidYouMean(name, legal)});
}

int LineReader::ReadLink(const Tag& tag) const {
  const int link = tree_.FindLink(tag.Text("link"));
  if (link < 0 && !tag.Text("link").empty()) Unknown(tag, "link", "link", tree_.LinkNames());
  return link;
}

Point LineReader::ReadPoint(const Tag& tag) const {
  return {.link = ReadLink(tag), .xyz = ParseVector(tag.Text("xyz")).value_or(Point().xyz)};
}

void LineReader::ReadFrame(const Tag& tag, ParameterReader& parameters) {
  const std::string name = tag.Text("name");
  if (tree_.FindLink(name) >= 0) faults_.Report(kFrameNamedAsLink, tag.Line(), {Describe(*tag.element)});
  Point point = ReadPoint(tag);
  point.shift = {parameters.ReadScalar(tag, "dx"), parameters.ReadScalar(tag, "dy"), parameters.ReadScalar(tag, "dz")};
  point.xyz += Eigen::Vector3d(point.shift[0].value, point.shift[1].value, point.shift[2].value);
  frames_.try_emplace(name, Frame{point, TurnOf(ParseVector(tag.Text("rpy")).value_or(Eigen::Vector3d(0, 0, 0)))});
}

std::vector<std::string> LineReader::EndNames() const {
  if (!faults_.IsShown()) return {};
  std::vector<std::string> names = tree_.LinkNames();
  for (const auto& [frame, unused] : frames_) names.push_back(frame);
  return names;
}

Point LineReader::ReadEnd(const Tag& tag, std::string_view attribute) const {
  const std::string name = tag.Text(attribute);
  if (name.empty()) return {};
  if (const auto frame = frames_.find(name); frame != frames_.end()) return frame->second.point;
  Point point;
  point.link = tree_.FindLink(name);
  if (point.link < 0) Unknown(tag, attribute, "frame or link", EndNames());
  return point;
}

std::pair<Point, Point> LineReader::ReadEnds(const Tag& tag, const Finding& on_one) const {
  const Point parent = ReadEnd(tag, "parent");
  const Point child = ReadEnd(tag, "child");
  if (parent.link >= 0 && parent.link == child.link)
    faults_.Report(on_one, tag.Line(),
                   {Describe(*tag.element), tree_.LinkNames()[static_cast<std::size_t>(parent.link)]});
  return {parent, child};
}

std::optional<Eigen::Vector3d> LineReader::ReadAxis(const Tag& tag) {
  const std::optional<Eigen::Vector3d> axis = ParseVector(tag.Text("axis"));
  if (!axis || axis->isZero(0)) return std::nullopt;
  return axis->normalized();
}

ForceLine LineReader::ReadLine(const Tag& tag) const {
  ForceLine line;
  std::tie(line.parent, line.child) = ReadEnds(tag, kLineOnOneLink);
  line.axis = ReadAxis(tag);
  return line;
}

Eigen::Matrix3d LineReader::ReadAxes(const Tag& tag) const {
  const auto frame = frames_.find(tag.Text("parent"));
  return frame == frames_.end() ? Eigen::Matrix3d::Identity() : frame->second.axes;
}

}  // namespace fourpost
