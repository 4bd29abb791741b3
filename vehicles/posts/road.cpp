#include "vehicles/posts/road.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/signals/random_stream.h"
#include "analysis/text/option_check.h"
#include "vehicles/posts/band_noise.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost {
namespace {

using std::numbers::pi;

struct Tracks {
  std::vector<double> left;
  std::vector<double> right;
};

/// Both are made of the same two random signals a and b: left = c a + s b, right = c a - s b, c^2 - s^2 the coherence.
Tracks MakeTracks(const RandomRoad& road, double distance, const SineGrid& grid) {
  const auto phasors = [&](const char* purpose, double share_of_rest) {
    RandomStream draws(road.seed, purpose);
    return SumOfSines(grid, road.lower_Hz, road.upper_Hz, [&, draws, share_of_rest](double frequency) mutable {
      const double density = RoadDensity(road.roughness_m3, road.speed, frequency);
      const double coherence = TrackCoherence(frequency / road.speed, distance);
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

PostMotion RandomRoad::MotionOf(const Vehicle& vehicle) const {
  RequirePositive("RandomRoad: roughness_m3", roughness_m3);
  RequirePositive("RandomRoad: speed", speed);
  RequirePositive("RandomRoad: lower_Hz", lower_Hz);
  RequirePositive("RandomRoad: duration_s", duration_s);
  RequireOption(upper_Hz > lower_Hz && std::isfinite(upper_Hz), "RandomRoad: upper_Hz", upper_Hz,
                "above lower_Hz and finite");
  const RoadTracks layout = RoadTracksOf(vehicle);
  const SineGrid grid = SineGrid::For(upper_Hz, duration_s);
  const Tracks tracks = MakeTracks(*this, layout.distance, grid);
  const bool is_flat = std::all_of(tracks.left.begin(), tracks.left.end(), [](double z) { return z == 0; });
  RequireOption(!is_flat, "RandomRoad: duration_s", duration_s, "long enough for a frequency within the band");
  const auto signal = [&](const std::vector<double>& heights) {
    return UniformSpline(0, grid.step_s, Faded(heights, grid.step_s, duration_s));
  };
  std::vector<DelayedTrack> followed;
  for (const RoadTracks::Place& place : layout.posts)
    followed.push_back({signal(place.side > 0   ? tracks.left
                               : place.side < 0 ? tracks.right
                                                : Mean(tracks.left, tracks.right)),
                        place.behind / speed});
  return FollowTracks(std::move(followed));
}

}  // namespace fourpost
