#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <Eigen/Core>

// Cars with one axle: the body slides upright, the wheels stand at (0, +-0.75, 0.3) with a radius of 0.3 m, and all
// points are given in the vehicle's axes, left side.
namespace fourpost::axle_cars {

using Vec = Eigen::Vector3d;

inline const Vec kWheel(0, 0.75, 0.3);
inline constexpr double kRadius = 0.3;
/// Of the wheels' links, where they are turned: camber and toe as drawn.
inline const Vec kTurn(0.02, 0, 0.01);

inline std::string Text(const Vec& v) {
  char text[96];
  std::snprintf(text, sizeof text, "%.17g %.17g %.17g", v.x(), v.y(), v.z());
  return text;
}

inline std::string Body(const std::string& name, double mass) {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + std::to_string(mass) +
         "\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/></inertial></link>\n";
}
inline std::string Floating(const std::string& link) {
  return "<joint name=\"" + link + "\" type=\"floating\"><parent link=\"body\"/><child link=\"" + link +
         "\"/></joint>\n";
}
/// Turns about the line from one point to another; its frame lies at the first.
inline std::string Turning(const std::string& link, const Vec& first, const Vec& second) {
  return "<joint name=\"" + link + "\" type=\"continuous\"><parent link=\"body\"/><child link=\"" + link +
         "\"/><origin xyz=\"" + Text(first) + "\"/><axis xyz=\"" + Text(second - first) + "\"/></joint>\n";
}
inline std::string Frame(const std::string& name, const std::string& link, const Vec& xyz) {
  return "<fp:frame name=\"" + name + "\" link=\"" + link + "\" xyz=\"" + Text(xyz) + "\"/>\n";
}
inline std::string Join(const std::string& tag, const std::string& name, const std::string& parent,
                        const std::string& child) {
  return "<fp:" + tag + " name=\"" + name + "\" parent=\"" + parent + "\" child=\"" + child + "\"/>\n";
}
/// A rod from the body to a link with the vehicle's axes at `origin`.
inline std::string Rod(const std::string& name, const std::string& link, const Vec& inner, const Vec& outer) {
  return Frame("in_" + name, "body", inner) + Frame("out_" + name, link, outer) +
         Join("rod", name, "in_" + name, "out_" + name);
}
inline std::string Coil(const std::string& name, const std::string& link, const Vec& top, const Vec& foot) {
  return Frame("top_" + name, "body", top) + Frame("foot_" + name, link, foot) + "<fp:spring name=\"" + name +
         "\" parent=\"top_" + name + "\" child=\"foot_" + name + "\"><linear stiffness=\"30 N/mm\"/></fp:spring>\n";
}
inline std::string Tyre(const std::string& name, const std::string& link, const Vec& centre) {
  return "<fp:tyre name=\"" + name + "\" link=\"" + link + "\" xyz=\"" + Text(centre) +
         "\" stiffness=\"200 N/mm\" radius=\"0.3 m\"/>\n<fp:post name=\"" + name + "\" under=\"" + name + "\"/>\n";
}
/// The wheel on its carrier, turned against it; `origin` of the carrier's frame.
inline std::string Hub(const std::string& carrier, const Vec& origin) {
  return Body("hub_left", 15) + "<joint name=\"hub_left\" type=\"fixed\"><parent link=\"" + carrier +
         "\"/><child link=\"hub_left\"/><origin xyz=\"" + Text(kWheel - origin) + "\" rpy=\"" + Text(kTurn) +
         "\"/></joint>\n" + Tyre("wheel_left", "hub_left", Vec::Zero());
}
inline std::string Car(const std::string& parts, bool is_mirrored = true) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"axle\" xmlns:fp=\"urn:fourpost:vehicle:1\">\n" +
         std::string(is_mirrored ? "<fp:mirror from=\"_left\" to=\"_right\"/>\n" : "") + "<link name=\"ground\"/>\n" +
         Body("body", 600) +
         "<joint name=\"body\" type=\"prismatic\"><parent link=\"ground\"/><child link=\"body\"/><axis xyz=\"0 0 1\"/>"
         "<limit effort=\"0\" velocity=\"0\"/></joint>\n" +
         parts + "</robot>\n";
}

struct Link2 {
  Vec inner;
  Vec outer;
};

struct Wishbone {
  Vec front;
  Vec rear;
  Vec ball;
};

inline const Wishbone kLower{{0.15, 0.35, 0.22}, {-0.20, 0.33, 0.20}, {0.0, 0.68, 0.18}};
inline const Wishbone kUpper{{0.10, 0.42, 0.46}, {-0.12, 0.42, 0.44}, {-0.02, 0.64, 0.45}};
inline const Link2 kTrackRod{{0.12, 0.36, 0.25}, {0.13, 0.66, 0.24}};
inline const Link2 kWishboneCoil{{0.0, 0.45, 0.62}, {0.0, 0.55, 0.20}};

inline std::string Arm(const std::string& name, const Wishbone& arm, const std::string& carrier) {
  return Body(name + "_left", 3) + Turning(name + "_left", arm.front, arm.rear) +
         Frame(name + "_end_left", name + "_left", arm.ball - arm.front) +
         Frame(name + "_pin_left", carrier, arm.ball) +
         Join("ball", name + "_left", name + "_end_left", name + "_pin_left");
}

