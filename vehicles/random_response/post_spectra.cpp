#include "vehicles/random_response/post_spectra.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "analysis/text/option_check.h"

namespace fourpost {

PostSpectra RoadSpectra(const RoadTracks& tracks, double roughness_m3, double speed, const SpectralGrid& grid) {
  RequirePositive("RoadSpectra: roughness_m3", roughness_m3);
  RequirePositive("RoadSpectra: speed", speed);
  PostSpectra spectra{.sources = tracks.distance > 0 ? 2 : 1, .heights = {}};
  const auto posts = static_cast<Eigen::Index>(tracks.posts.size());
  const auto frequencies = static_cast<Eigen::Index>(grid.size());
  spectra.heights.setZero(posts, frequencies * spectra.sources);
  for (Eigen::Index k = 0; k < frequencies; ++k) {
    const double f = grid.frequency_Hz[static_cast<std::size_t>(k)];
    const double amplitude = std::sqrt(RoadDensity(roughness_m3, speed, f));
    const double coherence = TrackCoherence(f / speed, tracks.distance);
    const double alike = amplitude * std::sqrt(0.5 * (1 + coherence));
    const double apart = amplitude * std::sqrt(std::max(0.0, 0.5 * (1 - coherence)));
    for (Eigen::Index i = 0; i < posts; ++i) {
      const RoadTracks::Place& place = tracks.posts[static_cast<std::size_t>(i)];
      const std::complex<double> delay = std::polar(1.0, -2 * std::numbers::pi * f * place.behind / speed);
      spectra.heights(i, k * spectra.sources) = alike * delay;
      if (spectra.sources > 1) spectra.heights(i, k * spectra.sources + 1) = apart * place.side * delay;
    }
  }
  return spectra;
}

}  // namespace fourpost
