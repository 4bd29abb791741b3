#include "vehicles/posts/recorded_posts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "analysis/files/recorded_table.h"
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

/// Weights of `count` values at 0, 1, ... in the polynomial through them, at `place`.
std::vector<double> PolynomialWeights(std::size_t count, double place) {
  std::vector<double> weights(count, 1);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < count; ++k)
      if (k != i) weights[i] *= (place - static_cast<double>(k)) / (static_cast<double>(i) - static_cast<double>(k));
  return weights;
}

/// With one more value halfway between each two, of the polynomial through the 16 values about it, or as many as there
/// are on both sides, four at least.
std::vector<double> Refined(const std::vector<double>& values) {
  constexpr std::size_t kSide = 8;
  std::vector<std::vector<double>> weights(kSide + 1);
  for (std::size_t side = 2; side <= kSide; ++side)
    weights[side] = PolynomialWeights(2 * side, static_cast<double>(side) - 0.5);
  std::vector<double> refined;
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    refined.push_back(values[k]);
    const std::size_t side = std::min({kSide, k + 1, values.size() - 1 - k});
    const std::size_t first = side >= 2 ? k + 1 - side : std::min(k, values.size() - 4);
    const std::vector<double> at_end =
        side >= 2 ? std::vector<double>() : PolynomialWeights(4, static_cast<double>(k - first) + 0.5);
    const std::vector<double>& by = side >= 2 ? weights[side] : at_end;
    refined.push_back(
        std::inner_product(by.begin(), by.end(), values.begin() + static_cast<std::ptrdiff_t>(first), 0.0));
  }
  refined.push_back(values.back());
  return refined;
}

/// Lead-in and record as one spline: from rest by the polynomial of least order that meets height and velocity with no
/// acceleration at both ends.
UniformSpline WithLead(const std::vector<double>& heights, double slope, double start, double step, std::size_t lead,
                       const LowPassDesign* filter) {
  const double duration = step * static_cast<double>(lead);
  std::vector<double> all;
  for (std::size_t k = 0; k < lead; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(lead);
    const double cube = u * u * u;
    all.push_back(heights[0] * cube * (10 - 15 * u + 6 * u * u) + slope * duration * cube * (-4 + 7 * u - 3 * u * u));
  }
  all.insert(all.end(), heights.begin(), heights.end());
  if (filter) all = TakenBack(all, step, *filter);
  // A cubic spline alone is off by (w h)^2 / 12 of an acceleration: 7 % at 30 Hz sampled at 200 Hz, then 0.05 %.
  constexpr double kFine_s = 0.4e-3;
  double finer = step;
  for (; finer > kFine_s && all.size() >= 4; finer /= 2) all = Refined(all);
  const std::vector<double> backward(all.rbegin(), all.rend());
  return {start - duration, finer, std::move(all), 0, -SlopeAtStart(backward, finer)};
}

}  // namespace

RecordedPosts FollowHeights(const std::vector<std::vector<double>>& heights, double start_s, double step_s,
                            const LowPassDesign* filter, const std::vector<std::vector<double>>& tensions) {
  const auto lead = static_cast<std::size_t>(std::ceil(kLead_s / step_s));
  std::vector<DelayedTrack> tracks;
  for (const std::vector<double>& post : heights)
    tracks.push_back({WithLead(post, SlopeAtStart(post, step_s), start_s, step_s, lead, filter), 0});
  for (const std::vector<double>& tension : tensions)
    tracks.push_back({WithLead(tension, 0, start_s, step_s, lead, filter), 0});
  const std::size_t samples = heights.empty() ? tensions.at(0).size() : heights[0].size();
  const std::size_t count = tracks.size();
  return {
      FollowTracks(std::move(tracks)),   count, start_s, start_s + step_s * static_cast<double>(samples - 1), step_s,
      step_s * static_cast<double>(lead)};
}

std::optional<RecordedPosts> ReadRecordedPosts(const std::filesystem::path& file, const Vehicle& vehicle,
                                               Diagnostics& diagnostics) {
  std::vector<RecordedChannel> wanted;
  for (const Post& post : vehicle.posts)
    wanted.push_back({{post.name, "post_" + post.name}, kLength, "the height of a post"});
  // A recording of posts alone leaves actuators without force.
  Diagnostics of_table;
  const std::optional<RecordedTable> table = ReadRecordedTable(file, of_table);
  for (const Actuator& actuator : vehicle.actuators)
    if (table && table->FindColumn(actuator.name))
      wanted.push_back({{actuator.name}, kForce, "the tension of an actuator"});
  const std::optional<TimeRecording> recording = ReadTimeRecording(file, wanted, diagnostics);
  if (!recording) return std::nullopt;
  // In the order of the vehicle's.
  const std::vector<std::vector<double>> heights(recording->channels.begin(),
                                                 recording->channels.begin() + std::ssize(vehicle.posts));
  std::vector<std::vector<double>> tensions;
  std::size_t next = vehicle.posts.size();
  for (const Actuator& actuator : vehicle.actuators)
    tensions.push_back(table && table->FindColumn(actuator.name) ? recording->channels[next++]
                                                                 : std::vector<double>(recording->samples()));
  return FollowHeights(heights, recording->start_s, recording->step_s, nullptr, tensions);
}

}  // namespace fourpost
