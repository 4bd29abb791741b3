#include "identify/choice/setting_table.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "analysis/text/progress_text.h"
#include "identify/search/parallel.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Shows how far many evaluations are, from whichever thread.
class EvaluationProgress {
 public:
  EvaluationProgress(std::size_t count, const WorkHooks& hooks) : count_(count), hooks_(hooks) {}

  /// After each evaluation; false: it was interrupted.
  bool Count() {
    const std::lock_guard lock(mutex_);
    ++done_;
    is_stopped_ = is_stopped_ || hooks_.IsStopped();
    constexpr double kInterval_s = 0.1;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (seconds - shown_s_ >= kInterval_s) {
      shown_s_ = seconds;
      hooks_.Show("choose: " + std::to_string(done_) + " of " + std::to_string(count_) + " evaluations" +
                  TimeLeft(static_cast<double>(done_) / static_cast<double>(count_), seconds));
    }
    return !is_stopped_;
  }

  bool IsStopped() {
    const std::lock_guard lock(mutex_);
    return is_stopped_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t count_;
  const WorkHooks& hooks_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  double shown_s_ = 0;
  bool is_stopped_ = false;
  Clock::time_point start_ = Clock::now();
};

/// That a limit is given of, to compare excesses of unlike limits.
double SizeOf(const MetricLimit& limit) {
  const double size = std::max(std::abs(limit.most.value_or(0)), std::abs(limit.least.value_or(0)));
  return size > 0 ? size : 1;
}

}  // namespace

bool SettingScore::MeetsLimits() const {
  return std::all_of(margins.begin(), margins.end(), [](double margin) { return margin >= 0; });
}

SettingScore ScoreOf(const SettableCar& car, const Setting& setting, std::span<const double> fitted,
                     std::optional<Index> draw) {
  SettingScore score;
  try {
    const Eigen::MatrixXd metrics = car.metrics_of(ValuesAt(car.settings->knobs, setting, fitted, draw));
    const std::vector<double> weights = car.settings->RoadWeights();
    for (const Objective& objective : car.settings->objectives)
      score.objectives.push_back(OverRoads(metrics, objective.metric, weights));
    for (const MetricLimit& limit : car.settings->limits) {
      score.margins.push_back(LeastMargin(metrics, limit));
      // Such as the damping of a mode that this setting does not have.
      if (std::isnan(score.margins.back()))
        return {.failure = "it does not have what line " + std::to_string(limit.line) + " of the settings limits"};
    }
  } catch (const std::runtime_error& error) {
    return {.failure = error.what()};
  } catch (const std::invalid_argument& error) {
    return {.failure = error.what()};
  }
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(score.objectives.begin(), score.objectives.end(), is_finite)) score.failure = "not finite";
  return score;
}

double Compromise(const std::vector<Objective>& objectives, const SettingScore& score, const SettingScore& present) {
  double sum = 0;
  for (std::size_t o = 0; o < objectives.size(); ++o)
    sum += objectives[o].weight * score.objectives[o] / present.objectives[o];
  return sum;
}

double Violation(const std::vector<MetricLimit>& limits, const SettingScore& score) {
  double sum = 0;
  for (std::size_t l = 0; l < limits.size(); ++l) sum += std::max(0.0, -score.margins[l]) / SizeOf(limits[l]);
  return sum;
}

std::vector<SettingScore> ScoresOf(const SettableCar& car, const std::vector<Setting>& settings,
                                   std::span<const double> fitted, int threads, const WorkHooks& hooks) {
  std::vector<SettingScore> scores(settings.size());
  EvaluationProgress progress(settings.size(), hooks);
  ForEachInParallel(settings.size(), ThreadCount(threads), [&](std::size_t i) {
    if (progress.IsStopped()) return;
    scores[i] = ScoreOf(car, settings[i], fitted);
    progress.Count();
  });
  if (progress.IsStopped()) scores.clear();
  return scores;
}

SettingTable TableOf(const SettableCar& car, const std::vector<Setting>& settings, const Eigen::MatrixXd& draws,
                     int threads, const WorkHooks& hooks) {
  const auto rows = static_cast<Index>(settings.size());
  const Eigen::MatrixXd none = Eigen::MatrixXd::Constant(rows, draws.rows(), std::nan(""));
  SettingTable table{.settings = settings,
                     .objectives = std::vector<Eigen::MatrixXd>(car.settings->objectives.size(), none),
                     .margins = std::vector<Eigen::MatrixXd>(car.settings->limits.size(), none),
                     .failures = std::vector<std::string>(settings.size())};
  const auto count = settings.size() * static_cast<std::size_t>(draws.rows());
  EvaluationProgress progress(count, hooks);
  // One setting after the other in all cars: a setting's failure is written by one thread.
  ForEachInParallel(settings.size(), ThreadCount(threads), [&](std::size_t s) {
    for (Index d = 0; d < draws.rows() && !progress.IsStopped(); ++d) {
      const Eigen::VectorXd values = draws.row(d).transpose();
      const SettingScore score = ScoreOf(car, settings[s], {values.data(), static_cast<std::size_t>(values.size())}, d);
      progress.Count();
      if (!score.IsGood()) {
        if (table.failures[s].empty()) table.failures[s] = score.failure;
        continue;
      }
      for (std::size_t o = 0; o < score.objectives.size(); ++o)
        table.objectives[o](static_cast<Index>(s), d) = score.objectives[o];
      for (std::size_t l = 0; l < score.margins.size(); ++l)
        table.margins[l](static_cast<Index>(s), d) = score.margins[l];
    }
  });
  table.is_interrupted = progress.IsStopped();
  return table;
}

}  // namespace fourpost
