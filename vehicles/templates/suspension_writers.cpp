#include <cmath>

#include "analysis/text/number.h"
#include "vehicles/templates/axle_writer.h"
#include "vehicles/templates/suspension_kind.h"

namespace fourpost {
namespace {

using Eigen::Vector3d;

/// Bushes of the links of a passenger car's axle, see docs/suspensions.md.
void AddLinkBushes(AxleWriter& axle) {
  const std::string name = axle.points().axle + "_link";
  axle.Add(ParameterText{.name = "k_" + name,
                         .value = 3.4,
                         .lower = 1,
                         .upper = 15,
                         .precision = 0.01,
                         .unit = "kN/mm",
                         .source = "estimate: radial rates of 6.8 kN/mm of rubber bushes at both ends, in series "
                                   "(bush of 36 mm, Adkins and Gent 1954)"});
  axle.Add(ParameterText{.name = "kr_" + name,
                         .value = 600,
                         .lower = 100,
                         .upper = 2000,
                         .precision = 1,
                         .unit = "N*m/rad",
                         .source = "estimate: conical rate of such a bush; its torsional rate is 0.1 of it"});
}

void WriteLowerLinks(AxleWriter& axle) {
  axle.BeamAxle();
  axle.Rod("lower_link", "lower_body", "lower_axle", "axle");
}

}  // namespace

void WriteDoubleWishbone(AxleWriter& axle) {
  axle.Comment(
      "Both arms turn on the body. The knuckle has six degrees of freedom; two ball joints take three each, the\n"
      "       tie rod one: 1 + 1 + 6 - 3 - 3 - 1 = 1 is left, the wheel's travel. Arms of 5 and 3 kg are estimates.");
  axle.Arm("lower_arm", 5, axle.points().kind->arms[0]);
  axle.Arm("upper_arm", 3, axle.points().kind->arms[1]);
  axle.Empty("knuckle");
  axle.Floating("knuckle");
  axle.Wheel("knuckle");
  axle.Ball("lower_ball", "lower_arm", "knuckle");
  axle.Ball("upper_ball", "upper_arm", "knuckle");
  axle.Rod("tie_rod", "tie_inner", "tie_outer", "knuckle");
  axle.Struts();
}

void WriteMacPherson(AxleWriter& axle) {
  axle.Comment(
      "The strut swings both ways about its top mount, turns and slides along its axis: four degrees of freedom, and\n"
      "       the arm has one. Ball joint and tie rod take four of the five: the wheel's travel is left.");
  const Vector3d top = axle.points().At("strut_top");
  const Vector3d along = axle.points().At("strut_bottom") - top;
  axle.Arm("lower_arm", 5, axle.points().kind->arms[0]);
  axle.Empty("strut_roll");
  axle.Joint("strut_roll", "body", "continuous", top, Vector3d::UnitX());
  axle.Empty("strut_pitch");
  axle.Joint("strut_pitch", "strut_roll", "continuous", top, Vector3d::UnitY());
  axle.Empty("strut_steer");
  axle.Joint("strut_steer", "strut_pitch", "continuous", top, along);
  axle.Empty("knuckle");
  axle.Joint("knuckle", "strut_steer", "prismatic", Vector3d::Zero(), along);
  axle.Wheel("knuckle");
  axle.Ball("lower_ball", "lower_arm", "knuckle");
  axle.Rod("tie_rod", "tie_inner", "tie_outer", "knuckle");
  axle.StrutOf("strut_top", "strut_bottom", "knuckle");
}

void WriteTrailingArm(AxleWriter& axle) {
  axle.Comment("The arm turns on the body and carries the wheel; its 10 kg are an estimate.");
  axle.Arm("arm", 10, axle.points().kind->arms[0]);
  axle.Wheel("arm");
  axle.Struts();
}

void WriteMultilink(AxleWriter& axle) {
  axle.Comment(
      "Five links leave the knuckle one of its six degrees of freedom. They have no mass of their own: half of\n"
      "       each counts with the wheel.");
  axle.Empty("knuckle");
  axle.Floating("knuckle");
  axle.Wheel("knuckle");
  for (const char* link : {"lower_front", "lower_rear", "upper_front", "upper_rear", "tie"})
    axle.Rod(std::string(link) + "_link", std::string(link) + "_inner", std::string(link) + "_outer", "knuckle");
  axle.Struts();
}

void WriteTwistBeam(AxleWriter& axle) {
  axle.Comment(
      "Two arms with half of the beam each, on bushes. They turn against each other about the beam's shear centre, "
      "which\n"
      "       takes five degrees of freedom; the beam's torsion is a rate about y there. 11 kg a side are an "
      "estimate.");
  const AxlePoints& points = axle.points();
  axle.Body("arm", 11, {points.At("pivot"), points.At("shear_centre"), points.At("wheel_centre")});
  axle.Floating("arm");
  axle.Wheel("arm");
  const std::string seat = axle.Frame("body", "pivot");
  const std::string end = axle.Frame("arm", "pivot");
  axle.Add("  <fp:bushing name=\"" + axle.Name("pivot") + "\" parent=\"" + seat + "\" child=\"" + end +
           "\" preload=\"equilibrium\">\n    <translation x=\"$k_" + points.axle + "_pivot\" y=\"0.3*$k_" +
           points.axle + "_pivot\" z=\"$k_" + points.axle +
           "_pivot\"/>\n    <rotation x=\"1000 N*m/rad\" y=\"100 N*m/rad\" z=\"1000 "
           "N*m/rad\"/>\n    <loss factor=\"0.1\" frequency=\"30 Hz\"/>\n  </fp:bushing>\n");
  const std::string beam = axle.Frame("arm", "beam", points.At("shear_centre"), true);
  const std::string other = beam.substr(0, beam.size() - 4) + "right";
  axle.Add("  <fp:hinge name=\"" + axle.Name("beam", false) + "\" parent=\"" + beam + "\" child=\"" + other +
           "\" axis=\"0 1 0\"/>\n  <fp:bushing name=\"" + axle.Name("beam", false) + "\" parent=\"" + beam +
           "\" child=\"" + other + "\">\n    <rotation y=\"$kr_" + points.axle + "_beam\"/>\n  </fp:bushing>\n");
  axle.Add(ParameterText{.name = "k_" + points.axle + "_pivot",
                         .value = 2.5,
                         .lower = 0.5,
                         .upper = 10,
                         .precision = 0.01,
                         .unit = "kN/mm",
                         .source = "estimate: radial rate of a large voided bush; its axial rate is 0.3 of it"});
  axle.Add(
      ParameterText{.name = "kr_" + points.axle + "_beam",
                    .value = 1.5,
                    .lower = 0.3,
                    .upper = 10,
                    .precision = 0.01,
                    .unit = "kN*m/rad",
                    .source = "estimate: torsional rate of the beam's open section from arm to arm, with a bar in it"});
  axle.Struts();
}

void WriteFourLink(AxleWriter& axle) {
  axle.Comment(
      "Four links leave the axle two of its six degrees of freedom, heave and roll; the pair that converges in plan\n"
      "       locates it sideways. Half of each link counts with the axle.");
  WriteLowerLinks(axle);
  axle.Rod("upper_link", "upper_body", "upper_axle", "axle");
  axle.Struts();
}

void WriteThreeLinkPanhard(AxleWriter& axle) {
  axle.Comment(
      "Three links and the Panhard rod leave the axle two of its six degrees of freedom, heave and roll. Half of each\n"
      "       link counts with the axle.");
  WriteLowerLinks(axle);
  axle.Rod("upper_link", "upper_body", "upper_axle", "axle");
  axle.Rod("panhard_rod", "panhard_body", "panhard_axle", "axle");
  axle.Struts();
}

void WriteFourLinkPanhard(AxleWriter& axle) {
  axle.Comment(
      "Four links and a Panhard rod are one constraint more than leaves heave and roll: the axle rolls only because "
      "its\n"
      "       bushes yield. Here the upper links stand on bushes, which stand for those of both ends; the others are\n"
      "       rigid. Half of each link counts with the axle.");
  WriteLowerLinks(axle);
  axle.LinkOnBush("upper_link", "upper_body", "upper_axle", "axle");
  axle.Rod("panhard_rod", "panhard_body", "panhard_axle", "axle");
  AddLinkBushes(axle);
  axle.Struts();
}

void WriteAFrame(AxleWriter& axle) {
  axle.Comment(
      "The A-frame turns on the body about the line through both of its bushes; its ball joint takes three degrees of\n"
      "       freedom, each lower link one: 6 + 1 - 3 - 2 = 2 are left, heave and roll. Its 6 kg are an estimate.");
  const AxlePoints& points = axle.points();
  WriteLowerLinks(axle);
  const Vector3d left = points.At("frame_body");
  const Vector3d middle(left.x(), 0, left.z());
  const Vector3d right(left.x(), -left.y(), left.z());
  axle.Central("frame", middle);
  axle.Body("frame", 6, {left, right, points.At("frame_ball")}, false);
  axle.Joint("frame", "body", "continuous", middle, Vector3d::UnitY(), false);
  axle.Ball("frame_ball", "frame", "axle");
  axle.Struts();
}

void WriteLeafSpring(AxleWriter& axle) {
  axle.Comment(
      "Each leaf spring as a link and three rates. The axle's seat moves about a point at three quarters of the front\n"
      "       half's length (SAE HS-788, three-link equivalent of a leaf with parallel halves). At the seat stand the\n"
      "       vertical rate, the lateral one and that of wind-up, k l^2 of cantilevers of k/2 and length l each. "
      "Friction\n"
      "       between the leaves is off.");
  const AxlePoints& points = axle.points();
  axle.BeamAxle();
  const Vector3d seat = points.At("seat");
  const double front = (points.At("front_eye") - seat).norm();
  const double rear = (points.At("rear_eye") - seat).norm();
  const Vector3d pivot = seat + 0.75 * (points.At("front_eye") - seat);
  const std::string on_body = axle.Frame("body", "leaf_pivot", pivot, true);
  const std::string on_axle = axle.Frame("axle", "seat");
  const std::string rest = axle.Frame("body", "seat");
  const std::string above = axle.Frame("body", "leaf_top", seat + 0.2 * Vector3d::UnitZ(), true);
  axle.Add("  <fp:rod name=\"" + axle.Name("leaf_link") + "\" parent=\"" + on_body + "\" child=\"" + on_axle +
           "\"/>\n  <fp:bushing name=\"" + axle.Name("leaf_sides") + "\" parent=\"" + rest + "\" child=\"" + on_axle +
           "\" preload=\"equilibrium\">\n    <translation y=\"$k_" + points.axle +
           "_leaf_lateral\"/>\n    <rotation y=\"$kr_" + points.axle +
           "_windup\"/>\n    <loss factor=\"0.1\" frequency=\"10 Hz\"/>\n  </fp:bushing>\n");
  const std::string damper_top = axle.Frame("body", "damper_top");
  axle.CoilAndDamper(above, on_axle);
  axle.Friction("leaf_friction", above, on_axle,
                {.name = "f_" + points.axle + "_leaf",
                 .value = 0,
                 .lower = 0,
                 .upper = 1000,
                 .precision = 1,
                 .unit = "N",
                 .source = "off; friction between the leaves of one spring, a range that is usual of passenger cars"});
  const double windup = std::round(axle.guess().spring_rate * front * rear * 1e-2) * 0.1;
  axle.Add(ParameterText{.name = "kr_" + points.axle + "_windup",
                         .value = windup,
                         .lower = std::round(2 * windup) * 0.1,
                         .upper = std::round(50 * windup) * 0.1,
                         .precision = 0.01,
                         .unit = "kN*m/rad",
                         .source = "estimate: vertical rate times the product of both halves' lengths"});
  axle.Add(ParameterText{.name = "k_" + points.axle + "_leaf_lateral",
                         .value = 0.3,
                         .lower = 0.1,
                         .upper = 2,
                         .precision = 0.01,
                         .unit = "kN/mm",
                         .source = "estimate, one leaf spring with its eyes and shackle, sideways"});
  axle.Tyre();
  axle.Sensors();
}

}  // namespace fourpost
