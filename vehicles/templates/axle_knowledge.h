#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/templates/parameter_text.h"

namespace fourpost {

/// A rigid body in the drawing's axes.
struct KnownBody {
  double mass = 0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// About the centre of mass.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();

  /// The two as one body.
  KnownBody operator+(const KnownBody& other) const;
  /// What a hole in it leaves; nothing where that has no mass.
  KnownBody operator-(const KnownBody& hole) const;
  /// On the other side of the car.
  KnownBody Mirrored() const;
  /// With moments of inertia that a body can have: none below zero, the largest at most the sum of the others.
  KnownBody Possible() const;
};

/// A law of a spring, damper or stop as tags, with the parameters that they name.
struct KnownLaw {
  /// With preloads left to equilibrium.
  std::string tags;
  /// Of a spring: the same with the load that the model gives it in the drawing; else empty.
  std::string loaded = {};
  std::vector<ParameterText> parameters = {};
};

/// What a model of a car says of one axle beside its points. Estimates stand for all that it leaves out.
struct KnownAxle {
  /// By short names of parts: "lower_arm", "knuckle"; "wheel" with hub and tyre, "axle" with both wheels.
  std::map<std::string, KnownBody, std::less<>> bodies;
  std::optional<KnownLaw> spring;
  std::optional<KnownLaw> damper;
  /// At the spring's ends.
  std::optional<KnownLaw> stops;
  std::optional<ParameterText> tyre_rate;
  std::optional<double> tyre_damping;
  std::optional<ParameterText> bar_rate;
  /// Where its numbers are from, in words for parameters' sources.
  std::string source;
};

/// What a model says of a car.
struct KnownCar {
  std::optional<KnownBody> body;
  std::array<KnownAxle, 2> axles;
  /// What the file is of: "a model of Project Chrono"; and what its numbers are from.
  std::string model;
  std::string source;
};

}  // namespace fourpost
