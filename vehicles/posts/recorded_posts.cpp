#include "vehicles/posts/recorded_posts.h"

#include <cmath>
#include <utility>
#include <vector>

#include "analysis/time_recording.h"
#include "analysis/uniform_spline.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost {
namespace {

/// Long against a car's body modes.
constexpr double kLead_s = 2;

/// Lead-in and record as one spline: from rest by the polynomial of least order that meets height and velocity with no
/// acceleration at both ends.
UniformSpline WithLead(const std::vector<double>& heights, double start, double step, std::size_t lead) {
  const std::vector<double> backward(heights.rbegin(), heights.rend());
  const double slope = SlopeAtStart(heights, step);
  const double duration = step * static_cast<double>(lead);
  std::vector<double> all;
  for (std::size_t k = 0; k < lead; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(lead);
    const double cube = u * u * u;
    all.push_back(heights[0] * cube * (10 - 15 * u + 6 * u * u) + slope * duration * cube * (-4 + 7 * u - 3 * u * u));
  }
  all.insert(all.end(), heights.begin(), heights.end());
  return {start - duration, step, std::move(all), 0, -SlopeAtStart(backward, step)};
}

}  // namespace

std::optional<RecordedPosts> ReadRecordedPosts(const std::filesystem::path& file, const Vehicle& vehicle,
                                               Diagnostics& diagnostics) {
  std::vector<RecordedChannel> wanted;
  for (const Post& post : vehicle.posts)
    wanted.push_back({{post.name, "post_" + post.name}, kLength, "the height of a post"});
  const std::optional<TimeRecording> recording = ReadTimeRecording(file, wanted, diagnostics);
  if (!recording) return std::nullopt;
  const double step = recording->step_s;
  const auto lead = static_cast<std::size_t>(std::ceil(kLead_s / step));
  std::vector<DelayedTrack> tracks;
  for (const std::vector<double>& post : recording->channels)
    tracks.push_back({WithLead(post, recording->start_s, step, lead), 0});
  return RecordedPosts{FollowTracks(std::move(tracks)), recording->start_s, recording->end_s, step,
                       step * static_cast<double>(lead)};
}

}  // namespace fourpost
