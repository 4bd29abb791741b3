#include "vehicles/tags/tag_table.h"

#include <algorithm>

namespace fourpost {
namespace {

using Kind = AttributeKind;

const AttributeRule kNameRule = {.name = "name", .kind = Kind::kName, .doc = "unique among tags of its kind"};
const AttributeRule kLinkRule = {.name = "link", .kind = Kind::kLink, .doc = "link that carries the point"};
const AttributeRule kXyzRule = {.name = "xyz", .kind = Kind::kVector, .doc = "the point in link axes, in m"};
const AttributeRule kParentRule = {.name = "parent", .kind = Kind::kPoint, .doc = "frame or link at one end"};
const AttributeRule kChildRule = {.name = "child", .kind = Kind::kPoint, .doc = "frame or link at the other end"};
const AttributeRule kGuideRule = {.name = "axis",
                                  .kind = Kind::kDirection,
                                  .required = false,
                                  .doc =
                                      "direction of a guided strut in axes of the parent's link; without it the "
                                      "element acts along the line that joins its ends"};
const AttributeRule kSensorAxisRule = {.name = "axis",
                                       .kind = Kind::kDirection,
                                       .required = false,
                                       .fallback = "0 0 1",
                                       .doc = "measuring direction in link axes"};

AttributeRule SensorType(std::string_view type) {
  return {.name = "type", .kind = Kind::kChoice, .doc = "kind of sensor", .choices = {type}};
}

/// A number of this dimension or a parameter; `fallback` empty: required.
AttributeRule Measure(std::string_view name, const Dimension& dimension, Sign sign, std::string_view doc,
                      std::string_view fallback = {}) {
  return {.name = name,
          .kind = Kind::kScalar,
          .required = fallback.empty(),
          .fallback = fallback,
          .doc = doc,
          .dimension = dimension,
          .sign = sign};
}

/// The rule with the range in which road vehicles have it.
AttributeRule Usual(std::string_view least, std::string_view greatest, AttributeRule rule) {
  rule.usual_least = least;
  rule.usual_greatest = greatest;
  return rule;
}

AttributeRule Stiffness(std::string_view doc, Sign sign = Sign::kNotNegative) {
  return Measure("stiffness", kStiffness, sign, doc);
}

/// Without it friction has another law.
AttributeRule StickingStiffness() {
  AttributeRule rule = Usual("10 kN/m", "100 MN/m", Stiffness("force per extension before it slides", Sign::kPositive));
  rule.required = false;
  return rule;
}

/// A tyre with a table has none.
AttributeRule TyreStiffness() {
  AttributeRule rule =
      Usual("20 kN/m", "2 MN/m", Stiffness("vertical force per deflection, with a progression of an unloaded tyre"));
  rule.required = false;
  return rule;
}

AttributeRule Rate(std::string_view name, std::string_view doc, std::string_view least = "10 N*s/m") {
  return Usual(least, "100 kN*s/m", Measure(name, kDamping, Sign::kNotNegative, doc));
}

AttributeRule Cubic(std::string_view doc) {
  return Measure("cubic", kCubicStiffness, Sign::kNotNegative, doc, "0 N/m^3");
}

/// Of a hard point from where it is drawn.
AttributeRule Shift(std::string_view name) {
  return Measure(name, kLength, Sign::kAny,
                 "shift of the point along this axis of the link, added to `xyz`; as a parameter, a hard point that a "
                 "fit of `kinematics` moves",
                 "0 mm");
}

std::vector<AttributeRule> Components(const Dimension& dimension, std::string_view fallback, std::string_view greatest,
                                      std::string_view doc) {
  std::vector<AttributeRule> rules;
  for (std::string_view axis : {"x", "y", "z"})
    rules.push_back(Usual("", greatest, Measure(axis, dimension, Sign::kNotNegative, doc, fallback)));
  return rules;
}

AttributeRule Preload(std::string_view doc) {
  return {.name = "preload",
          .kind = Kind::kScalar,
          .required = false,
          .fallback = "equilibrium",
          .doc = doc,
          .dimension = kForce,
          .word = "equilibrium",
          .usual_greatest = "200 kN"};
}

AttributeRule Bound(std::string_view name, std::string_view doc) {
  return {.name = name, .kind = Kind::kQuantity, .required = false, .doc = doc};
}

AttributeRule File(std::string_view doc) { return {.name = "file", .required = false, .doc = doc}; }

AttributeRule Scale() {
  return Usual("0.1", "10",
               Measure("scale", kDimensionless, Sign::kPositive,
                       "factor of all forces; as a parameter, a fit scales the curve", "1"));
}

std::vector<TagRule> MakeParameterTags() {
  return {
      {.path = "fp:parameter",
       .doc =
           "A number that a fit may change, used as `$name` or bound to numbers of the tree. Without bounds it is "
           "fixed; give all three of lower, upper and precision or none. `NAME_at_2` holds the value of the parameter "
           "NAME at the setting 2 of a study's `control` (`1p5` is 1.5, `m1` is -1) and needs no other use.",
       .attributes = {{.name = "name", .kind = Kind::kName, .doc = "letters, digits and '_'"},
                      {.name = "value", .kind = Kind::kQuantity, .doc = "the number, with the unit it is shown in"},
                      Bound("lower", "least value of a search"),
                      Bound("upper", "greatest value of a search"),
                      Bound("precision",
                            "step of a search, above zero, at most upper - lower and at least a 2^53rd of it"),
                      {.name = "prior_sd",
                       .kind = Kind::kQuantity,
                       .required = false,
                       .doc = "standard deviation, above zero, of what is known of `value` before any fit"},
                      {.name = "like",
                       .kind = Kind::kName,
                       .required = false,
                       .doc = "another parameter of the same kind, whose ratio to this one is known before any fit: "
                              "that of their values, to `like_sd`; both are positive"},
                      {.name = "like_sd",
                       .kind = Kind::kNumber,
                       .required = false,
                       .doc = "standard deviation of the logarithm of that ratio, above zero: 0.1 is about 10 %"},
                      {.name = "source", .doc = "where the value comes from"}}},
      {.path = "fp:parameter/fp:bind",
       .doc = "Ties a number of the tree to the parameter. The tree's number must equal factor times value.",
       .attributes = {{.name = "to",
                       .kind = Kind::kTreeNumber,
                       .doc = "`link[NAME]/mass`, `link[NAME]/com/x` (y, z) or `link[NAME]/inertia/ixx` (iyy, izz, "
                              "ixy, ixz, iyz)"},
                      {.name = "factor",
                       .kind = Kind::kNumber,
                       .required = false,
                       .fallback = "1",
                       .doc = "the tree's number over the parameter"}}},
      {.path = "fp:frame",
       .doc = "A named point of a link. `<frame>` without prefix is the same.",
       .attributes = {kNameRule,
                      kLinkRule,
                      kXyzRule,
                      {.name = "rpy",
                       .kind = Kind::kVector,
                       .required = false,
                       .fallback = "0 0 0",
                       .doc = "orientation in link axes, roll pitch yaw in rad, used by elements that need axes"},
                      Shift("dx"),
                      Shift("dy"),
                      Shift("dz")}},
  };
}

std::vector<TagRule> MakeMirrorTags() {
  return {
      {.path = "fp:mirror",
       .doc = "Gives every link, joint and tag of ours whose name ends in `from` a mirror partner whose name ends in "
              "`to`, "
              "mirrored left to right. What is written out under a partner's name stands instead. An anti-roll bar "
              "between partners stays single.",
       .attributes = {{.name = "from", .kind = Kind::kName, .doc = "end of the names to mirror, such as `_left`"},
                      {.name = "to", .kind = Kind::kName, .doc = "end of their partners' names, such as `_right`"}}},
  };
}

std::vector<TagRule> MakeSolidTags() {
  return {
      {.path = "fp:solid",
       .doc = "Gives a link without `<inertial>` the mass, centre of mass and inertia that its visual shapes, all of "
              "them, have at one density. A mesh must be closed and face outward. What several shapes share counts "
              "several times.",
       .attributes = {{.name = "link", .kind = Kind::kLink, .doc = "link whose shapes are filled; not the ground"},
                      {.name = "density",
                       .kind = Kind::kScalar,
                       .doc = "mass per volume; as a parameter, mass and inertia follow it",
                       .dimension = kDensity,
                       .sign = Sign::kPositive}}},
  };
}

std::vector<TagRule> MakeSpringTags() {
  const AttributeRule preload = Preload("tension in the design pose; `equilibrium`: whatever holds that pose at rest");
  const AttributeRule free_length = {.name = "free_length",
                                     .kind = Kind::kScalar,
                                     .required = false,
                                     .doc = "length at which the whole law has no tension, in place of a preload",
                                     .dimension = kLength,
                                     .sign = Sign::kPositive,
                                     .usual_least = "50 mm",
                                     .usual_greatest = "2 m"};
  return {
      {.path = "fp:spring",
       .doc = "A spring between two points. x is its extension from the design pose, which cubic term and knees use "
              "also when a free_length stands in place of the preload.",
       .attributes = {kNameRule, kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:spring/linear",
       .occurs = Occurs::kOneOfAll,
       .doc = "tension = preload + stiffness x, or stiffness (length - free_length)",
       .attributes = {Usual("1 kN/m", "1 MN/m", Stiffness("force per extension")), preload, free_length}},
      {.path = "fp:spring/cubic",
       .occurs = Occurs::kOneOfAll,
       .doc = "tension = preload + stiffness x + cubic x^3",
       .attributes = {Usual("1 kN/m", "1 MN/m", Stiffness("force per extension in the design pose")),
                      Measure("cubic", kCubicStiffness, Sign::kNotNegative, "hardening on either side"), preload,
                      free_length}},
      {.path = "fp:spring/multirate",
       .occurs = Occurs::kOneOfAll,
       .doc = "A spring whose rate changes at knees, as when coils close or a helper comes in. "
              "tension = preload + stiffness x up to the first knee of either side, and on without a step.",
       .attributes = {Usual("1 kN/m", "1 MN/m", Stiffness("force per extension about the design pose")), preload,
                      free_length}},
      {.path = "fp:spring/multirate/knee",
       .doc = "The rate beyond x = `at`: further in bump when `at` is below zero, further in extension when it "
              "is above. Knees of a side stand in the order in which they are met.",
       .attributes = {Usual("0.1 mm", "500 mm", Measure("at", kLength, Sign::kAny, "extension at the knee; not zero")),
                      Usual("100 N/m", "100 MN/m", Stiffness("force per extension beyond the knee"))}},
      {.path = "fp:spring/table",
       .occurs = Occurs::kOneOfAll,
       .doc = "A measured spring: a monotone cubic (Fritsch and Carlson) c through its points, straight on beyond the "
              "ends. tension = preload + c(at + x) - c(at)",
       .attributes = {Usual("", "1 m",
                            Measure("at", kLength, Sign::kAny,
                                    "extension in the table in the design pose; of a file that states a free length, "
                                    "the default is the length in the design pose less that",
                                    "0 m")),
                      preload, free_length,
                      File("a file with the points, instead of `<point>`: a table with columns extension and force, or "
                           "an Adams property file (.spr)"),
                      Scale()}},
      {.path = "fp:spring/table/point",
       .doc = "A point of the curve, in the order of rising extension and force; both are negative in bump, as "
              "from a bench that counts from the free length.",
       .attributes = {Usual("", "1 m", Measure("extension", kLength, Sign::kAny, "extension from the table's zero")),
                      Usual("", "200 kN", Measure("force", kForce, Sign::kAny, "tension"))}},
      {.path = "fp:stop",
       .doc = "Bump and rebound stops between two points: no force until the gap is closed, give one or both.",
       .attributes = {kNameRule, kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:stop/bump",
       .occurs = Occurs::kAtMostOnce,
       .doc = "compression force = stiffness s + cubic s^3, s = compression beyond the gap",
       .attributes = {Usual("0.1 mm", "500 mm",
                            Measure("gap", kLength, Sign::kNotNegative, "free compression from the design pose")),
                      Usual("1 kN/m", "100 MN/m", Stiffness("force per compression of the stop")),
                      Cubic("hardening of the stop")}},
      {.path = "fp:stop/rebound",
       .occurs = Occurs::kAtMostOnce,
       .doc = "tension = stiffness s + cubic s^3, s = extension beyond the gap",
       .attributes = {Usual("0.1 mm", "500 mm",
                            Measure("gap", kLength, Sign::kNotNegative, "free extension from the design pose")),
                      Usual("1 kN/m", "100 MN/m", Stiffness("force per extension of the stop")),
                      Cubic("hardening of the stop")}},
  };
}

std::vector<TagRule> MakeDamperTags() {
  const auto speed = [](std::string_view name, std::string_view doc) {
    return Usual("1 mm/s", "5 m/s", Measure(name, kVelocity, Sign::kPositive, doc));
  };
  const auto formerly = [](std::string_view former, AttributeRule rule) {
    rule.former = former;
    return rule;
  };
  const AttributeRule bump = formerly("compression", Rate("bump", "force per speed in bump"));
  const AttributeRule rebound = Rate("rebound", "force per speed in rebound");
  return {
      {.path = "fp:damper",
       .doc = "A damper between two points: force f, tension positive, at the rate v of its extension, rebound "
              "positive. Rebound pulls the points together.",
       .attributes = {kNameRule, kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:damper/linear",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = rate v",
       .attributes = {Rate("rate", "force per speed")}},
      {.path = "fp:damper/bilinear",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = rebound v for v > 0, bump v for v < 0",
       .attributes = {bump, rebound}},
      {.path = "fp:damper/smooth",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = ((rebound + bump) / 2 + (rebound - bump) / 2 tanh(v / speed)) v",
       .attributes = {bump, rebound, speed("speed", "speed over which one rate passes into the other")}},
      {.path = "fp:damper/digressive",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = rebound v up to v = rebound_knee and on with the slope rebound_beyond; likewise in bump.",
       .attributes = {bump, rebound, formerly("compression_knee", speed("bump_knee", "speed of the knee in bump")),
                      speed("rebound_knee", "speed of the knee in rebound"),
                      formerly("compression_beyond", Rate("bump_beyond", "slope beyond the knee in bump", "1 N*s/m")),
                      Rate("rebound_beyond", "slope beyond the knee in rebound", "1 N*s/m")}},
      {.path = "fp:damper/saturating",
       .occurs = Occurs::kOneOfAll,
       .doc = "f = rebound v / (1 + v / rebound_speed) for v > 0, likewise in bump: the degressive damper "
              "c v / (1 + d |v|) with d = 1 / rebound_speed. It never reaches rebound times rebound_speed.",
       .attributes = {bump, rebound, speed("bump_speed", "speed in bump at which the force is half of bump v"),
                      speed("rebound_speed", "speed in rebound at which the force is half of rebound v")}},
      {.path = "fp:damper/table",
       .occurs = Occurs::kOneOfAll,
       .doc = "A measured curve: a monotone cubic (Fritsch and Carlson) through its points and (0, 0), straight on "
              "beyond the ends.",
       .attributes = {File("a file with the points, instead of `<point>`: a table with columns speed and force, or an "
                           "Adams property file (.dpr)"),
                      Scale()}},
      {.path = "fp:damper/table/point",
       .doc = "A point of the curve, in the order of rising speed and force.",
       .attributes = {Usual("", "10 m/s", Measure("speed", kVelocity, Sign::kAny, "extension rate, rebound positive")),
                      Usual("", "100 kN", Measure("force", kForce, Sign::kAny, "tension"))}},
      {.path = "fp:damper/curve",
       .occurs = Occurs::kOneOfAll,
       .doc = "A smooth curve whose slopes a fit may find: each `<segment>` has the mean slope from the one before it, "
              "seen from rest, to its speed. A monotone cubic (Fritsch and Carlson) through (0, 0) and the ends of "
              "the segments, straight on beyond the last ones. Parameters that follow each other by `like` keep it "
              "smooth where the data are silent."},
      {.path = "fp:damper/curve/segment",
       .doc = "A part of the curve, by rising speed: bump, from its fast end, then rebound.",
       .attributes = {Usual("1 mm/s", "10 m/s",
                            Measure("to", kVelocity, Sign::kAny,
                                    "its end away from rest: extension rate, bump below zero")),
                      Rate("rate", "mean slope of the force from the segment before it, or from rest", "1 N*s/m")}},
      {.path = "fp:damper/hydraulic",
       .occurs = Occurs::kOneOfAll,
       .doc = "An adjustable monotube damper with gas behind a floating piston: a bleed in both directions, a rebound "
              "and a bump valve, oil that yields, cavitation. A reconstruction of the thesis's appendix A; "
              "equations in `vehicles/laws/hydraulic_damper.h`.",
       .attributes =
           {Usual("0.01 mm^2", "100 mm^2",
                  Measure("bleed", kArea, Sign::kPositive, "effective area Cd A of the bleed")),
            Usual("10 kPa*s/kg", "1000 MPa*s/kg",
                  Measure("rebound_valve", kFlowResistance, Sign::kPositive,
                          "pressure per mass flow of the rebound valve")),
            formerly("compression_valve", Usual("10 kPa*s/kg", "1000 MPa*s/kg",
                                                Measure("bump_valve", kFlowResistance, Sign::kPositive,
                                                        "pressure per mass flow of the bump valve", "2.597 MPa*s/kg"))),
            Usual("10 MPa", "3000 MPa",
                  Measure("bulk_modulus", kPressure, Sign::kPositive, "stiffness of the oil", "300 MPa")),
            Usual("10 mm", "150 mm", Measure("piston", kLength, Sign::kPositive, "diameter of the bore", "30 mm")),
            Usual("3 mm", "100 mm", Measure("rod", kLength, Sign::kPositive, "diameter of the rod", "12.5 mm")),
            Usual("10 mm", "1 m",
                  Measure("rebound_column", kLength, Sign::kPositive,
                          "length of the oil column about the rod in the design pose", "100 mm")),
            formerly("compression_column",
                     Usual("10 mm", "1 m",
                           Measure("bump_column", kLength, Sign::kPositive,
                                   "length of the oil column before the piston in the design pose", "100 mm"))),
            Usual("0.1 MPa", "20 MPa",
                  Measure("gas_pressure", kPressure, Sign::kPositive, "pressure of the gas at rest", "2 MPa")),
            Usual("1 cm^3", "10000 cm^3",
                  Measure("gas_volume", kVolume, Sign::kPositive, "volume of the gas at rest", "60 cm^3")),
            Usual("0.5", "2",
                  Measure("gas_exponent", kDimensionless, Sign::kPositive,
                          "of the gas's changes: 1 of slow ones, 1.4 of fast ones of nitrogen", "1.3")),
            Usual("500 kg/m^3", "2000 kg/m^3",
                  Measure("density", kDensity, Sign::kPositive, "of the oil", "860 kg/m^3")),
            Usual("1 Pa", "200 kPa",
                  Measure("cavitation", kPressure, Sign::kPositive,
                          "pressure at which the oil boils: that of no chamber falls further", "5 kPa"))}},
      {.path = "fp:damper/series",
       .occurs = Occurs::kAtMostOnce,
       .doc = "A spring in line with the damper, such as its top mount: f = stiffness x + cubic x^3, x its extension. "
              "The damper's rates must be above zero then.",
       .attributes = {Usual("10 kN/m", "100 MN/m", Stiffness("force per deflection", Sign::kPositive)),
                      Cubic("hardening")}},
      {.path = "fp:damper/friction",
       .occurs = Occurs::kAtMostOnce,
       .doc =
           "Dry friction of seals, guides, leaves and bushes. Without `stiffness` it adds force tanh(v / speed), which "
           "creeps at rest; in line with the series spring, but of a hydraulic damper between the ends of both. With "
           "`stiffness` it sticks like a spring before it slides (Dahl): F' = stiffness (v - |v| F / force). Not with "
           "a "
           "series spring then, unless the damper is hydraulic.",
       .attributes = {Usual("0.1 N", "5 kN", Measure("force", kForce, Sign::kNotNegative, "friction while it slides")),
                      Usual("0.1 mm/s", "0.1 m/s",
                            Measure("speed", kVelocity, Sign::kPositive,
                                    "speed of transition about rest; not with stiffness", "2 mm/s")),
                      StickingStiffness()}},
      {.path = "fp:damper/gas",
       .occurs = Occurs::kAtMostOnce,
       .doc = "Gas pressure on the rod, between the damper's ends: tension = -force + stiffness x.",
       .attributes = {Usual("1 N", "20 kN", Measure("force", kForce, Sign::kNotNegative, "push in the design pose")),
                      Usual("", "1 MN/m",
                            Measure("stiffness", kStiffness, Sign::kNotNegative, "rise of the push per compression",
                                    "0 N/m"))}},
  };
}

std::vector<TagRule> MakeBushingTags() {
  return {
      {.path = "fp:bushing",
       .doc = "Six springs and dampers between two points, along and about the axes of the frame `parent` (of its link "
              "when `parent` is a link), measured from the design pose. Rotations are small: twice the vector part of "
              "a quaternion.",
       .attributes = {kNameRule,
                      kParentRule,
                      kChildRule,
                      {.name = "preload",
                       .kind = Kind::kChoice,
                       .required = false,
                       .fallback = "none",
                       .doc = "`equilibrium`: its translations help to hold the design pose; `none`: it has no load "
                              "there",
                       .choices = {"none", "equilibrium"}},
                      File("an Adams property file (.bus) with the rates; what is written out stands instead")}},
      {.path = "fp:bushing/translation",
       .occurs = Occurs::kAtMostOnce,
       .doc = "force = stiffness times displacement of the child's point",
       .attributes = Components(kStiffness, "0 N/m", "1000 MN/m", "stiffness along this axis")},
      {.path = "fp:bushing/rotation",
       .occurs = Occurs::kAtMostOnce,
       .doc = "torque = stiffness times angle",
       .attributes = Components(kTorque, "0 N*m/rad", "1000 MN*m/rad", "stiffness about this axis")},
      {.path = "fp:bushing/translation_damping",
       .occurs = Occurs::kAtMostOnce,
       .doc = "force = rate times velocity",
       .attributes = Components(kDamping, "0 N*s/m", "1 MN*s/m", "rate along this axis")},
      {.path = "fp:bushing/rotation_damping",
       .occurs = Occurs::kAtMostOnce,
       .doc = "torque = rate times angular velocity",
       .attributes = Components(kAngularDamping, "0 N*m*s/rad", "100 kN*m*s/rad", "rate about this axis")},
      {.path = "fp:bushing/loss",
       .occurs = Occurs::kAtMostOnce,
       .doc = "Damping of rubber: each rate = factor stiffness / (2 pi frequency), added to the others.",
       .attributes = {Usual("", "3",
                            Measure("factor", kDimensionless, Sign::kNotNegative,
                                    "loss factor: tangent of the loss angle")),
                      Usual("0.1 Hz", "1000 Hz",
                            Measure("frequency", kFrequency, Sign::kPositive, "where the loss factor holds"))}},
      {.path = "fp:actuator",
       .doc = "A force between two points that a recording gives, tension positive: an active suspension, a shaker, a "
              "body actuator of a rig (one end on the ground). A study names its channel under `actuators`; without "
              "one, and in responses to posts, it is zero.",
       .attributes = {kNameRule, kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:antiroll",
       .doc = "An anti-roll bar. It pulls on the left line with stiffness (e_left - e_right) + damping (e_left - "
              "e_right)', and pushes as much on the right one; e: extension of the line between the end of the bar's "
              "arm and what it holds on to.",
       .attributes = {kNameRule,
                      Usual("100 N/m", "10 MN/m", Stiffness("force at an arm's end per difference of the extensions")),
                      Usual("", "100 kN*s/m",
                            Measure("damping", kDamping, Sign::kNotNegative, "force per rate of that difference",
                                    "0 N*s/m"))}},
      {.path = "fp:antiroll/left",
       .occurs = Occurs::kOnce,
       .doc = "The line on the left.",
       .attributes = {kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:antiroll/right",
       .occurs = Occurs::kOnce,
       .doc = "The line on the right.",
       .attributes = {kParentRule, kChildRule, kGuideRule}},
  };
}

std::vector<TagRule> MakeTyreTags() {
  return {
      {.path = "fp:tyre",
       .doc = "A tyre on the platform under it. It stays upright however the link pitches, and leans with it in roll "
              "and yaw: its foot lies `radius` below the point `xyz`, in the plane across the link's y axis. Vertical "
              "force on the wheel = preload + stiffness s + damping s', s: how much nearer foot and platform are than "
              "in the design pose. With a progression or a `<table>` the stiffness rises with the load: force = F(d + "
              "s) + damping s', d: deflection under the preload, F(d) = stiffness d (1 + progression d) or the curve "
              "of the table.",
       .attributes =
           {kNameRule,
            kLinkRule,
            {.name = "xyz", .kind = Kind::kVector, .doc = "centre of the wheel in link axes, in m"},
            TyreStiffness(),
            Usual("0.1 1/m", "50 1/m",
                  Measure("progression", kPerLength, Sign::kNotNegative,
                          "growth of force over deflection per deflection: the rate under a load F is "
                          "sqrt(stiffness^2 + 4 stiffness progression F)",
                          "0 1/m")),
            Usual("", "20 kN*s/m",
                  Measure("damping", kDamping, Sign::kNotNegative, "vertical force per speed", "0 N*s/m")),
            Preload("compression force in the design pose; `equilibrium`: whatever holds it at rest"),
            Usual("100 mm", "2 m",
                  Measure("radius", kLength, Sign::kNotNegative,
                          "height of the point above the platform, loaded; 0: the foot is the point itself", "0 m")),
            Usual("1 kN/m", "10 MN/m",
                  Measure("lateral", kStiffness, Sign::kNotNegative,
                          "force per sideways shift of the foot, at any load", "0 N/m")),
            Usual(
                "10 N/m", "10 MN/m",
                Measure("longitudinal", kStiffness, Sign::kNotNegative,
                        "force per fore-aft shift of the foot, at any load; small for a wheel that may roll", "0 N/m")),
            Usual("", "20 kN*s/m",
                  Measure("lateral_damping", kDamping, Sign::kNotNegative,
                          "force per sideways speed of the foot, at any load", "0 N*s/m")),
            Usual("", "20 kN*s/m",
                  Measure("longitudinal_damping", kDamping, Sign::kNotNegative,
                          "force per fore-aft speed of the foot, at any load", "0 N*s/m")),
            {.name = "liftoff",
             .kind = Kind::kChoice,
             .required = false,
             .fallback = "true",
             .doc =
                 "`true`: the vertical force never pulls, while lateral and longitudinal ones stay as they are, on a "
                 "lifted tyre too; `false`: it may, as in a linear model, and commands warn where it does; not with a "
                 "progression or a table",
             .choices = {"true", "false"}}}},
      {.path = "fp:tyre/table",
       .occurs = Occurs::kAtMostOnce,
       .doc =
           "A measured load-deflection curve: a monotone cubic (Fritsch and Carlson) through its points, straight on "
           "beyond the ends. It replaces the attribute `stiffness`.",
       .attributes = {File("a file with the points, instead of `<point>`: a table with columns deflection and force, "
                           "or an Adams tyre property file (.tir) with the block [DEFLECTION_LOAD_CURVE]"),
                      Scale()}},
      {.path = "fp:tyre/table/point",
       .doc = "A point of the curve, in the order of rising deflection and force.",
       .attributes = {Usual("", "300 mm",
                            Measure("deflection", kLength, Sign::kAny,
                                    "how far foot and centre have come nearer; its zero does not matter")),
                      Usual("", "200 kN", Measure("force", kForce, Sign::kNotNegative, "vertical force"))}},
      {.path = "fp:post",
       .doc =
           "A hydraulic post that drives the platform under a tyre; one a tyre at most. A study moves posts by their "
           "names, or together in heave, pitch, roll or warp, which the places of their tyres in the design pose "
           "tell apart.",
       .attributes = {kNameRule,
                      {.name = "under", .kind = Kind::kTyre, .doc = "tyre that it drives"},
                      {.name = "stroke",
                       .kind = Kind::kScalar,
                       .required = false,
                       .doc = "its whole travel, half of it up and half down from rest; motions that need more are "
                              "refused",
                       .dimension = kLength,
                       .sign = Sign::kPositive,
                       .usual_least = "20 mm",
                       .usual_greatest = "600 mm"}}},
  };
}

std::vector<TagRule> MakeLoopTags() {
  const std::vector<AttributeRule> ends = {kNameRule, kParentRule, kChildRule};
  return {
      {.path = "fp:rod", .doc = "Keeps two points at their distance in the design pose.", .attributes = ends},
      {.path = "fp:ball", .doc = "Keeps two points together.", .attributes = ends},
      {.path = "fp:weld",
       .doc = "Keeps two points together and two links from turning against each other.",
       .attributes = ends},
      {.path = "fp:hinge",
       .doc = "Keeps two points together and lets the links turn against each other about one axis only.",
       .attributes = {kNameRule,
                      kParentRule,
                      kChildRule,
                      {.name = "axis", .kind = Kind::kDirection, .doc = "the axis in axes of the parent's link"}}},
  };
}

std::vector<TagRule> MakeSensorTags() {
  return {
      {.path = "fp:sensor",
       .type = "accelerometer",
       .doc = "Specific force at a point along an axis fixed in its link, less that at rest: its acceleration, and the "
              "share of gravity that the axis gains as it tilts. A lateral axis on a body that rolls by phi reads g "
              "sin(phi) besides, which below some hertz is most of it.",
       .attributes = {kNameRule, SensorType("accelerometer"), kLinkRule, kXyzRule, kSensorAxisRule}},
      {.path = "fp:sensor",
       .type = "displacement",
       .doc = "Displacement of a point from the design pose, along an axis fixed in space.",
       .attributes = {kNameRule, SensorType("displacement"), kLinkRule, kXyzRule, kSensorAxisRule}},
      {.path = "fp:sensor",
       .type = "gyro",
       .doc = "Angular velocity of a link about an axis fixed in it, in rad/s.",
       .attributes = {kNameRule,
                      SensorType("gyro"),
                      kLinkRule,
                      {.name = "axis", .kind = Kind::kDirection, .doc = "the axis in link axes"}}},
      {.path = "fp:sensor",
       .type = "strut",
       .doc = "Extension of the distance between two points from the design pose.",
       .attributes = {kNameRule, SensorType("strut"), kParentRule, kChildRule, kGuideRule}},
      {.path = "fp:sensor",
       .type = "load_cell",
       .doc = "Change of the force on the load cell under a tyre from its static value, more load positive: the "
              "tyre's force, and what it takes to accelerate the wheelpan with the post.",
       .attributes = {kNameRule,
                      SensorType("load_cell"),
                      {.name = "tyre", .kind = Kind::kTyre, .doc = "tyre whose force is measured"},
                      Usual(
                          "10 g", "1 t",
                          Measure("wheelpan", kMass, Sign::kNotNegative, "mass between load cell and tyre", "0 kg"))}},
  };
}

std::vector<TagRule> MakeOwnTags() {
  std::vector<TagRule> tags;
  for (auto* make : {MakeParameterTags, MakeSolidTags, MakeSpringTags, MakeDamperTags, MakeBushingTags, MakeTyreTags,
                     MakeLoopTags, MakeSensorTags, MakeMirrorTags})
    for (TagRule& tag : make()) tags.push_back(std::move(tag));
  return tags;
}

void AddWhere(std::span<const TagRule> tags, bool (*matches)(std::string_view, std::string_view), std::string_view path,
              std::vector<const TagRule*>& found) {
  for (const TagRule& tag : tags)
    if (matches(tag.path, path)) found.push_back(&tag);
}

std::vector<const TagRule*> Collect(bool (*matches)(std::string_view, std::string_view), std::string_view path) {
  std::vector<const TagRule*> found;
  AddWhere(OwnTags(), matches, path, found);
  AddWhere(UrdfTags(), matches, path, found);
  return found;
}

bool IsBelow(std::string_view tag, std::string_view parent) {
  const std::size_t slash = tag.rfind('/');
  return (slash == std::string_view::npos ? std::string_view() : tag.substr(0, slash)) == parent;
}

}  // namespace

std::string_view TagRule::Name() const { return path.substr(path.rfind('/') + 1); }

std::span<const TagRule> OwnTags() {
  static const std::vector<TagRule> tags = MakeOwnTags();
  return tags;
}

std::vector<const TagRule*> FindTags(std::string_view path) {
  return Collect([](std::string_view tag, std::string_view wanted) { return tag == wanted; }, path);
}

std::vector<const TagRule*> TagsBelow(std::string_view path) { return Collect(IsBelow, path); }

const AttributeRule* FindAttribute(const TagRule& tag, std::string_view name) {
  const auto found = std::find_if(tag.attributes.begin(), tag.attributes.end(), [&](const AttributeRule& attribute) {
    return attribute.name == name || (!name.empty() && attribute.former == name);
  });
  return found == tag.attributes.end() ? nullptr : &*found;
}

}  // namespace fourpost
