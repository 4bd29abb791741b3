#pragma once

#include <string>

#include "tests/vehicles/poses/axle_cars.h"

// A double wishbone whose upper ball is a bush, drawn anywhere.
namespace fourpost::axle_cars {

struct RubberPoints {
  Vec upper_ball = kUpper.ball;
  Vec tie_outer = kTrackRod.outer;
  /// Radial rate of the bush, as written.
  std::string rate = "2 kN/mm";
  /// Attributes of the frames of ball and track rod, such as shifts.
  std::string of_ball = {};
  std::string of_tie = {};
  /// Further tags.
  std::string tags = {};
};

inline std::string FrameWith(const std::string& name, const std::string& link, const Vec& xyz,
                             const std::string& attributes) {
  return "<fp:frame name=\"" + name + "\" link=\"" + link + "\" xyz=\"" + Text(xyz) + "\" " + attributes + "/>\n";
}

inline std::string WishboneOnRubber(const RubberPoints& points = {}) {
  return Car(Body("upright_left", 8) + Floating("upright_left") + Arm("lower", kLower, "upright_left") +
             Body("upper_left", 3) + Turning("upper_left", kUpper.front, kUpper.rear) +
             FrameWith("upper_end_left", "upper_left", points.upper_ball - kUpper.front, points.of_ball) +
             FrameWith("upper_pin_left", "upright_left", points.upper_ball, points.of_ball) +
             "<fp:bushing name=\"upper_left\" parent=\"upper_end_left\" child=\"upper_pin_left\" "
             "preload=\"equilibrium\"><translation x=\"" +
             points.rate + "\" y=\"" + points.rate + "\" z=\"20 kN/mm\"/></fp:bushing>\n" +
             Frame("in_track_rod_left", "body", kTrackRod.inner) +
             FrameWith("out_track_rod_left", "upright_left", points.tie_outer, points.of_tie) +
             Join("rod", "track_rod_left", "in_track_rod_left", "out_track_rod_left") +
             Coil("coil_left", "lower_left", kWishboneCoil.inner, kWishboneCoil.outer - kLower.front) +
             Hub("upright_left", Vec::Zero()) + points.tags);
}

}  // namespace fourpost::axle_cars
