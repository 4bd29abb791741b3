#include "vehicles/posts/recorded_posts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/files/time_recording.h"
#include "analysis/signals/low_pass.h"
#include "analysis/signals/unfiltered.h"
#include "analysis/signals/uniform_spline.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost {
namespace {

/// Long against a car's body modes.
constexpr double kLead_s = 2;

std::vector<double> TakenBack(const std::vector<double>& heights, double step, const LowPassDesign& filter) {
  return Unfiltered(heights, LowPass(filter.order, filter.cutoff_Hz, 1 / step), filter.cutoff_Hz * step);
}

/// Lead-in and record as one spline: from rest by the polynomial of least order that meets height and velocity with no
/// acceleration at both ends.
UniformSpline WithLead(const std::vector<double>& heights, double start, double step, std::size_t lead,
                       const LowPassDesign* filter) {
  const double slope = SlopeAtStart(heights, step);
  const double duration = step * static_cast<double>(lead);
  std::vector<double> all;
  for (std::size_t k = 0; k < lead; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(lead);
    const double cube = u * u * u;
    all.push_back(heights[0] * cube * (10 - 15 * u + 6 * u * u) + slope * duration * cube * (-4 + 7 * u - 3 * u * u));
  }
  all.insert(all.end(), heights.begin(), heights.end());
  if (filter) all = TakenBack(all, step, *filter);
  const std::vector<double> backward(all.rbegin(), all.rend());
  return {start - duration, step, std::move(all), 0, -SlopeAtStart(backward, step)};
}

}  // namespace

RecordedPosts FollowHeights(const std::vector<std::vector<double>>& heights, double start_s, double step_s,
                            const LowPassDesign* filter) {
  const auto lead = static_cast<std::size_t>(std::ceil(kLead_s / step_s));
  std::vector<DelayedTrack> tracks;
  for (const std::vector<double>& post : heights) tracks.push_back({WithLead(post, start_s, step_s, lead, filter), 0});
  return {FollowTracks(std::move(tracks)),
          heights.size(),
          start_s,
          start_s + step_s * static_cast<double>(heights.at(0).size() - 1),
          step_s,
          step_s * static_cast<double>(lead)};
}

std::optional<RecordedPosts> ReadRecordedPosts(const std::filesystem::path& file, const Vehicle& vehicle,
                                               Diagnostics& diagnostics) {
  std::vector<RecordedChannel> wanted;
  for (const Post& post : vehicle.posts)
    wanted.push_back({{post.name, "post_" + post.name}, kLength, "the height of a post"});
  const std::optional<TimeRecording> recording = ReadTimeRecording(file, wanted, diagnostics);
  if (!recording) return std::nullopt;
  return FollowHeights(recording->channels, recording->start_s, recording->step_s);
}

}  // namespace fourpost
