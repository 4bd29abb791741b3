#include "vehicles/reader/element_reader.h"

#include <array>
#include <tuple>
#include <utility>

#include "analysis/text/nearest.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/law_reader.h"
#include "vehicles/reader/line_reader.h"
#include "vehicles/tags/attribute_check.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

bool AreSame(const Point& a, const Point& b) { return a.link >= 0 && a.link == b.link && a.xyz == b.xyz; }

/// In any order.
bool HaveSameEnds(const ForceLine& a, const ForceLine& b) {
  return (AreSame(a.parent, b.parent) && AreSame(a.child, b.child)) ||
         (AreSame(a.parent, b.child) && AreSame(a.child, b.parent));
}

class ElementReader {
 public:
  ElementReader(const XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                FileFaults& faults)
      : robot_(robot),
        lines_(robot, tree, parameters, faults),
        laws_(parameters, faults),
        parameters_(parameters),
        vehicle_(vehicle),
        faults_(faults) {}

  void Read() {
    for (const Tag& tag : TagsOf(robot_, "fp:spring")) ReadSpring(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:stop")) ReadStop(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:damper")) ReadDamper(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:bushing")) ReadBushing(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:antiroll")) ReadAntiRollBar(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:tyre")) ReadTyre(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:post")) ReadPost(tag);
    for (const Tag& tag : TagsOf(robot_, "fp:actuator"))
      vehicle_.actuators.push_back({.name = tag.Text("name"), .line = lines_.ReadLine(tag), .source_line = tag.Line()});
    for (const Tag& tag : TagsOf(robot_, "fp:rod")) vehicle_.rods.push_back(ReadClosure<Rod>(tag));
    for (const Tag& tag : TagsOf(robot_, "fp:ball")) vehicle_.balls.push_back(ReadClosure<Ball>(tag));
    for (const Tag& tag : TagsOf(robot_, "fp:weld")) vehicle_.welds.push_back(ReadClosure<Weld>(tag));
    for (const Tag& tag : TagsOf(robot_, "fp:hinge")) {
      Hinge hinge = ReadClosure<Hinge>(tag);
      hinge.axis = LineReader::ReadAxis(tag).value_or(hinge.axis);
      vehicle_.hinges.push_back(hinge);
    }
    for (const Tag& tag : TagsOf(robot_, "fp:sensor")) ReadSensor(tag);
  }

 private:
  template <typename Closure>
  Closure ReadClosure(const Tag& tag) {
    Closure closure;
    closure.name = tag.Text("name");
    std::tie(closure.parent, closure.child) = lines_.ReadEnds(tag, kClosureOnOneLink);
    closure.source_line = tag.Line();
    return closure;
  }

  /// Nothing for the word that stands for equilibrium.
  std::optional<Scalar> ReadPreload(const Tag& tag) {
    if (tag.Text("preload") == FindAttribute(*tag.rule, "preload")->word) return std::nullopt;
    return parameters_.ReadScalar(tag, "preload");
  }

  /// A number of the geometry, which no parameter can change.
  double ReadConstant(const Tag& tag, std::string_view attribute) {
    const Scalar scalar = parameters_.ReadScalar(tag, attribute);
    if (scalar.parameter >= 0) faults_.Report(kConstantFollows, tag.Line(attribute), {Quoted(attribute, tag)});
    return scalar.value;
  }

  void ReadSpring(const Tag& tag) {
    Spring spring{.name = tag.Text("name"),
                  .line = lines_.ReadLine(tag),
                  .law = {},
                  .preload = {},
                  .free_length = {},
                  .source_line = tag.Line()};
    for (const char* name : {"linear", "cubic", "multirate", "table"}) {
      const std::optional<Tag> law = ChildOf(tag, name);
      if (!law) continue;
      spring.law = laws_.ReadSpring(*law);
      spring.preload = ReadPreload(*law);
      if (!AttributeText(*law->element, "free_length")) continue;
      spring.free_length = parameters_.ReadScalar(*law, "free_length");
      if (AttributeText(*law->element, "preload"))
        faults_.Report(kPreloadAndFreeLength, law->Line("free_length"), {Describe(*tag.element)});
      else if (spring.line.axis) faults_.Report(kFreeLengthGuided, law->Line("free_length"), {Describe(*tag.element)});
    }
    vehicle_.springs.push_back(spring);
  }

  void ReadStop(const Tag& tag) {
    vehicle_.springs.push_back({.kind = Spring::Kind::kStop,
                                .name = tag.Text("name"),
                                .line = lines_.ReadLine(tag),
                                .law = laws_.ReadStop(tag),
                                .preload = Scalar(),
                                .free_length = {},
                                .source_line = tag.Line()});
  }

  void ReadDamper(const Tag& tag) {
    Damper damper;
    damper.name = tag.Text("name");
    damper.line = lines_.ReadLine(tag);
    damper.source_line = tag.Line();
    const std::optional<Tag> series = ChildOf(tag, "series");
    if (series) damper.series = laws_.ReadSeries(*series);
    for (const char* name : {"linear", "bilinear", "smooth", "digressive", "saturating", "table", "curve"})
      if (const std::optional<Tag> law = ChildOf(tag, name)) damper.law = laws_.ReadDashpot(tag, *law, series);
    if (const std::optional<Tag> law = ChildOf(tag, "hydraulic")) {
      damper.hydraulic = laws_.ReadHydraulic(*law);
      damper.law.friction = laws_.ReadFriction(tag, std::nullopt);
    }
    if (const std::optional<Tag> gas = ChildOf(tag, "gas")) ReadGas(tag, *gas, damper.line);
    vehicle_.dampers.push_back(damper);
  }

  /// Gas under pressure pushes the rod out.
  void ReadGas(const Tag& damper, const Tag& tag, const ForceLine& line) {
    Scalar tension = parameters_.ReadScalar(tag, "force");
    tension.value = -tension.value;
    tension.factor = -tension.factor;
    vehicle_.springs.push_back(
        {.kind = Spring::Kind::kGas,
         .name = damper.Text("name"),
         .line = line,
         .law = {.stiffness = parameters_.ReadScalar(tag, "stiffness"), .cubic = {}, .knees = {}},
         .preload = tension,
         .free_length = {},
         .source_line = tag.Line()});
  }

  void ReadBushing(const Tag& tag) {
    Bushing bushing = ReadClosure<Bushing>(tag);
    bushing.axes = lines_.ReadAxes(tag);
    bushing.holds = tag.Text("preload") == "equilibrium";
    int laws = ReadAxes(tag, "translation", 0, bushing.stiffness);
    laws += ReadAxes(tag, "rotation", 3, bushing.stiffness);
    laws += ReadAxes(tag, "translation_damping", 0, bushing.damping);
    laws += ReadAxes(tag, "rotation_damping", 3, bushing.damping);
    if (laws == 0) faults_.Report(kBushingResistsNothing, tag.Line(), {Describe(*tag.element)});
    if (const std::optional<Tag> loss = ChildOf(tag, "loss")) {
      bushing.loss_factor = parameters_.ReadScalar(*loss, "factor");
      bushing.loss_frequency_Hz = ReadConstant(*loss, "frequency");
    }
    vehicle_.bushings.push_back(bushing);
  }

  /// Three components from the attributes x, y, z of a child; how many such children there are.
  int ReadAxes(const Tag& tag, std::string_view child, std::size_t first, std::array<Scalar, 6>& components) {
    const std::optional<Tag> found = ChildOf(tag, child);
    if (!found) return 0;
    components[first] = parameters_.ReadScalar(*found, "x");
    components[first + 1] = parameters_.ReadScalar(*found, "y");
    components[first + 2] = parameters_.ReadScalar(*found, "z");
    return 1;
  }

  void ReadAntiRollBar(const Tag& tag) {
    AntiRollBar bar{.name = tag.Text("name"),
                    .left = {},
                    .right = {},
                    .stiffness = parameters_.ReadScalar(tag, "stiffness"),
                    .damping = parameters_.ReadScalar(tag, "damping"),
                    .source_line = tag.Line()};
    if (const std::optional<Tag> left = ChildOf(tag, "left")) bar.left = lines_.ReadLine(*left);
    if (const std::optional<Tag> right = ChildOf(tag, "right")) {
      bar.right = lines_.ReadLine(*right);
      if (HaveSameEnds(bar.left, bar.right)) faults_.Report(kBarSamePoints, right->Line(), {Describe(*tag.element)});
    }
    vehicle_.antiroll_bars.push_back(bar);
  }

  void ReadTyre(const Tag& tag) {
    vehicle_.tyres.push_back({.name = tag.Text("name"),
                              .point = lines_.ReadPoint(tag),
                              .radius = ReadConstant(tag, "radius"),
                              .law = laws_.ReadTyre(tag),
                              .damping = parameters_.ReadScalar(tag, "damping"),
                              .lateral = parameters_.ReadScalar(tag, "lateral"),
                              .longitudinal = parameters_.ReadScalar(tag, "longitudinal"),
                              .lateral_damping = parameters_.ReadScalar(tag, "lateral_damping"),
                              .longitudinal_damping = parameters_.ReadScalar(tag, "longitudinal_damping"),
                              .lifts_off = tag.Text("liftoff") == "true",
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
    if (!name.empty()) lines_.Unknown(tag, attribute, "fp:tyre", legal);
    return -1;
  }

  void ReadPost(const Tag& tag) {
    Post post{.name = tag.Text("name"), .tyre = ReadTyreName(tag, "under"), .stroke = {}, .source_line = tag.Line()};
    if (AttributeText(*tag.element, "stroke")) post.stroke = ReadConstant(tag, "stroke");
    for (const Post& other : vehicle_.posts)
      if (post.tyre >= 0 && other.tyre == post.tyre)
        faults_.Report(kTyreTwoPosts, tag.Line("under"), {Describe(*tag.element), other.name});
    vehicle_.posts.push_back(post);
  }

  void ReadSensor(const Tag& tag) {
    Sensor sensor;
    sensor.name = tag.Text("name");
    sensor.source_line = tag.Line();
    const std::string_view type = tag.rule->type;
    if (type == "strut") {
      sensor.type = Sensor::Type::kStrut;
      sensor.line = lines_.ReadLine(tag);
    } else if (type == "load_cell") {
      sensor.type = Sensor::Type::kLoadCell;
      sensor.tyre = ReadTyreName(tag, "tyre");
      sensor.wheelpan = parameters_.ReadScalar(tag, "wheelpan");
    } else {
      sensor.type = type == "gyro"           ? Sensor::Type::kGyro
                    : type == "displacement" ? Sensor::Type::kDisplacement
                                             : Sensor::Type::kAccelerometer;
      if (sensor.type == Sensor::Type::kGyro) sensor.point.link = lines_.ReadLink(tag);
      else sensor.point = lines_.ReadPoint(tag);
      sensor.axis = LineReader::ReadAxis(tag).value_or(sensor.axis);
    }
    vehicle_.sensors.push_back(sensor);
  }

  const XMLElement& robot_;
  LineReader lines_;
  LawReader laws_;
  ParameterReader& parameters_;
  Vehicle& vehicle_;
  FileFaults& faults_;
};

}  // namespace

void ReadElements(const XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                  FileFaults& faults) {
  ElementReader(robot, tree, parameters, vehicle, faults).Read();
}

}  // namespace fourpost
