#include "vehicles/simulation/time_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/text/option_check.h"
#include "vehicles/simulation/condensed_system.h"

namespace fourpost {
namespace {

using Eigen::Index;

Eigen::ArrayXd RootMeanSquares(const Eigen::MatrixXd& columns) {
  return (columns.colwise().squaredNorm().transpose().array() / static_cast<double>(columns.rows())).sqrt();
}

/// Each sensor's size, a tenth of the loudest of its kind at least, and of one unit per metre of the posts' rms: a kind
/// may be silent as a whole, as a roll rate is in heave.
Eigen::ArrayXd Sizes(const Eigen::ArrayXd& size, double post_rms, const std::vector<Sensor>& sensors) {
  constexpr double kFaint = 0.1;
  // Both are lengths.
  const auto kind = [](Sensor::Type type) { return type == Sensor::Type::kStrut ? Sensor::Type::kDisplacement : type; };
  Eigen::ArrayXd sizes = size.max(kFaint * post_rms);
  for (Index i = 0; i < size.size(); ++i)
    for (Index j = 0; j < size.size(); ++j)
      if (kind(sensors[static_cast<std::size_t>(i)].type) == kind(sensors[static_cast<std::size_t>(j)].type))
        sizes[i] = std::max(sizes[i], kFaint * size[j]);
  return sizes;
}

}  // namespace

void TimeGrid::Validate() const {
  RequireOption(std::isfinite(start_s), "TimeGrid: start_s", start_s, "finite");
  RequireOption(end_s > start_s && std::isfinite(end_s), "TimeGrid: end_s", end_s, "later than start_s and finite");
  RequireOption(rate_Hz > 0 && std::isfinite(rate_Hz), "TimeGrid: rate_Hz", rate_Hz, "positive and finite");
  RequireOption(lead_s >= 0 && std::isfinite(lead_s), "TimeGrid: lead_s", lead_s, "finite and not negative");
}

Index TimeGrid::count() const {
  // A duration of whole samples may be rounded to just less.
  return static_cast<Index>(std::floor((end_s - start_s) * rate_Hz * (1 + 1e-12) + 1e-9)) + 1;
}

Index TimeGrid::lead_count() const { return static_cast<Index>(std::ceil(lead_s * rate_Hz * (1 - 1e-12))); }

void TimeHistory::DropFirst(Index count) {
  start_s = TimeAt(count);
  posts = posts.bottomRows(posts.rows() - count).eval();
  readings = readings.bottomRows(readings.rows() - count).eval();
}

TimeHistory Simulate(TimeSystem& system, const PostMotion& posts, const TimeGrid& grid, const GoOn& go_on) {
  grid.Validate();
  const Index lead = grid.lead_count();
  TimeHistory history{.start_s = grid.start_s - static_cast<double>(lead) / grid.rate_Hz, .rate_Hz = grid.rate_Hz};
  const Index count = lead + grid.count();
  history.posts.resize(count, static_cast<Index>(system.rig().post_count));
  history.readings.resize(count, static_cast<Index>(system.rig().sensors.size()));
  std::vector<PostState> now(system.rig().post_count + system.rig().actuator_count);
  Index filled = 0;
  bool ended = false;
  const auto sink = [&](double t, const Eigen::VectorXd& readings) {
    posts(t, now);
    for (std::size_t p = 0; p < system.rig().post_count; ++p)
      history.posts(filled, static_cast<Index>(p)) = now[p].height;
    history.readings.row(filled) = readings.transpose();
    if (go_on && filled % 256 == 0) ended = !go_on(t);
    ++filled;
  };
  system.Run(posts, history.start_s, 1 / grid.rate_Hz, sink, [&] { return ended || filled == count; });
  history.posts.conservativeResize(filled, Eigen::NoChange);
  history.readings.conservativeResize(filled, Eigen::NoChange);
  return history;
}

Eigen::ArrayXd RelativeDifferences(const TimeHistory& history, const TimeHistory& reference,
                                   const std::vector<Sensor>& sensors) {
  const double posts = reference.posts.size() == 0 ? 0 : RootMeanSquares(reference.posts).maxCoeff();
  const Eigen::ArrayXd difference = RootMeanSquares(history.readings - reference.readings);
  const Eigen::ArrayXd size = Sizes(RootMeanSquares(reference.readings), posts, sensors);
  // No difference of nothing.
  return (difference == 0).select(0, difference / size);
}

void CondensedHistoryOptions::Validate() const {
  RequireOption(error > 0, "CondensedHistoryOptions: error", error, "positive");
  RequireOption(longest_step_s > 0 && std::isfinite(longest_step_s), "CondensedHistoryOptions: longest_step_s",
                longest_step_s, "positive and finite");
  RequireOption(most_halvings >= 1, "CondensedHistoryOptions: most_halvings", most_halvings, "at least 1");
}

CondensedHistory SimulateCondensed(const CondensedModel& model, const RigView& rig, const PostMotion& posts,
                                   const TimeGrid& grid, const CondensedHistoryOptions& options, const GoOn& go_on) {
  const auto run = [&](double longest_step, const GoOn& goes_on) {
    CondensedSystem system(model, rig, longest_step);
    system.StartFrom(options.released);
    return Simulate(system, posts, grid, goes_on);
  };
  return SimulateByHalving(run, rig.sensors, grid, options, go_on);
}

CondensedHistory SimulateByHalving(const HistoryRun& run, const std::vector<Sensor>& sensors, const TimeGrid& grid,
                                   const CondensedHistoryOptions& options, const GoOn& go_on) {
  options.Validate();
  grid.Validate();
  bool ended = false;
  const auto watched = [&](double t) {
    ended = go_on && !go_on(t);
    return !ended;
  };
  const double parts = std::ceil(1 / (grid.rate_Hz * options.longest_step_s));
  CondensedHistory out{.step_s = 1 / (grid.rate_Hz * parts), .change = std::numeric_limits<double>::infinity()};
  std::optional<TimeHistory> before;
  for (int i = 0; i <= options.most_halvings; ++i, out.step_s /= 2) {
    std::optional<TimeHistory> now;
    try {
      now = run(out.step_s * (1 + 1e-9), watched);
    } catch (const std::runtime_error&) {
      // A stop may want a shorter step; what grows at the shortest grows by itself.
      if (i == options.most_halvings) throw;
    }
    if (ended) {
      out.ended = true;
      if (before) out.step_s *= 2;
      out.history = std::move(before ? *before : now.value());
      return out;
    }
    if (before && now) {
      const Eigen::ArrayXd differences = RelativeDifferences(*before, *now, sensors);
      out.change = differences.size() == 0 ? 0 : differences.maxCoeff();
      if (out.change <= options.error || i == options.most_halvings) {
        out.history = std::move(*now);
        return out;
      }
    }
    before = std::move(now);
  }
  // Only the shortest step could be taken.
  out.step_s *= 2;
  out.change = std::numeric_limits<double>::infinity();
  out.history = std::move(*before);
  return out;
}

}  // namespace fourpost
