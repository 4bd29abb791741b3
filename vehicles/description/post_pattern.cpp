#include "vehicles/description/post_pattern.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/text/nearest.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/description/findings.h"

namespace fourpost {
namespace {

/// One horizontal direction, and what its two ends are called.
struct Direction {
  Eigen::Index axis = 0;
  std::string_view ahead;
  std::string_view behind;
};

constexpr Direction kForward = {.axis = 0, .ahead = "front", .behind = "rear"};
constexpr Direction kLeft = {.axis = 1, .ahead = "left", .behind = "right"};

std::vector<double> PlacesAlong(const Vehicle& vehicle, Eigen::Index axis) {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  std::vector<double> places;
  for (const Post& post : vehicle.posts)
    places.push_back(PlaceOf(vehicle.tyres[static_cast<std::size_t>(post.tyre)].point, poses)[axis]);
  return places;
}

/// 1 for each post ahead of the middle, -1 for each behind it.
std::vector<double> Sides(const Vehicle& vehicle, std::string_view pattern, const Direction& direction) {
  // Cars are measured to about a millimetre.
  constexpr double kInLine_m = 1e-3;
  const std::vector<double> places = PlacesAlong(vehicle, direction.axis);
  const auto [least, greatest] = std::minmax_element(places.begin(), places.end());
  if (places.empty() || *greatest - *least <= kInLine_m)
    throw PatternError(
        {&kPatternSides, {std::string(pattern), std::string(direction.ahead), std::string(direction.behind)}});
  const double middle = (*least + *greatest) / 2;
  std::vector<double> sides;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::abs(places[i] - middle) <= kInLine_m / 2)
      throw PatternError(
          {&kPatternMiddle,
           {std::string(pattern), vehicle.posts[i].name, std::string(direction.ahead), std::string(direction.behind)}});
    sides.push_back(places[i] > middle ? 1 : -1);
  }
  return sides;
}

/// Three posts tilt a plane, which is no warp.
void RequireCorners(const std::vector<double>& front, const std::vector<double>& left) {
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0}) {
      bool found = false;
      for (std::size_t i = 0; i < front.size(); ++i) found = found || (front[i] == x && left[i] == y);
      if (!found)
        throw PatternError({&kPatternCorner,
                            {"warp", std::string(x > 0 ? kForward.ahead : kForward.behind),
                             std::string(y > 0 ? kLeft.ahead : kLeft.behind)}});
    }
}

std::vector<double> Warp(const Vehicle& vehicle) {
  const std::vector<double> front = Sides(vehicle, "warp", kForward);
  const std::vector<double> left = Sides(vehicle, "warp", kLeft);
  RequireCorners(front, left);
  std::vector<double> shape;
  for (std::size_t i = 0; i < front.size(); ++i) shape.push_back(front[i] * left[i]);
  return shape;
}

}  // namespace

std::string_view PatternName(std::string_view name) { return name == "bounce" ? kPostPatterns.front() : name; }

std::vector<double> PostPattern(const Vehicle& vehicle, std::string_view name) {
  name = PatternName(name);
  if (name == "heave") return std::vector<double>(vehicle.posts.size(), 1.0);
  if (name == "pitch") return Sides(vehicle, name, kForward);
  if (name == "roll") return Sides(vehicle, name, kLeft);
  if (name == "warp") return Warp(vehicle);
  throw PatternError({&kPatternUnknown, {std::string(name), DidYouMean(name, kPostPatternNames)}});
}

}  // namespace fourpost
