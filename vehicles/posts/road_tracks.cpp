#include "vehicles/posts/road_tracks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/numerics/bessel.h"
#include "vehicles/description/design_poses.h"

namespace fourpost {
namespace {

constexpr double kReference_cpm = 0.1;
/// Cars are measured to about a millimetre.
constexpr double kInLine_m = 1e-3;

}  // namespace

std::optional<double> RoadRoughness(std::string_view road_class) {
  const auto found = std::find(kRoadClasses.begin(), kRoadClasses.end(), road_class);
  if (found == kRoadClasses.end()) return std::nullopt;
  return 16e-6 * std::pow(4.0, found - kRoadClasses.begin());
}

double RoadDensity(double roughness_m3, double speed, double frequency_Hz) {
  const double n = frequency_Hz / speed;
  return roughness_m3 * kReference_cpm * kReference_cpm / (n * n) / speed;
}

double TrackCoherence(double spatial_frequency, double distance) {
  const double x = 2 * std::numbers::pi * spatial_frequency * distance;
  // K1 runs below all doubles at some 700.
  if (x > 500) return 0;
  return x > 0 ? x * BesselK1(x) : 1;
}

double RoadTracks::length() const {
  double length = 0;
  for (const Place& place : posts) length = std::max(length, place.behind);
  return length;
}

RoadTracks RoadTracksOf(const Vehicle& vehicle) {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  std::vector<Eigen::Vector3d> places;
  double foremost = -HUGE_VAL;
  double leftmost = -HUGE_VAL;
  double rightmost = HUGE_VAL;
  for (const Post& post : vehicle.posts) {
    const Eigen::Vector3d place = PlaceOf(vehicle.tyres[static_cast<std::size_t>(post.tyre)].point, poses);
    foremost = std::max(foremost, place.x());
    leftmost = std::max(leftmost, place.y());
    rightmost = std::min(rightmost, place.y());
    places.push_back(place);
  }
  RoadTracks tracks;
  if (!places.empty() && leftmost - rightmost > kInLine_m) tracks.distance = leftmost - rightmost;
  for (const Eigen::Vector3d& place : places) {
    const double aside = place.y() - 0.5 * (leftmost + rightmost);
    const bool between = tracks.distance > 0 && std::abs(aside) <= kInLine_m / 2;
    tracks.posts.push_back(
        {.side = between ? 0 : (tracks.distance == 0 || aside > 0 ? 1 : -1), .behind = foremost - place.x()});
  }
  return tracks;
}

}  // namespace fourpost
