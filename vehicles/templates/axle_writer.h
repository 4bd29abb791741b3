#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "vehicles/templates/axle_guess.h"
#include "vehicles/templates/axle_points.h"
#include "vehicles/templates/parameter_text.h"

namespace fourpost {

/// "0.15 -0.36 0.22", to a nanometre.
std::string XyzText(const Eigen::Vector3d& xyz);

/// Writes the links, joints and tags of one axle. Parts and points have short names, such as "lower_arm" and
/// "lower_ball"; in the file they stand as "front_lower_arm_left". All parts but arms have the axes and origin of the
/// body, which are those of the drawing, so that points stand as listed; an arm's origin lies on its axis.
class AxleWriter {
 public:
  /// `height`: of the wheel's centre above the ground [m].
  AxleWriter(const AxlePoints& points, const AxleGuess& guess, double height)
      : points_(points), guess_(guess), height_(height) {}

  const AxlePoints& points() const { return points_; }
  const AxleGuess& guess() const { return guess_; }
  const std::string& text() const { return text_; }

  /// "front_lower_arm_left"; parts of both sides, such as an axle, have no side.
  std::string Name(std::string_view part, bool has_side = true) const;
  void Comment(std::string_view text);
  void Add(const std::string& text) { text_ += text; }
  void Add(const ParameterText& parameter) { text_ += Text(parameter); }

  /// A part with mass spread over these points; none without points.
  void Body(std::string_view part, double mass, const std::vector<Eigen::Vector3d>& places, bool has_side = true);
  /// One without mass, unless its mass is known.
  void Empty(std::string_view part) { Body(part, 0, {}); }
  /// Its six degrees of freedom, axes of the body.
  void Floating(std::string_view part, bool has_side = true);
  /// A joint to `parent`, of which the part's frame is at `origin`, in the drawing's axes.
  void Joint(std::string_view part, std::string_view parent, std::string_view type, const Eigen::Vector3d& origin,
             const Eigen::Vector3d& axis, bool has_side = true);
  /// A part of both sides, its frame at `origin`.
  void Central(std::string_view part, const Eigen::Vector3d& origin) { parts_[std::string(part)] = {origin, false}; }
  /// An arm that turns on the body about the line through two points.
  void Arm(std::string_view part, double mass, const ArmSpec& arm);

  /// A frame of the part at the point; returns its name. A part and a point have one frame.
  std::string Frame(std::string_view part, std::string_view point);
  std::string Frame(std::string_view part, std::string_view name, const Eigen::Vector3d& place, bool has_side);
  void Ball(std::string_view name, std::string_view parent, std::string_view child);
  /// From the body to the part, between its two points.
  void Rod(std::string_view name, std::string_view inner, std::string_view outer, std::string_view part);
  /// The link on bushes that replaces a rod where links alone would lock the axle; it hinges on `part` both ways.
  void LinkOnBush(std::string_view name, std::string_view inner, std::string_view outer, std::string_view part);

  /// Wheel, hub and knuckle, fixed to the part.
  void Wheel(std::string_view carrier);
  /// A beam axle with its wheels, on the body by a joint of six degrees of freedom.
  void BeamAxle();
  /// The same without its joint, with its frame at `origin`, in the drawing's axes.
  void BeamAxleAt(const Eigen::Vector3d& origin);

  /// Coil, damper, stops, anti-roll bar, tyre, post, sensors.
  void Struts();
  /// The same with coil and damper between these points of body and part.
  void StrutOf(std::string_view top, std::string_view bottom, std::string_view part);
  void CoilAndDamper(const std::string& top, const std::string& bottom);
  /// Dry friction alone.
  void Friction(std::string_view name, const std::string& top, const std::string& bottom, const ParameterText& force);
  void Tyre();
  void Sensors();

 private:
  std::string Full(std::string_view part) const;
  bool HasSide(std::string_view part) const;
  std::string CarrierOf(std::string_view point) const;
  std::string EndsOf(std::string_view tag, std::string_view name, const std::string& parent, const std::string& child);
  void Damper(const std::string& top, const std::string& bottom);
  void Stops(const std::string& top, const std::string& bottom);
  void AddRates();
  void AddSpringRate();
  void AddDamperRates();
  /// nullptr where it is not known.
  const KnownBody* KnownPart(std::string_view part) const;
  void AntiRollBar();
  /// Of the wheel's centre above the ground, along the wheel [m].
  double Radius() const;

  AxlePoints points_;
  AxleGuess guess_;
  double height_;
  /// By short name: origin in the drawing's axes, and whether there is one on each side.
  struct Part {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    bool has_side = true;
  };
  std::map<std::string, Part, std::less<>> parts_ = {{"body", {Eigen::Vector3d::Zero(), false}}};
  std::map<std::string, std::string> frames_;
  std::string damper_top_;
  std::string damper_bottom_;
  std::string text_;
};

}  // namespace fourpost
