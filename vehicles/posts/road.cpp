#include "vehicles/posts/road.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/signals/random_stream.h"
#include "analysis/text/option_check.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/posts/band_noise.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost {
namespace {

using std::numbers::pi;

constexpr double kReference_cpm = 0.1;
/// Cars are measured to about a millimetre.
constexpr double kInLine_m = 1e-3;

std::vector<Eigen::Vector3d> Places(const Vehicle& vehicle) {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  std::vector<Eigen::Vector3d> places;
  for (const Post& post : vehicle.posts)
    places.push_back(PlaceOf(vehicle.tyres[static_cast<std::size_t>(post.tyre)].point, poses));
  return places;
}

double Coherence(double spatial_frequency, double distance) {
  const double x = 2 * pi * spatial_frequency * distance;
  // K1 runs below all doubles at some 700.
  return x > 500 ? 0 : x * std::cyl_bessel_k(1, x);
}

struct Tracks {
  std::vector<double> left;
  std::vector<double> right;
};

/// Both are made of the same two random signals a and b: left = c a + s b, right = c a - s b, c^2 - s^2 the coherence.
Tracks MakeTracks(const RandomRoad& road, double distance, const SineGrid& grid) {
  const auto phasors = [&](const char* purpose, double share_of_rest) {
    RandomStream draws(road.seed, purpose);
    return SumOfSines(grid, road.lower_Hz, road.upper_Hz, [&, draws, share_of_rest](double frequency) mutable {
      const double n = frequency / road.speed;
      const double density = road.roughness_m3 * kReference_cpm * kReference_cpm / (n * n) / road.speed;  // m^2/Hz
      const double coherence = distance > 0 ? Coherence(n, distance) : 1;
      const double share = 0.5 * (1 + share_of_rest * coherence);
      return std::polar(std::sqrt(2 * density * grid.spacing_Hz() * std::max(0.0, share)), 2 * pi * draws.Uniform());
    });
  };
  Tracks tracks;
  tracks.left = phasors("road alike", 1);
  tracks.right = tracks.left;
  const std::vector<double> apart = phasors("road apart", -1);
  for (std::size_t k = 0; k < apart.size(); ++k) {
    tracks.left[k] += apart[k];
    tracks.right[k] -= apart[k];
  }
  return tracks;
}

std::vector<double> Mean(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> mean(a.size());
  std::transform(a.begin(), a.end(), b.begin(), mean.begin(), [](double x, double y) { return 0.5 * (x + y); });
  return mean;
}

}  // namespace

std::optional<double> RoadRoughness(std::string_view road_class) {
  const auto found = std::find(kRoadClasses.begin(), kRoadClasses.end(), road_class);
  if (found == kRoadClasses.end()) return std::nullopt;
  return 16e-6 * std::pow(4.0, found - kRoadClasses.begin());
}

PostMotion RandomRoad::MotionOf(const Vehicle& vehicle) const {
  RequirePositive("RandomRoad: roughness_m3", roughness_m3);
  RequirePositive("RandomRoad: speed", speed);
  RequirePositive("RandomRoad: lower_Hz", lower_Hz);
  RequirePositive("RandomRoad: duration_s", duration_s);
  RequireOption(upper_Hz > lower_Hz && std::isfinite(upper_Hz), "RandomRoad: upper_Hz", upper_Hz,
                "above lower_Hz and finite");
  const std::vector<Eigen::Vector3d> places = Places(vehicle);
  double foremost = -HUGE_VAL;
  double leftmost = -HUGE_VAL;
  double rightmost = HUGE_VAL;
  for (const Eigen::Vector3d& place : places) {
    foremost = std::max(foremost, place.x());
    leftmost = std::max(leftmost, place.y());
    rightmost = std::min(rightmost, place.y());
  }
  const double distance = places.empty() || leftmost - rightmost <= kInLine_m ? 0 : leftmost - rightmost;
  const SineGrid grid = SineGrid::For(upper_Hz, duration_s);
  const Tracks tracks = MakeTracks(*this, distance, grid);
  const bool is_flat = std::all_of(tracks.left.begin(), tracks.left.end(), [](double z) { return z == 0; });
  RequireOption(!is_flat, "RandomRoad: duration_s", duration_s, "long enough for a frequency within the band");
  const auto signal = [&](const std::vector<double>& heights) {
    return UniformSpline(0, grid.step_s, Faded(heights, grid.step_s, duration_s));
  };
  std::vector<DelayedTrack> followed;
  for (const Eigen::Vector3d& place : places) {
    const double aside = place.y() - 0.5 * (leftmost + rightmost);
    const bool between = distance > 0 && std::abs(aside) <= kInLine_m / 2;
    const std::vector<double> heights =
        between ? Mean(tracks.left, tracks.right) : (distance == 0 || aside > 0 ? tracks.left : tracks.right);
    followed.push_back({signal(heights), (foremost - place.x()) / speed});
  }
  return FollowTracks(std::move(followed));
}

}  // namespace fourpost
