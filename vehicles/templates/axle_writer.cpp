#include "vehicles/templates/axle_writer.h"

#include <cmath>

#include <Eigen/Geometry>

#include "analysis/text/number.h"
#include "vehicles/templates/written_xml.h"

namespace fourpost {
namespace {

using Eigen::Vector3d;

/// To a nanometre.
std::string NumberText(double value) { return FormatNumber(std::round(value * 1e9) + 0.0, -9); }

/// Estimates to a ten-thousandth.
std::string InertiaText(const Eigen::Matrix3d& inertia, bool is_known) {
  const auto entry = [&](const char* name, int i, int j) {
    const double shown = is_known ? inertia(i, j) : std::round(inertia(i, j) * 1e4) * 1e-4;
    return std::string(" ") + name + "=\"" + NumberText(shown) + "\"";
  };
  return "<inertia" + entry("ixx", 0, 0) + entry("iyy", 1, 1) + entry("izz", 2, 2) + entry("ixy", 0, 1) +
         entry("ixz", 0, 2) + entry("iyz", 1, 2) + "/>";
}

/// Of equal masses at these places about their centre, each a ball of a radius of 5 cm.
Eigen::Matrix3d InertiaOf(double mass, const std::vector<Vector3d>& places, const Vector3d& centre) {
  const double share = mass / static_cast<double>(places.size());
  Eigen::Matrix3d inertia = 0.4 * mass * 0.05 * 0.05 * Eigen::Matrix3d::Identity();
  for (const Vector3d& place : places) {
    const Vector3d arm = place - centre;
    inertia += share * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  return inertia;
}

/// A bar between two places, for pictures.
std::string BarText(const Vector3d& from, const Vector3d& to) {
  const Vector3d span = to - from;
  const double pitch = -std::atan2(span.z(), std::hypot(span.x(), span.y()));
  const double yaw = std::atan2(span.y(), span.x());
  return "    <visual>\n      <origin xyz=\"" + XyzText(0.5 * (from + to)) + "\" rpy=\"0 " +
         NumberText(std::round(pitch * 1e4) * 1e-4) + " " + NumberText(std::round(yaw * 1e4) * 1e-4) +
         "\"/>\n      <geometry><box size=\"" + NumberText(std::round(span.norm() * 1e3) * 1e-3) +
         " 0.03 0.03\"/></geometry>\n    </visual>\n";
}

}  // namespace

std::string XyzText(const Vector3d& xyz) {
  return NumberText(xyz.x()) + " " + NumberText(xyz.y()) + " " + NumberText(xyz.z());
}

std::string Text(const ParameterText& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  const auto quantity = [&](const char* name, double number) {
    return std::string(" ") + name + "=\"" + NumberText(number) + unit + "\"";
  };
  return "  <fp:parameter name=\"" + parameter.name + "\"" + quantity("value", parameter.value) +
         quantity("lower", parameter.lower) + quantity("upper", parameter.upper) +
         quantity("precision", parameter.precision) + "\n                source=\"" + InAttribute(parameter.source) +
         "\"/>\n";
}

std::string AxleWriter::Name(std::string_view part, bool has_side) const {
  return points_.axle + "_" + std::string(part) + (has_side ? "_left" : "");
}

std::string AxleWriter::Full(std::string_view part) const {
  if (part == "body") return "body";
  return Name(part, HasSide(part));
}

bool AxleWriter::HasSide(std::string_view part) const { return parts_.find(part)->second.has_side; }

std::string AxleWriter::CarrierOf(std::string_view point) const {
  const auto found = points_.points.find(point);
  if (!found->second.on.empty()) return found->second.on;
  return std::string(points_.kind->Find(point)->carriers.front());
}

void AxleWriter::Comment(std::string_view text) { text_ += "\n  <!-- " + std::string(text) + " -->\n"; }

const KnownBody* AxleWriter::KnownPart(std::string_view part) const {
  const auto found = guess_.known.bodies.find(part);
  return found == guess_.known.bodies.end() ? nullptr : &found->second;
}

void AxleWriter::Body(std::string_view part, double mass, const std::vector<Vector3d>& places, bool has_side) {
  auto& entry = parts_[std::string(part)];
  entry.has_side = has_side;
  const KnownBody* const known = KnownPart(part);
  if (places.empty() && !known) {
    text_ += "  <link name=\"" + Name(part, has_side) + "\"/>\n";
    return;
  }
  Vector3d centre = Vector3d::Zero();
  for (const Vector3d& place : places) centre += place / static_cast<double>(places.size());
  if (known) centre = known->com;
  const Eigen::Matrix3d inertia = known ? known->inertia : InertiaOf(mass, places, centre);
  text_ += "  <link name=\"" + Name(part, has_side) + "\">\n    <inertial>\n      <origin xyz=\"" +
           XyzText(centre - entry.origin) + "\"/>\n      <mass value=\"" + NumberText(known ? known->mass : mass) +
           "\"/>\n      " + InertiaText(inertia, known != nullptr) + "\n    </inertial>\n";
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    text_ += BarText(places[i] - entry.origin, places.back() - entry.origin);
  text_ += "  </link>\n";
}

void AxleWriter::Floating(std::string_view part, bool has_side) {
  text_ += "  <joint name=\"" + Name(part, has_side) +
           "\" type=\"floating\">\n    <parent link=\"body\"/><child link=\"" + Name(part, has_side) +
           "\"/>\n  </joint>\n";
}

void AxleWriter::Joint(std::string_view part, std::string_view parent, std::string_view type, const Vector3d& origin,
                       const Vector3d& axis, bool has_side) {
  parts_[std::string(part)] = {origin, has_side};
  const Vector3d offset = origin - parts_.find(parent)->second.origin;
  text_ += "  <joint name=\"" + Name(part, has_side) + "\" type=\"" + std::string(type) + "\">\n    <parent link=\"" +
           Full(parent) + "\"/><child link=\"" + Name(part, has_side) + "\"/><origin xyz=\"" + XyzText(offset) +
           "\"/><axis xyz=\"" + XyzText(axis) + "\"/>\n";
  if (type == "prismatic") text_ += "    <limit lower=\"-0.3\" upper=\"0.3\" effort=\"0\" velocity=\"0\"/>\n";
  text_ += "  </joint>\n";
}

void AxleWriter::Arm(std::string_view part, double mass, const ArmSpec& arm) {
  const Vector3d& first = points_.At(arm.first);
  parts_[std::string(part)].origin = first;
  Body(part, mass, {first, points_.At(arm.second), points_.At(arm.end)});
  Joint(part, "body", "continuous", first, points_.At(arm.second) - first);
}

std::string AxleWriter::Frame(std::string_view part, std::string_view point) {
  const PointSpec* const spec = points_.kind->Find(point);
  return Frame(part, point, points_.At(point), spec->side == PointSpec::Side::kLeft);
}

std::string AxleWriter::Frame(std::string_view part, std::string_view name, const Vector3d& place, bool has_side) {
  const std::string key = std::string(part) + " " + std::string(name);
  if (const auto found = frames_.find(key); found != frames_.end()) return found->second;
  const std::string frame = Name(std::string(name) + "_" + std::string(part), has_side);
  text_ += "  <fp:frame name=\"" + frame + "\" link=\"" + Full(part) + "\" xyz=\"" +
           XyzText(place - parts_.find(part)->second.origin) + "\"/>\n";
  frames_[key] = frame;
  return frame;
}

std::string AxleWriter::EndsOf(std::string_view tag, std::string_view name, const std::string& parent,
                               const std::string& child) {
  const bool has_side = parent.ends_with("_left") || child.ends_with("_left");
  return "  <fp:" + std::string(tag) + " name=\"" + Name(name, has_side) + "\" parent=\"" + parent + "\" child=\"" +
         child + "\"";
}

void AxleWriter::Ball(std::string_view name, std::string_view parent, std::string_view child) {
  const std::string on_parent = Frame(parent, name);
  const std::string on_child = Frame(child, name);
  text_ += EndsOf("ball", name, on_parent, on_child) + "/>\n";
}

void AxleWriter::Rod(std::string_view name, std::string_view inner, std::string_view outer, std::string_view part) {
  const std::string on_body = Frame("body", inner);
  const std::string on_part = Frame(part, outer);
  text_ += EndsOf("rod", name, on_body, on_part) + "/>\n";
}

void AxleWriter::LinkOnBush(std::string_view name, std::string_view inner, std::string_view outer,
                            std::string_view part) {
  const std::string swing = std::string(name) + "_swing";
  const Vector3d at = points_.At(outer);
  Empty(swing);
  Joint(swing, part, "continuous", at, Vector3d::UnitZ());
  parts_[std::string(name)].origin = at;
  // The half that does not count with the axle.
  Body(name, 1.5, {points_.At(inner)});
  Joint(name, swing, "continuous", at, Vector3d::UnitY());
  const std::string seat = Frame("body", inner);
  const std::string end = Frame(name, inner);
  const std::string rate = "k_" + points_.axle + "_link";
  text_ += EndsOf("bushing", name, seat, end) + " preload=\"equilibrium\">\n    <translation x=\"$" + rate +
           "\" y=\"$" + rate + "\" z=\"$" + rate + "\"/>\n    <rotation x=\"0.5*$kr_" + points_.axle +
           "_link\" y=\"0.1*$kr_" + points_.axle + "_link\" z=\"$kr_" + points_.axle +
           "_link\"/>\n    <loss factor=\"0.1\" frequency=\"30 Hz\"/>\n  </fp:bushing>\n";
}

void AxleWriter::Wheel(std::string_view carrier) {
  const KnownBody* const known = KnownPart("wheel");
  const double mass = known ? known->mass : points_.axle == "front" ? 38 : 35;
  const Vector3d& centre = points_.At("wheel_centre");
  const double r2 = height_ * height_;
  Vector3d turn = Vector3d::Zero();
  if (points_.Has("wheel_axis")) {
    const Vector3d axis = (points_.At("wheel_axis") - centre).normalized();
    turn = {std::asin(axis.z()), 0, std::atan2(-axis.x(), axis.y())};
  }
  const std::string parameter = "m_" + points_.axle + "_wheel";
  const Eigen::Matrix3d inertia =
      known ? known->inertia : Vector3d(0.17, 0.28, 0.17).asDiagonal() * (mass * r2 * Eigen::Matrix3d::Identity());
  const std::string offset =
      known && !known->com.isApprox(centre) ? "      <origin xyz=\"" + XyzText(known->com - centre) + "\"/>\n" : "";
  text_ += "  <link name=\"" + Name("wheel") + "\">\n    <inertial>\n" + offset + "      <mass value=\"$" + parameter +
           "\"/>\n      " + InertiaText(inertia, known != nullptr) +
           "\n    </inertial>\n    <visual>\n      <origin xyz=\"0 0 0\" rpy=\"1.5708 0 0\"/>\n      "
           "<geometry><cylinder radius=\"" +
           NumberText(std::round(height_ * 1e3) * 1e-3) + "\" length=\"0.2\"/></geometry>\n    </visual>\n  </link>\n";
  parts_["wheel"] = {centre, true};
  text_ += "  <joint name=\"" + Name("wheel") + "\" type=\"fixed\">\n    <parent link=\"" + Full(carrier) +
           "\"/><child link=\"" + Name("wheel") + "\"/><origin xyz=\"" +
           XyzText(centre - parts_.find(carrier)->second.origin) + "\"" +
           (turn.isZero() ? "" : " rpy=\"" + XyzText(turn) + "\"") + "/>\n  </joint>\n";
  Add(ParameterText{
      .name = parameter,
      .value = mass,
      .lower = std::round(0.5 * mass),
      .upper = std::round(1.8 * mass),
      .precision = 0.1,
      .unit = "kg",
      .source = known ? guess_.known.source + ": spindle, wheel and tyre of one side"
                      : "estimate, of a passenger car: one side, wheel with hub, brake and knuckle, without arms"});
}

void AxleWriter::BeamAxle() {
  BeamAxleAt(Vector3d::Zero());
  Floating("axle", false);
}

void AxleWriter::BeamAxleAt(const Vector3d& origin) {
  const KnownBody* const known = KnownPart("axle");
  const double mass = known ? known->mass : 120;
  const Vector3d& centre = points_.At("wheel_centre");
  const double track = 2 * centre.y();
  // A beam of 60 kg and two wheels of 30 kg.
  const double roll = known ? known->inertia(0, 0) : std::round(60 * track * track / 12 + 60 * track * track / 4);
  parts_["axle"] = {origin, false};
  const Vector3d middle(centre.x(), 0, centre.z());
  const std::string name = Name("axle", false);
  const std::string mass_name = "m_" + points_.axle + "_axle";
  const std::string roll_name = "I_" + points_.axle + "_axle";
  const auto wheel = [&](double side) {
    return "    <visual>\n      <origin xyz=\"" + XyzText(middle + Vector3d(0, side * centre.y(), 0) - origin) +
           "\" rpy=\"1.5708 0 0\"/>\n      <geometry><cylinder radius=\"" +
           NumberText(std::round(height_ * 1e3) * 1e-3) + "\" length=\"0.2\"/></geometry>\n    </visual>\n";
  };
  // Alike in roll and yaw, as rods across the car are.
  const std::string pitch = known ? NumberText(known->inertia(1, 1)) : "3";
  text_ += "  <link name=\"" + name + "\">\n    <inertial>\n      <origin xyz=\"" +
           XyzText((known ? known->com : middle) - origin) + "\"/>\n      <mass value=\"$" + mass_name +
           "\"/>\n      <inertia ixx=\"$" + roll_name + "\" iyy=\"" + pitch + "\" izz=\"$" + roll_name +
           "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n    </inertial>\n" + wheel(1) + wheel(-1) +
           "    <visual>\n      <origin xyz=\"" + XyzText(middle - origin) + "\"/>\n      <geometry><box size=\"0.08 " +
           NumberText(track) + " 0.08\"/></geometry>\n    </visual>\n  </link>\n";
  Add(ParameterText{
      .name = mass_name,
      .value = mass,
      .lower = known ? std::round(0.7 * mass) : 70,
      .upper = known ? std::round(1.4 * mass) : 300,
      .precision = 0.1,
      .unit = "kg",
      .source = known ? guess_.known.source + ": axle with wheels and half the links"
                      : "estimate, of a passenger car: axle with wheels, half the links; 200 to 300 kg off road"});
  Add(ParameterText{.name = roll_name,
                    .value = roll,
                    .lower = std::round(0.4 * roll),
                    .upper = std::round(3 * roll),
                    .precision = 0.1,
                    .unit = "kg*m^2",
                    .source = known ? guess_.known.source + ": of all its parts"
                                    : "estimate: half the mass spread over the track, half in the wheels"});
}

}  // namespace fourpost
