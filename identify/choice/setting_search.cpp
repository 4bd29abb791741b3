#include "identify/choice/setting_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

#include "identify/choice/findings.h"
#include "identify/search/dvhde.h"
#include "identify/search/run_search.h"

namespace fourpost {
namespace {

constexpr std::int64_t kSearchEvaluations = 20000;
constexpr int kStagnantGenerations = 60;

/// A setting that was evaluated at the fitted values. Less is better.
struct Rank {
  bool has_failed = false;
  double violation = 0;
  double cost = 0;

  auto operator<=>(const Rank&) const = default;
};

Rank RankOf(const SettableCar& car, const SettingScore& score, const SettingScore& present) {
  if (!score.IsGood()) return {.has_failed = true};
  return {.violation = Violation(car.settings->limits, score),
          .cost = Compromise(car.settings->objectives, score, present)};
}

Setting SettingOf(const Eigen::VectorXd& values) {
  Setting setting;
  for (const double value : values) setting.push_back(static_cast<int>(std::lround(value)));
  return setting;
}

/// The best ones, in their order; the present one is one of them.
PromisingSettings BestOf(const SettableCar& car, const std::vector<Setting>& settings, const std::vector<Rank>& ranks) {
  PromisingSettings promising{.settings = settings, .evaluated = static_cast<std::int64_t>(settings.size())};
  const Setting present = PresentSetting(car.settings->knobs);
  if (settings.size() > kMostDrawn) {
    promising.was_cut = true;
    std::vector<std::size_t> order(settings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
    order.resize(kMostDrawn);
    std::sort(order.begin(), order.end());
    promising.settings.clear();
    for (const std::size_t i : order) promising.settings.push_back(settings[i]);
  }
  std::vector<Setting>& kept = promising.settings;
  if (std::find(kept.begin(), kept.end(), present) == kept.end()) kept.push_back(present);
  return promising;
}

/// dvHDE over the positions of the knobs.
class LatticeSearch {
 public:
  LatticeSearch(const SettableCar& car, const std::vector<double>& fitted, const SettingScore& present)
      : car_(car), fitted_(fitted), present_(present) {}

  PromisingSettings Run(int threads, const WorkHooks& hooks) {
    Problem problem{.lattice = Lattice(Axes()),
                    .evaluate = ModelFunction([this](const Eigen::VectorXd& values) { return Evaluate(values); }),
                    .residual_count = 1};
    Archive archive(problem, threads);
    Dvhde method(archive.lattice(), {}, car_.settings->seed);
    const StopRules rules{.max_evaluations = kSearchEvaluations, .max_stagnant_generations = kStagnantGenerations};
    bool is_interrupted = false;
    const SearchHooks search_hooks{
        .progress =
            [&](const SearchGeneration& generation) {
              hooks.Show("choose: " + std::to_string(generation.paid) + " settings searched");
            },
        .stop = [&] { return is_interrupted = is_interrupted || hooks.IsStopped(); }};
    RunSearch(archive, method, rules, {}, search_hooks);
    std::vector<Setting> settings;
    std::vector<Rank> ranks;
    for (const auto& [setting, rank] : ranks_) {
      settings.push_back(setting);
      ranks.push_back(rank);
    }
    PromisingSettings promising = BestOf(car_, settings, ranks);
    promising.was_searched = true;
    promising.is_interrupted = is_interrupted;
    return promising;
  }

 private:
  std::vector<LatticeAxis> Axes() const {
    std::vector<LatticeAxis> axes;
    for (const Knob& knob : car_.settings->knobs)
      axes.push_back({knob.name, 0, static_cast<double>(knob.positions.size() - 1), 1});
    return axes;
  }

  Evaluation Evaluate(const Eigen::VectorXd& values) {
    const Setting setting = SettingOf(values);
    const SettingScore score = ScoreOf(car_, setting, fitted_);
    const Rank rank = RankOf(car_, score, present_);
    {
      const std::lock_guard lock(mutex_);
      ranks_.emplace(setting, rank);
    }
    if (rank.has_failed) return Failed(Failure::kException, score.failure);
    if (rank.violation > 0) return Infeasible(rank.violation, "beyond a limit");
    Evaluation evaluation;
    evaluation.residuals = Eigen::VectorXd::Constant(1, std::sqrt(rank.cost));
    return evaluation;
  }

  const SettableCar& car_;
  const std::vector<double>& fitted_;
  const SettingScore& present_;
  std::mutex mutex_;
  std::map<Setting, Rank> ranks_;
};

}  // namespace

PromisingSettings FindPromising(const SettableCar& car, const std::vector<double>& fitted, int threads,
                                const WorkHooks& hooks, std::int64_t most_enumerated) {
  const std::vector<Knob>& knobs = car.settings->knobs;
  const SettingScore present = ScoreOf(car, PresentSetting(knobs), fitted);
  if (!present.IsGood()) Refuse(kPresentWithoutRide, {car.settings->file.string()}, {present.failure});
  if (SettingCount(knobs) > most_enumerated) return LatticeSearch(car, fitted, present).Run(threads, hooks);
  const std::vector<Setting> all = AllSettings(knobs);
  // Few settings are all drawn anyway.
  if (all.size() <= kMostDrawn) return {.settings = all, .evaluated = static_cast<std::int64_t>(all.size())};
  const std::vector<SettingScore> scores = ScoresOf(car, all, fitted, threads, hooks);
  if (scores.empty()) return {.is_interrupted = true};
  std::vector<Rank> ranks;
  for (const SettingScore& score : scores) ranks.push_back(RankOf(car, score, present));
  return BestOf(car, all, ranks);
}

}  // namespace fourpost
