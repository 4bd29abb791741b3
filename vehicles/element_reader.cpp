#include "vehicles/element_reader.h"

#include <map>
#include <tuple>
#include <utility>

#include "analysis/nearest.h"
#include "vehicles/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

class ElementReader {
 public:
  ElementReader(const XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                FileFaults& faults)
      : robot_(robot), tree_(tree), parameters_(parameters), vehicle_(vehicle), faults_(faults) {}

  void Read() {
    for (const Tag& tag : TagsOf(robot_, "fp:frame")) ReadFrame(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:spring")) ReadSpring(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:damper")) ReadDamper(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:tyre")) ReadTyre(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:post")) ReadPost(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:rod")) {
      const auto [parent, child] = ReadEnds(tag, "it joins nothing");
      vehicle_.rods.push_back({tag.Text("name"), parent, child, tag.Line()});
    }
    for (const Tag& tag : TagsOf(robot_, "fp:ball")) {
      const auto [parent, child] = ReadEnds(tag, "it joins nothing");
      vehicle_.balls.push_back({tag.Text("name"), parent, child, tag.Line()});
    }
    for (const Tag& tag : TagsOf(robot_, "fp:sensor")) ReadSensor(tag);
  }

 private:
  void Unknown(const Tag& tag, std::string_view attribute, const std::string& kind,
               const std::vector<std::string>& legal) {
    const std::string name = tag.Text(attribute);
    faults_.Error(tag.Line(attribute), Describe(*tag.element) + " refers to an unknown " + kind + " '" + name + "'" +
                                           DidYouMean(name, legal));
  }

  Point ReadPoint(const Tag& tag) {
    Point point{.link = tree_.FindLink(tag.Text("link")), .xyz = ParseVector(tag.Text("xyz")).value_or(Point().xyz)};
    if (point.link < 0 && !tag.Text("link").empty()) Unknown(tag, "link", "link", tree_.LinkNames());
    return point;
  }

  void ReadFrame(const Tag& tag) {
    const std::string name = tag.Text("name");
    if (tree_.FindLink(name) >= 0)
      faults_.Error(tag.Line(),
                    Describe(*tag.element) + " has the name of a link: a name must tell which one is meant");
    frames_.try_emplace(name, ReadPoint(tag));
  }

  /// An end of an element that names a frame, or a link for its origin.
  Point ReadEnd(const Tag& tag, std::string_view attribute) {
    const std::string name = tag.Text(attribute);
    if (name.empty()) return {};
    if (const auto frame = frames_.find(name); frame != frames_.end()) return frame->second;
    Point point;
    point.link = tree_.FindLink(name);
    if (point.link < 0) {
      std::vector<std::string> legal = tree_.LinkNames();
      for (const auto& [frame, unused] : frames_) legal.push_back(frame);
      Unknown(tag, attribute, "frame or link", legal);
    }
    return point;
  }

  /// Parent and child, which must be on two links; `why` tells what is wrong with one.
  std::pair<Point, Point> ReadEnds(const Tag& tag, const std::string& why) {
    const Point parent = ReadEnd(tag, "parent");
    const Point child = ReadEnd(tag, "child");
    if (parent.link >= 0 && parent.link == child.link)
      faults_.Error(tag.Line(), Describe(*tag.element) + " has both ends on link '" +
                                    tree_.LinkNames()[static_cast<std::size_t>(parent.link)] + "': " + why);
    return {parent, child};
  }

  ForceLine ReadLine(const Tag& tag) {
    ForceLine line;
    std::tie(line.parent, line.child) = ReadEnds(tag, "its length can never change");
    const std::optional<Eigen::Vector3d> axis = ParseVector(tag.Text("axis"));
    if (axis && !axis->isZero(0)) line.axis = axis->normalized();
    return line;
  }

  std::optional<Scalar> ReadPreload(const Tag& tag) {
    if (tag.Text("preload") == FindAttribute(*tag.rule, "preload")->word) return std::nullopt;
    return parameters_.ReadScalar(tag, "preload");
  }

  /// The child of this name; nothing when it is not given.
  static std::optional<Tag> Child(const Tag& tag, const std::string& name) {
    const std::vector<Tag> found = TagsOf(*tag.element, std::string(tag.rule->path) + "/" + name);
    if (found.empty()) return std::nullopt;
    return found.front();
  }

  void ReadSpring(const Tag& tag) {
    Spring spring;
    spring.name = tag.Text("name");
    spring.line = ReadLine(tag);
    spring.source_line = tag.Line();
    if (const std::optional<Tag> law = Child(tag, "linear")) {
      spring.stiffness = parameters_.ReadScalar(*law, "stiffness");
      spring.preload = ReadPreload(*law);
    }
    vehicle_.springs.push_back(spring);
  }

  void ReadDamper(const Tag& tag) {
    Damper damper;
    damper.name = tag.Text("name");
    damper.line = ReadLine(tag);
    damper.source_line = tag.Line();
    const int errors = faults_.errors();
    const std::optional<Tag> linear = Child(tag, "linear");
    const std::optional<Tag> bilinear = Child(tag, "bilinear");
    if (linear) damper.compression = damper.rebound = parameters_.ReadScalar(*linear, "rate");
    if (bilinear) {
      damper.compression = parameters_.ReadScalar(*bilinear, "compression");
      damper.rebound = parameters_.ReadScalar(*bilinear, "rebound");
    }
    if (const std::optional<Tag> series = Child(tag, "series")) {
      damper.series_stiffness = parameters_.ReadScalar(*series, "stiffness");
      const bool is_stuck = parameters_.Least(damper.compression) <= 0 || parameters_.Least(damper.rebound) <= 0;
      if ((linear || bilinear) && is_stuck && faults_.errors() == errors)
        faults_.Error(series->Line(), Describe(*tag.element) + " has a series spring: its rates must be above zero");
    }
    vehicle_.dampers.push_back(damper);
  }

  void ReadTyre(const Tag& tag) {
    vehicle_.tyres.push_back({.name = tag.Text("name"),
                              .point = ReadPoint(tag),
                              .stiffness = parameters_.ReadScalar(tag, "stiffness"),
                              .damping = parameters_.ReadScalar(tag, "damping"),
                              .preload = ReadPreload(tag),
                              .source_line = tag.Line()});
  }

  int ReadTyreName(const Tag& tag, std::string_view attribute) {
    const std::string name = tag.Text(attribute);
    std::vector<std::string> legal;
    for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i) {
      if (vehicle_.tyres[i].name == name) return static_cast<int>(i);
      legal.push_back(vehicle_.tyres[i].name);
    }
    if (!name.empty()) Unknown(tag, attribute, "fp:tyre", legal);
    return -1;
  }

  void ReadPost(const Tag& tag) {
    const Post post{.name = tag.Text("name"), .tyre = ReadTyreName(tag, "under"), .source_line = tag.Line()};
    for (const Post& other : vehicle_.posts)
      if (post.tyre >= 0 && other.tyre == post.tyre)
        faults_.Error(tag.Line("under"),
                      Describe(*tag.element) + " drives the tyre that fp:post '" + other.name + "' drives already");
    vehicle_.posts.push_back(post);
  }

  void ReadSensor(const Tag& tag) {
    Sensor sensor;
    sensor.name = tag.Text("name");
    sensor.source_line = tag.Line();
    const std::string_view type = tag.rule->type;
    if (type == "strut") {
      sensor.type = Sensor::Type::kStrut;
      sensor.line = ReadLine(tag);
    } else if (type == "load_cell") {
      sensor.type = Sensor::Type::kLoadCell;
      sensor.tyre = ReadTyreName(tag, "tyre");
    } else {
      sensor.type = type == "displacement" ? Sensor::Type::kDisplacement : Sensor::Type::kAccelerometer;
      sensor.point = ReadPoint(tag);
      const std::optional<Eigen::Vector3d> axis = ParseVector(tag.Text("axis"));
      if (axis && !axis->isZero(0)) sensor.axis = axis->normalized();
    }
    vehicle_.sensors.push_back(sensor);
  }

  const XMLElement& robot_;
  const UrdfTree& tree_;
  ParameterReader& parameters_;
  Vehicle& vehicle_;
  FileFaults& faults_;
  std::map<std::string, Point> frames_;
};

}  // namespace

void ReadElements(const XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                  FileFaults& faults) {
  ElementReader(robot, tree, parameters, vehicle, faults).Read();
}

}  // namespace fourpost
