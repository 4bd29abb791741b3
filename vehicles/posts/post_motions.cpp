#include "vehicles/posts/post_motions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace fourpost {

// Shared, for copies of a std::function copy what it holds.

PostMotion FollowPattern(UniformSpline signal, std::vector<double> shape) {
  const auto shared = std::make_shared<const UniformSpline>(std::move(signal));
  return [shared, shape = std::move(shape)](double t, std::span<PostState> posts) {
    const UniformSpline::Point now = shared->At(t);
    for (std::size_t p = 0; p < posts.size(); ++p)
      posts[p] = p < shape.size() ? PostState{shape[p] * now.value, shape[p] * now.slope, shape[p] * now.curvature}
                                  : PostState();
  };
}

PostMotion FollowTracks(std::vector<DelayedTrack> tracks) {
  const auto shared = std::make_shared<const std::vector<DelayedTrack>>(std::move(tracks));
  return [shared](double t, std::span<PostState> posts) {
    std::fill(posts.begin(), posts.end(), PostState());
    for (std::size_t p = 0; p < std::min(posts.size(), shared->size()); ++p) {
      const UniformSpline::Point now = (*shared)[p].signal.At(t - (*shared)[p].delay_s);
      posts[p] = {now.value, now.slope, now.curvature};
    }
  };
}

std::vector<double> FarthestHeights(const PostMotion& motion, std::size_t post_count, double start, double end,
                                    double step) {
  std::vector<double> farthest(post_count);
  std::vector<PostState> posts(post_count);
  for (long k = 0; start + step * static_cast<double>(k) <= end; ++k) {
    motion(start + step * static_cast<double>(k), posts);
    for (std::size_t p = 0; p < post_count; ++p)
      if (std::abs(posts[p].height) > std::abs(farthest[p])) farthest[p] = posts[p].height;
  }
  return farthest;
}

}  // namespace fourpost
