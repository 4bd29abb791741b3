#pragma once

#include <Eigen/Core>

#include "vehicles/posts/road_tracks.h"
#include "vehicles/random_response/spectral_grid.h"

namespace fourpost {

/// Random heights of posts in frequency, as sums over independent sources: the spectral matrix of the posts, one-sided,
/// is S(f) = H(f) H(f)^H, with H posts x sources.
struct PostSpectra {
  Eigen::Index sources = 1;
  /// Posts x (frequencies sources), sources of a frequency side by side [m/sqrt(Hz)].
  Eigen::MatrixXcd heights;

  auto At(Eigen::Index frequency) const { return heights.middleCols(frequency * sources, sources); }
};

/// Of a random road at a constant speed, see RandomRoad. Both tracks are made of two sources a and b,
///   left = c a + s b,  right = c a - s b,  c^2 + s^2 = 1,  c^2 - s^2 = TrackCoherence,
/// and each post follows its track after its distance from the foremost post over speed. Throws std::invalid_argument
/// for a roughness or speed that is not positive.
PostSpectra RoadSpectra(const RoadTracks& tracks, double roughness_m3, double speed, const SpectralGrid& grid);

}  // namespace fourpost
