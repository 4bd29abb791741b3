#include <fourpost/simulate.h>

#include <algorithm>
#include <cmath>

#include "analysis/text/number.h"
#include "identify/api/engine_names.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/api/inside.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/posts/recorded_posts.h"
#include "vehicles/response/post_stroke.h"

namespace fourpost::api {
namespace {

void RequireStrokes(const fourpost::Vehicle& vehicle, const std::vector<std::vector<double>>& heights,
                    double stroke_m) {
  std::vector<double> farthest;
  for (const std::vector<double>& height : heights)
    farthest.push_back(std::abs(
        *std::max_element(height.begin(), height.end(), [](double a, double b) { return std::abs(a) < std::abs(b); })));
  Diagnostics found;
  CheckStroke(vehicle, farthest, "this motion", found, stroke_m);
  if (found.HasErrors()) throw FaultyInput(found);
}

/// One vector per post of the vehicle.
std::vector<std::vector<double>> HeightsOf(const Vehicle& vehicle, const PostHeights& posts) {
  const std::vector<std::string> names = vehicle.posts();
  const Eigen::Index samples = posts.height_m.empty() ? 0 : posts.height_m.begin()->second.size();
  std::vector<std::vector<double>> heights(names.size(), std::vector<double>(static_cast<std::size_t>(samples), 0.0));
  for (const auto& [name, values] : posts.height_m) {
    const auto post = std::find(names.begin(), names.end(), name);
    if (post == names.end()) RefuseName("post", name, names);
    if (values.size() != samples)
      Refuse(kArraysUnequal, {}, {"post '" + name + "'", std::to_string(values.size()), std::to_string(samples)});
    std::vector<double>& of_post = heights[static_cast<std::size_t>(post - names.begin())];
    of_post.assign(values.begin(), values.end());
    RequireFinite("post '" + name + "'", of_post);
  }
  // As many as the slopes at both ends are made of.
  if (samples < 4) Refuse(kArraysUnequal, {}, {"a post", std::to_string(samples), "4 or more"});
  RequireStrokes(Inside::Of(vehicle), heights, posts.stroke_m);
  return heights;
}

}  // namespace

History Simulate(const Vehicle& vehicle, const PostHeights& posts, Engine engine, const std::function<bool()>& stop) {
  return Guarded([&] {
    if (!(posts.rate_Hz > 0)) Refuse(kRateNotPositive, {}, {FormatNumber(posts.rate_Hz)});
    if (engine == Engine::kTimeIntegration) Refuse(kEngineOfSines, {});
    const RecordedPosts motion = FollowHeights(HeightsOf(vehicle, posts), 0, 1 / posts.rate_Hz);
    HistorySolver solver(Inside::Of(vehicle));
    const TimeGrid grid{
        .start_s = motion.start_s, .end_s = motion.end_s, .rate_Hz = posts.rate_Hz, .lead_s = motion.lead_s};
    const auto goes_on = [&](const char*, double) { return !stop || !stop(); };
    SolvedHistory solved = solver.Solve(motion.motion, grid, {.engine = OwnEngine(engine)}, goes_on);
    if (solved.history.size() <= grid.lead_count()) throw SimulationError(kCallStopped);
    solved.history.DropFirst(grid.lead_count());
    History history{
        .rate_Hz = posts.rate_Hz, .engine = PublicEngine(solved.by.engine), .step_change = solved.by.change};
    if (solved.by.kinematics_error) history.kinematics_error = solved.by.kinematics_error->share;
    const std::vector<Sensor> sensors = vehicle.sensors();
    for (std::size_t i = 0; i < sensors.size(); ++i)
      history.readings[sensors[i].name] = solved.history.readings.col(static_cast<Eigen::Index>(i));
    return history;
  });
}

}  // namespace fourpost::api
