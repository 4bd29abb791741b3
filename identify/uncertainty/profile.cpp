#include "identify/uncertainty/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A point of one side: how far out it is in the fit variable, and where the others went.
struct Held {
  double distance = 0;
  double rise = 0;
  Eigen::VectorXd values;
};

class Profiler {
 public:
  Profiler(Archive& archive, const RefineResult& best, const Covariance& covariance, Eigen::Index index,
           const RefineOptions& options, const std::function<bool()>& stop)
      : archive_(archive),
        variables_(archive.lattice()),
        index_(index),
        options_(options),
        stop_(stop),
        centre_(variables_.FromValues(best.values)),
        cost_(best.cost),
        squared_inflation_(covariance.inflation * covariance.inflation) {
    options_.held = {index};
    profile_.name = archive.lattice().axes()[static_cast<std::size_t>(index)].name;
    profile_.threshold = covariance.reach_95 * covariance.reach_95;
    const double range = variables_.upper()[index] - variables_.lower()[index];
    const double reach = covariance.reach_95 * covariance.variable_sd[index];
    step_ = std::isfinite(reach) ? std::min(reach / 2, range / 4) : range / 8;
    profile_.points.push_back({best.values[index], 0});
    start_ = best.values;
  }

  Profile Run() {
    profile_.lower_95 = Side(-1);
    profile_.upper_95 = Side(1);
    const auto by_value = [](const ProfilePoint& a, const ProfilePoint& b) { return a.value < b.value; };
    std::sort(profile_.points.begin(), profile_.points.end(), by_value);
    return profile_;
  }

 private:
  double ValueAt(double signed_distance) const {
    Eigen::VectorXd x = centre_;
    x[index_] += signed_distance;
    return variables_.ToValues(x)[index_];
  }

  /// The others fitted from where they were at `from`; nothing where that fails or was stopped.
  std::optional<Held> FitAt(double direction, double distance, const Held& from) {
    Eigen::VectorXd start = from.values;
    start[index_] = ValueAt(direction * distance);
    const RefineResult run = Refine(archive_, start, options_, stop_);
    profile_.interrupted |= stop_ && stop_();
    if (!run.has_cost() || profile_.interrupted) return std::nullopt;
    const double rise = (run.cost - cost_) / squared_inflation_;
    // What a refinement may leave of the cost.
    profile_.found_better |= run.cost < cost_ * (1 - 10 * options_.cost_tolerance);
    profile_.points.push_back({run.values[index_], rise});
    return Held{distance, rise, run.values};
  }

  /// Where the rise passes the threshold on this side, in SI; infinite where it does not.
  double Side(double direction) {
    constexpr int kStepsAtMost = 24;
    const double bound = direction > 0 ? variables_.upper()[index_] : variables_.lower()[index_];
    const double room = std::abs(bound - centre_[index_]);
    Held inside{0, 0, start_};
    double step = step_;
    for (int k = 0; k < kStepsAtMost && inside.distance < room; ++k) {
      const std::optional<Held> next = FitAt(direction, std::min(inside.distance + step, room), inside);
      if (!next) return direction * kInfinite;
      if (next->rise >= profile_.threshold) return Crossing(direction, inside, *next);
      // Flat: further out the next time.
      if (next->rise < 0.25 * profile_.threshold * std::pow(static_cast<double>(k + 1) / 2, 2)) step *= 2;
      inside = *next;
    }
    return direction * kInfinite;
  }

  /// By the root of the rise, which is next to linear in the distance.
  double Crossing(double direction, Held inside, Held outside) {
    constexpr int kTriesAtMost = 6;
    const double wanted = std::sqrt(profile_.threshold);
    const auto root = [](const Held& held) { return std::sqrt(std::max(0.0, held.rise)); };
    double distance = 0;
    for (int k = 0; k < kTriesAtMost; ++k) {
      const double share = (wanted - root(inside)) / (root(outside) - root(inside));
      distance = inside.distance + share * (outside.distance - inside.distance);
      const std::optional<Held> between = FitAt(direction, distance, inside);
      if (!between) break;
      if (std::abs(root(*between) - wanted) < 0.01 * wanted) break;
      (between->rise < profile_.threshold ? inside : outside) = *between;
    }
    return ValueAt(direction * distance);
  }

  Archive& archive_;
  FitVariables variables_;
  Eigen::Index index_;
  RefineOptions options_;
  const std::function<bool()>& stop_;
  Eigen::VectorXd centre_;
  Eigen::VectorXd start_;
  double cost_;
  double squared_inflation_;
  /// In the fit variable.
  double step_ = 0;
  Profile profile_;
};

}  // namespace

Profile ProfileOf(Archive& archive, const RefineResult& best, const Covariance& covariance, Eigen::Index index,
                  const RefineOptions& options, const std::function<bool()>& stop) {
  return Profiler(archive, best, covariance, index, options, stop).Run();
}

}  // namespace fourpost