inline std::string DoubleWishbone() {
  return Car(Body("upright_left", 8) + Floating("upright_left") + Arm("lower", kLower, "upright_left") +
             Arm("upper", kUpper, "upright_left") +
             Rod("track_rod_left", "upright_left", kTrackRod.inner, kTrackRod.outer) +
             Coil("coil_left", "lower_left", kWishboneCoil.inner, kWishboneCoil.outer - kLower.front) +
             Hub("upright_left", Vec::Zero()));
}

inline const Wishbone kStrutArm{{0.15, 0.36, 0.20}, {-0.22, 0.36, 0.19}, {0.01, 0.70, 0.17}};
inline const Link2 kStrutRod{{-0.14, 0.36, 0.25}, {-0.13, 0.67, 0.24}};
inline const Vec kStrutTop(-0.03, 0.56, 0.88);
inline const Vec kStrutFoot(0.0, 0.62, 0.40);

/// The piston slides in the upright and turns in its top mount.
inline std::string MacPherson() {
  return Car(Body("upright_left", 8) + Floating("upright_left") + Arm("lower", kStrutArm, "upright_left") +
             Rod("track_rod_left", "upright_left", kStrutRod.inner, kStrutRod.outer) + Body("piston_left", 2) +
             "<joint name=\"piston_left\" type=\"prismatic\"><parent link=\"upright_left\"/><child "
             "link=\"piston_left\"/><origin xyz=\"" +
             Text(kStrutTop) + "\"/><axis xyz=\"" + Text(kStrutTop - kStrutFoot) +
             "\"/><limit effort=\"0\" velocity=\"0\"/></joint>\n" + Frame("mount_left", "body", kStrutTop) +
             Join("ball", "mount_left", "mount_left", "piston_left") +
             Coil("coil_left", "upright_left", kStrutTop, kStrutFoot) + Hub("upright_left", Vec::Zero()));
}

inline const Link2 kTrailingAxis{{0.45, 0.40, 0.33}, {0.45, 0.60, 0.33}};
inline const Link2 kSemiTrailingAxis{{0.40, 0.30, 0.28}, {0.30, 0.62, 0.30}};
inline const Link2 kArmCoil{{0.2, 0.55, 0.62}, {0.2, 0.55, 0.30}};

inline std::string OnOneAxis(const Link2& axis) {
  return Car(Body("arm_left", 8) + Turning("arm_left", axis.inner, axis.outer) +
             Coil("coil_left", "arm_left", kArmCoil.inner, kArmCoil.outer - axis.inner) + Hub("arm_left", axis.inner));
}

inline const std::array<Link2, 5> kFiveLinks = {{{{0.05, 0.36, 0.18}, {0.02, 0.68, 0.16}},
                                                 {{-0.22, 0.38, 0.20}, {-0.04, 0.68, 0.17}},
                                                 {{0.08, 0.42, 0.44}, {0.03, 0.64, 0.45}},
                                                 {{-0.15, 0.45, 0.43}, {-0.03, 0.63, 0.46}},
                                                 {{-0.14, 0.35, 0.25}, {-0.15, 0.66, 0.24}}}};
inline const Link2 kFiveLinkCoil{{0.0, 0.50, 0.70}, {0.0, 0.62, 0.20}};

inline std::string FiveLink() {
  std::string rods;
  for (std::size_t i = 0; i < kFiveLinks.size(); ++i)
    rods += Rod("link" + std::to_string(i) + "_left", "upright_left", kFiveLinks[i].inner, kFiveLinks[i].outer);
  return Car(Body("upright_left", 8) + Floating("upright_left") + rods +
             Coil("coil_left", "upright_left", kFiveLinkCoil.inner, kFiveLinkCoil.outer) +
             Hub("upright_left", Vec::Zero()));
}

/// Two lower rods, an upper one and a Panhard rod.
inline const std::array<Link2, 4> kBeamLinks = {{{{0.60, 0.45, 0.28}, {0.02, 0.50, 0.25}},
                                                 {{0.60, -0.45, 0.28}, {0.02, -0.50, 0.25}},
                                                 {{0.50, 0.05, 0.52}, {0.0, 0.05, 0.45}},
                                                 {{-0.10, -0.45, 0.42}, {-0.10, 0.50, 0.36}}}};
inline const Link2 kBeamCoil{{0.0, 0.45, 0.70}, {0.0, 0.50, 0.38}};

inline Vec Mirrored(const Vec& v) { return {v.x(), -v.y(), v.z()}; }

inline std::string BeamAxle() {
  std::string rods;
  for (std::size_t i = 0; i < kBeamLinks.size(); ++i)
    rods += Rod("rod" + std::to_string(i), "beam", kBeamLinks[i].inner, kBeamLinks[i].outer);
  return Car(Body("beam", 80) + Floating("beam") + rods + Coil("coil_left", "beam", kBeamCoil.inner, kBeamCoil.outer) +
                 Coil("coil_right", "beam", Mirrored(kBeamCoil.inner), Mirrored(kBeamCoil.outer)) +
                 Tyre("wheel_left", "beam", kWheel) + Tyre("wheel_right", "beam", Mirrored(kWheel)),
             false);
}

}  // namespace fourpost::axle_cars
